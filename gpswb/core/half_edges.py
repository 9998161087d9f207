# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which sides of triangles coincide.

Half-edge 3 f + k is the side of facet f from its corner k to the next; it also stands for that
corner.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from gpswb.core.mesh import IntArray


def paired_half_edges(triangles: IntArray, vertex_count: int) -> IntArray:
    """Half-edges of each edge that exactly two facets share.

    An edge of three or more facets has no single neighbour across it: it is left as a border, like
    an edge of one.

    Args:
        triangles: (m, 3) int64.
        vertex_count: number of vertices.

    Returns:
        (e, 2) int64, the lower half-edge first, in the order of the edges' vertices.
    """
    start, end = triangles.ravel(), triangles[:, [1, 2, 0]].ravel()
    key = np.minimum(start, end) * np.int64(max(vertex_count, 1)) + np.maximum(start, end)
    order = np.argsort(key)
    key = key[order]
    alike = np.zeros(len(key) + 1, dtype=bool)
    np.equal(key[1:], key[:-1], out=alike[1:-1])
    # Alike to the next, but neither is the one before nor the one after that.
    first = np.flatnonzero(alike[1:-1] & ~alike[:-2] & ~alike[2:]) if len(key) else key
    a, b = order[first], order[first + 1]
    return np.column_stack([np.minimum(a, b), np.maximum(a, b)])


def next_in_facet(half_edge: IntArray) -> IntArray:
    """The half-edge (or corner) that follows each one around its facet."""
    following: IntArray = half_edge + np.where(half_edge % 3 == 2, -2, 1)
    return following
