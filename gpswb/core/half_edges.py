# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which sides of triangles coincide.

Half-edge 3 f + k is the side of facet f from its corner k to the next; it also stands for that
corner.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from gpswb.core.mesh import IntArray, Mesh


def interior_edges(triangles: IntArray, vertex_count: int) -> tuple[IntArray, IntArray]:
    """The edges that exactly two facets share, in the order of their vertices.

    An edge of three or more facets has no single neighbour across it: it is left as a border, like
    an edge of one.

    Args:
        triangles: (m, 3) int64.
        vertex_count: number of vertices.

    Returns:
        (e, 2) int64 half-edges of each edge, and (e, 2) int64 its vertices, the lower first.
    """
    end = np.empty_like(triangles)
    end[:, :2], end[:, 2] = triangles[:, 1:], triangles[:, 0]
    count = np.int64(max(vertex_count, 1))
    start, end = triangles.ravel(), end.ravel()
    key, half = _sorted_with_places(np.minimum(start, end) * count + np.maximum(start, end))
    alike = np.zeros(len(key) + 1, dtype=bool)
    np.equal(key[1:], key[:-1], out=alike[1:-1])
    # Alike to the next, but neither is the one before nor the one after that.
    first = np.flatnonzero(alike[1:-1] & ~alike[:-2] & ~alike[2:]) if len(key) else key
    key, a, b = key[first], half[first], half[first + 1]
    low = key // count
    return (
        np.stack([np.minimum(a, b), np.maximum(a, b)], axis=1),
        np.stack([low, key - low * count], axis=1),
    )


def _sorted_with_places(key: IntArray) -> tuple[IntArray, IntArray]:
    """Keys (k,), at least 0, in ascending order, and where each one was.

    Where key and place fit one integer together, these are sorted: in half the time of argsort.
    """
    bits = len(key).bit_length()
    if int(key.max(initial=0)).bit_length() + bits > 63:
        order = np.argsort(key)
        return key[order], order
    both = (key << bits) | np.arange(len(key))
    both.sort()
    return both >> bits, both & ((1 << bits) - 1)


def single_sides(mesh: Mesh) -> IntArray:
    """Half-edges of the edges that not exactly two facets share, ascending."""
    count = 3 * len(mesh.triangles)
    if 2 * len(mesh.half_edge_pairs) == count:
        return np.empty(0, dtype=np.int64)
    single = np.ones(count, dtype=bool)
    single[mesh.half_edge_pairs] = False
    return np.flatnonzero(single)


def next_in_facet(half_edge: IntArray) -> IntArray:
    """The half-edge (or corner) that follows each one around its facet."""
    following: IntArray = half_edge + 1
    following -= 3 * (following // 3 - half_edge // 3)
    return following
