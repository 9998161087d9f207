# SPDX-License-Identifier: LGPL-2.1-or-later
"""Connected parts of a mesh, halved again and again: where one surface can be expected."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import BoolArray, IntArray, Mesh
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


def halves(mesh: Mesh, part: IntArray) -> IntArray:
    """Divide each part in two across its longest extent.

    Args:
        mesh: the mesh.
        part: (m,) 0-based part of each facet, -1 for none.

    Returns:
        (m,) 0-based half, twice as many as parts, -1 where the part is.
    """
    facets = np.flatnonzero(part >= 0)
    label = part[facets]
    count = np.maximum(np.bincount(label), 1)
    x = mesh.centroids[facets]
    mean = np.stack([np.bincount(label, x[:, i]) for i in range(3)], axis=1) / count[:, None]
    x = x - mean[label]
    moment = np.empty((len(count), 3, 3))
    for i in range(3):
        for j in range(i, 3):
            moment[:, i, j] = moment[:, j, i] = np.bincount(label, x[:, i] * x[:, j])
    longest = np.linalg.eigh(moment)[1][:, :, 2]
    side = np.einsum("fk,fk->f", x, longest[label]) > 0.0
    half = np.full(len(part), -1, dtype=np.int64)
    half[facets] = 2 * label + side
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
