# SPDX-License-Identifier: LGPL-2.1-or-later
"""Connected parts of a mesh, halved again and again: where one surface can be expected."""

from __future__ import annotations

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components, dijkstra

from gpswb.core.mesh import IntArray


def connected_parts(group: IntArray, links: IntArray) -> IntArray:
    """Connected pieces of groups of facets.

    Args:
        group: (m,) group of each facet, -1 for none.
        links: (k, 2) facets that hang together if they are of one group.

    Returns:
        (m,) 0-based part of each facet, -1 where the group is.
    """
    facets, inside = _within(group, links)
    part = np.full(len(group), -1, dtype=np.int64)
    part[facets] = connected_components(inside, directed=False)[1]
    return part


def halves(part: IntArray, links: IntArray) -> IntArray:
    """Divide each part in two by the steps from facet to facet from one of its ends.

    Steps follow the surface and the strips of a coarse mesh, whose facets' centroids lie on either
    side of any plane.

    Args:
        part: (m,) 0-based connected part of each facet, -1 for none.
        links: (k, 2) facets that hang together if they are of one part.

    Returns:
        (m,) 0-based half, twice as many as parts, -1 where the part is.
    """
    half = np.full(len(part), -1, dtype=np.int64)
    facets, inside = _within(part, links)
    if not len(facets):
        return half
    label = part[facets]
    order = np.argsort(label, kind="stable")
    count = np.bincount(label)
    ends = order[np.cumsum(count)[count > 0] - 1]
    for _ in range(2):  # the far end from anywhere is an end, and so is the far end from there
        steps = dijkstra(inside, directed=False, indices=ends, unweighted=True, min_only=True)
        order = np.lexsort((steps, label))
        ends = order[np.cumsum(count)[count > 0] - 1]
    rank = np.empty(len(facets), dtype=np.int64)
    rank[order] = np.arange(len(facets))
    start = np.cumsum(count) - count
    half[facets] = 2 * label + (2 * (rank - start[label]) >= count[label])
    return half


def _within(group: IntArray, links: IntArray) -> tuple[IntArray, csr_array]:
    """The facets of groups (-1 for none), and which of them are linked to one of their group."""
    facets = np.flatnonzero(group >= 0)
    number = np.empty(len(group), dtype=np.int32)
    number[facets] = np.arange(len(facets), dtype=np.int32)
    first, second = group[links.T]
    row, column = number[links[(first == second) & (first >= 0)].T]
    ones = np.ones(len(row), dtype=np.int8)
    return facets, csr_array((ones, (row, column)), shape=(len(facets), len(facets)))


def spread_over(part: IntArray, most: int) -> tuple[IntArray, IntArray]:
    """At most so many facets of each part, evenly spaced in their order.

    Args:
        part: (m,) 0-based part of each facet, -1 for none.
        most: facets of a part at most.

    Returns:
        (k, most) facets of the k parts, -1 for padding, and (k,) number of facets of each part.
    """
    facets = np.flatnonzero(part >= 0)
    order = facets[np.argsort(part[facets], kind="stable")]
    size = np.bincount(part[facets])
    start = np.cumsum(size) - size
    slot = np.arange(min(most, int(size.max(initial=1))))
    taken = np.minimum(size, len(slot))
    pick = start[:, None] + slot * size[:, None] // np.maximum(taken, 1)[:, None]
    present = slot < taken[:, None]
    chosen = np.where(present, order[np.where(present, pick, 0)], -1)
    return chosen, size
