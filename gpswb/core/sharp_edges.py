# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sharp edges: by curvedness as printed (paper, equations 6 and 7), and by dihedral angle."""

from __future__ import annotations

import numpy as np

from gpswb.core.facet_edges import facet_edges
from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.tolerances import Tolerances


def sharp_vertices_by_curvedness(curvedness: FloatArray, coefficient: float = 1.0) -> BoolArray:
    """Vertices on sharp edges as printed: c - c_min > lambda (c_max + c_min) / 2.

    The largest curvedness comes from the shortest edge of the mesh, so edges whose facets are wider
    fall below the threshold and are missed: a defect of the print that is kept here.

    Args:
        curvedness: (n,) curvedness of each vertex, 1/mm.
        coefficient: lambda of equation (7).

    Returns:
        (n,) bool.
    """
    if not len(curvedness):
        return np.zeros(0, dtype=bool)
    low, high = float(curvedness.min()), float(curvedness.max())
    sharp: BoolArray = curvedness - low > coefficient * (high + low) / 2.0
    return sharp


def turning_angles(mesh: Mesh) -> FloatArray:
    """Angle between the normals of the two facets at each interior edge.

    Returns:
        (e,) float64 in [0, pi], rad, aligned with ``mesh.facet_pairs``; 0 beside a degenerate
        facet.
    """
    first = mesh.facet_normals[mesh.facet_pairs[:, 0]]
    second = mesh.facet_normals[mesh.facet_pairs[:, 1]]
    sine = np.linalg.norm(np.cross(first, second), axis=1)
    angle: FloatArray = np.arctan2(sine, np.einsum("ij,ij->i", first, second))
    degenerate = (mesh.areas[mesh.facet_pairs] <= 0.0).any(axis=1)
    angle[degenerate] = 0.0
    return angle


def feature_edges(mesh: Mesh, tolerances: Tolerances | None = None) -> BoolArray:
    """Edges that turn further than the smooth surface beside them (design, section 5).

    The curvature on each side of an edge is taken from the edges of the facets around that share no
    vertex with it; a chord of that surface turns by half of each side's curvature times the width
    of its facet. An edge that turns much further than that, and than most edges around, is a
    feature edge.

    Args:
        mesh: the mesh.
        tolerances: thresholds; the defaults if not given.

    Returns:
        (e,) bool aligned with ``mesh.facet_pairs``.
    """
    tol = tolerances or Tolerances()
    angle = turning_angles(mesh)
    sharp: BoolArray = angle > tol.always_sharp
    doubtful = np.flatnonzero((angle > tol.never_sharp) & ~sharp)
    if not len(doubtful):
        return sharp
    height = _heights(mesh)
    rate = np.where(sharp, 0.0, angle / np.maximum(height.min(axis=1), 1e-300))
    edge_of, beyond = facet_edges(mesh)
    expected = np.zeros(len(doubtful))
    nearby = np.full((len(doubtful), 18), np.nan)
    for side in (0, 1):
        facet = mesh.facet_pairs[doubtful, side]
        around = beyond[facet]  # (d, 3) facets across each edge of the facet; -1 at a border
        candidates = edge_of[around].reshape(len(doubtful), 9)
        candidates[np.repeat(around < 0, 3, axis=1)] = -1
        # The facet beyond the edge itself lies on the other side.
        opposite = mesh.facet_pairs[doubtful, 1 - side]
        candidates[np.repeat(around == opposite[:, None], 3, axis=1)] = -1
        expected += 0.5 * height[doubtful, side] * _largest_apart(mesh, rate, doubtful, candidates)
        usable = (candidates >= 0) & (candidates != doubtful[:, None])
        nearby[:, 9 * side : 9 * side + 9] = np.where(usable, angle[candidates], np.nan)
    # Most edges around a crease are none: their median is how rough the surface is.
    rough = np.nan_to_num(_row_medians(nearby))
    threshold = tol.sharp_factor * (expected + rough) + tol.never_sharp
    sharp[doubtful] = angle[doubtful] > threshold
    return sharp


def _row_medians(values: FloatArray) -> FloatArray:
    """Lower median of each row, NaN left out; NaN for a row of NaN."""
    ordered = np.sort(values, axis=1)
    count = np.isfinite(ordered).sum(axis=1)
    median: FloatArray = ordered[np.arange(len(values)), np.maximum(count - 1, 0) // 2]
    return median


def _largest_apart(
    mesh: Mesh, rate: FloatArray, edge: IntArray, candidates: IntArray
) -> FloatArray:
    """Largest rate among candidate edges that share no vertex with the edge; 0 if there is none."""
    ends = mesh.pair_edges
    touching = (ends[candidates][:, :, :, None] == ends[edge][:, None, None, :]).any(axis=(2, 3))
    value = np.where(touching | (candidates < 0), 0.0, rate[candidates])
    largest: FloatArray = value.max(axis=1)
    return largest


def _heights(mesh: Mesh) -> FloatArray:
    """(e, 2) height of each of an edge's facets over the edge, mm."""
    ends = mesh.vertices[mesh.pair_edges]
    length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    height: FloatArray = 2.0 * mesh.areas[mesh.facet_pairs] / np.maximum(length, 1e-300)[:, None]
    return height
