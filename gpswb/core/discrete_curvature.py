# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curvature at vertices by discretised operators (Meyer et al. 2003), as the paper says (section
4)."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import BoolArray, FloatArray, Mesh


def discrete_curvatures(mesh: Mesh, normals: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Principal curvatures from angle defects and the cotangent Laplacian.

    K = (2 pi - sum of angles) / A and 2 H n = sum (cot a + cot b)(x_i - x_j) / (2 A) with mixed
    Voronoi areas A. Nothing stops at a sharp edge: that is how the print finds them.

    Args:
        mesh: the mesh.
        normals: (n, 3) unit vertex normals, which give H its sign.

    Returns:
        k_max, k_min (n,), 1/mm, positive where outward convex; 0 at vertices of no facet. At the
        border of an open mesh the defect is counted from pi.
    """
    n = len(mesh.vertices)
    corners, index = mesh.corners, mesh.triangles
    # Edge k lies opposite corner k.
    edges = np.roll(corners, -2, axis=1) - np.roll(corners, -1, axis=1)
    squared = np.einsum("fki,fki->fk", edges, edges)
    dots = -np.einsum("fki,fki->fk", np.roll(edges, -1, axis=1), np.roll(edges, -2, axis=1))
    double = 2.0 * np.maximum(mesh.areas, 1e-300)[:, None]
    solid = (mesh.areas > 0.0)[:, None]
    cotangent = np.where(solid, dots / double, 0.0)
    angle = np.where(solid, np.arctan2(double, dots), 0.0)
    share = squared * cotangent
    voronoi = (np.roll(share, -1, axis=1) + np.roll(share, 1, axis=1)) / 8.0
    obtuse: BoolArray = angle > np.pi / 2.0
    quarter, half = mesh.areas[:, None] / 4.0, mesh.areas[:, None] / 2.0
    blunt = obtuse.any(axis=1, keepdims=True)
    mixed = np.where(blunt, np.where(obtuse, half, quarter), voronoi)
    area = np.bincount(index.ravel(), weights=mixed.ravel(), minlength=n)
    angles = np.bincount(index.ravel(), weights=angle.ravel(), minlength=n)
    laplacian = np.zeros((n, 3))
    for k in range(3):
        # Edge k runs from corner k+1 to corner k+2.
        start, end = index[:, (k + 1) % 3], index[:, (k + 2) % 3]
        pull = cotangent[:, [k]] * edges[:, k]
        for axis in range(3):
            laplacian[:, axis] -= np.bincount(start, weights=pull[:, axis], minlength=n)
            laplacian[:, axis] += np.bincount(end, weights=pull[:, axis], minlength=n)
    used = area > 0.0
    safe = np.where(used, area, 1.0)
    mean = np.where(used, np.einsum("ni,ni->n", laplacian, normals) / (4.0 * safe), 0.0)
    full = np.where(_on_border(mesh), np.pi, 2.0 * np.pi)
    gauss = np.where(used, (full - angles) / safe, 0.0)
    root = np.sqrt(np.maximum(mean**2 - gauss, 0.0))
    return mean + root, mean - root


def _on_border(mesh: Mesh) -> BoolArray:
    """(n,) bool vertices with an edge of a single facet: more edge ends than paired ones."""
    n = len(mesh.vertices)
    ends = 2 * np.bincount(mesh.triangles.ravel(), minlength=n)
    paired = 2 * np.bincount(mesh.pair_edges.ravel(), minlength=n)
    border: BoolArray = ends != paired
    return border
