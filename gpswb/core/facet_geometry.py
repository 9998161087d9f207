# SPDX-License-Identifier: LGPL-2.1-or-later
"""Areas, normals and centroids of facets, and the angles between them, block by block."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from gpswb.core.blocks import blocks

if TYPE_CHECKING:
    from gpswb.core.mesh import FloatArray, IntArray

ROUNDING = 8.0 * np.finfo(np.float64).eps
"""Share of the largest coordinate below which a facet's height is rounding: where an edge of the
mesh has a vertex in its middle, kernels close it with a facet of three corners in a line."""


def areas_and_normals(columns: FloatArray, triangles: IntArray) -> tuple[FloatArray, FloatArray]:
    """Area (m,) of each triangle, and its unit normal (m, 3), zero where there is no area.

    Args:
        columns: (3, n) coordinates of the vertices, axis by axis.
        triangles: (m, 3) int64.
    """
    least = ROUNDING * float(np.abs(columns).max(initial=0.0))
    areas, normals = np.empty(len(triangles)), np.empty((len(triangles), 3))
    for part in blocks(len(triangles)):
        corner = columns.take(triangles[part].T, axis=1)
        first, second = corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]
        cross = cross_product(first, second)
        length = np.sqrt(dot(cross, cross))
        flat = length <= least * np.sqrt(dot(first, first) + dot(second, second))
        areas[part] = np.where(flat, 0.0, 0.5 * length)
        length[flat] = np.inf
        np.divide(cross, length, out=normals[part].T)
    return areas, normals


def centroids(columns: FloatArray, triangles: IntArray) -> FloatArray:
    """Centroid (m, 3) of each triangle; arguments as in `areas_and_normals`."""
    found = np.empty((len(triangles), 3))
    for part in blocks(len(triangles)):
        found[part] = (columns.take(triangles[part].T, axis=1).sum(axis=1) / 3.0).T
    return found


def turning_angles(normals: FloatArray, pairs: IntArray) -> FloatArray:
    """Angle (e,) in [0, pi], rad, between the normals of each pair; 0 where a normal is zero.

    Args:
        normals: (m, 3) unit normals or zero.
        pairs: (e, 2) int64.
    """
    columns = np.ascontiguousarray(normals.T)
    angles = np.empty(len(pairs))
    for part in blocks(len(pairs)):
        both = columns.take(pairs[part].T, axis=1)
        first, second = both[:, 0], both[:, 1]
        cross = cross_product(first, second)
        np.arctan2(np.sqrt(dot(cross, cross)), dot(first, second), out=angles[part])
    return angles


def cross_product(a: FloatArray, b: FloatArray) -> FloatArray:
    """(3, ...) a x b of vectors that are stored axis by axis (numpy's own takes five times as
    long)."""
    out = np.empty(np.broadcast_shapes(a.shape, b.shape))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        np.multiply(a[j], b[k], out=out[i])
        out[i] -= a[k] * b[j]
    return out


def dot(a: FloatArray, b: FloatArray) -> FloatArray:
    """(...) a . b of vectors that are stored axis by axis."""
    product: FloatArray = a[0] * b[0]
    product += a[1] * b[1]
    product += a[2] * b[2]
    return product
