# SPDX-License-Identifier: LGPL-2.1-or-later
"""Connected parts of a mesh, halved again and again: where one surface can be expected."""

from __future__ import annotations

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import dijkstra

from gpswb.core.mesh import BoolArray, IntArray
from gpswb.core.robust.topology import FacetGraph


def connected_parts(graph: FacetGraph, group: IntArray, smooth: BoolArray) -> IntArray:
    """Connected pieces of groups of facets.

    Args:
        graph: the adjacency.
        group: (m,) group of each facet, -1 for none.
        smooth: (e,) pairs across which facets hang together if they are of one group.

    Returns:
        (m,) 0-based part of each facet, -1 where the group is.
    """
    a, b = graph.pairs.T
    joined = smooth & (group[a] == group[b]) & (group[a] >= 0)
    label = graph.components(joined, len(group))
    part = np.full(len(group), -1, dtype=np.int64)
    inside = group >= 0
    part[inside] = np.unique(label[inside], return_inverse=True)[1].reshape(-1)
    return part


def halves(graph: FacetGraph, part: IntArray, smooth: BoolArray) -> IntArray:
    """Divide each part in two by the steps from facet to facet from one of its ends.

    Steps follow the surface and the strips of a coarse mesh, whose facets' centroids lie on either
    side of any plane.

    Args:
        graph: the adjacency.
        part: (m,) 0-based connected part of each facet, -1 for none.
        smooth: (e,) pairs across which facets hang together if they are of one part.

    Returns:
        (m,) 0-based half, twice as many as parts, -1 where the part is.
    """
    facets = np.flatnonzero(part >= 0)
    half = np.full(len(part), -1, dtype=np.int64)
    if not len(facets):
        return half
    label = part[facets]
    number = np.full(len(part), -1, dtype=np.int64)
    number[facets] = np.arange(len(facets))
    a, b = graph.pairs[smooth & (part[graph.pairs[:, 0]] == part[graph.pairs[:, 1]])].T
    inside = part[a] >= 0
    row, column = number[a[inside]], number[b[inside]]
    links = csr_array(
        (np.ones(len(row), dtype=np.int8), (row, column)), shape=(len(facets), len(facets))
    )
    order = np.argsort(label, kind="stable")
    count = np.bincount(label)
    ends = order[np.cumsum(count)[count > 0] - 1]
    for _ in range(2):  # the far end from anywhere is an end, and so is the far end from there
        steps = dijkstra(links, directed=False, indices=ends, unweighted=True, min_only=True)
        order = np.lexsort((steps, label))
        ends = order[np.cumsum(count)[count > 0] - 1]
    rank = np.empty(len(facets), dtype=np.int64)
    rank[order] = np.arange(len(facets))
    start = np.cumsum(count) - count
    half[facets] = 2 * label + (2 * (rank - start[label]) >= count[label])
    return half


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
