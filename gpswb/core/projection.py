# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labels of vertices on facets, and of facets on vertices."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import dijkstra

from gpswb.core.growing import grow_regions, number_by_first
from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh


def facets_from_vertices(labels: IntArray, triangles: IntArray, yields: BoolArray) -> IntArray:
    """Label of each facet: the majority of its vertices, where yielding vertices count only if all
    do.

    Args:
        labels: (n,) int label of each vertex.
        triangles: (m, 3) int.
        yields: (n,) bool vertices that give way (those on sharp edges).

    Returns:
        (m,) int64. Among three different labels the first corner that does not yield decides.
    """
    corner = labels[triangles]
    firm = ~yields[triangles]
    votes = np.stack(
        [((corner == corner[:, [k]]) & firm).sum(axis=1) * firm[:, k] for k in range(3)], axis=1
    )
    best = np.argmax(votes, axis=1)
    chosen: IntArray = corner[np.arange(len(triangles)), best]
    return chosen


def vertices_from_facets(
    labels: IntArray, mesh: Mesh, weights: FloatArray | None = None
) -> IntArray:
    """Label of each vertex: the one with the largest area among its facets.

    Args:
        labels: (m,) int label of each facet.
        mesh: the mesh.
        weights: (m,) weight of each facet; its area if not given.

    Returns:
        (n,) int64; the smallest label at vertices of no facet.
    """
    n = len(mesh.vertices)
    if not len(labels):
        return np.zeros(n, dtype=np.int64)
    weight = mesh.areas if weights is None else weights
    low = int(labels.min())
    result = np.full(n, low, dtype=np.int64)
    for k in range(3):
        result[mesh.triangles[:, k]] = labels
    # Most vertices have one label only; the areas of the others' labels are added up.
    corner = result[mesh.triangles]
    mixed = np.zeros(n, dtype=bool)
    mixed[mesh.triangles[corner != labels[:, None]]] = True
    facet, side = np.nonzero(mixed[mesh.triangles])
    vertex = mesh.triangles[facet, side]
    span = int(labels.max()) - low + 1
    key, inverse = np.unique(vertex * span + labels[facet] - low, return_inverse=True)
    total = np.bincount(inverse.ravel(), weights=weight[facet])
    # Sorted by vertex, then by weight: the last entry of each vertex wins, the smaller label on a
    # tie.
    order = np.lexsort((-(key % span), total, key // span))
    result[key[order] // span] = key[order] % span + low
    return result


def fill_facets(label: IntArray, mesh: Mesh) -> IntArray:
    """Give facets without label (-1) that of the facet that is reached with the least turning.

    Connected facets that no label reaches get new labels, one for each component.

    Args:
        label: (m,) int, -1 for none.
        mesh: the mesh.
    """
    label = label.copy()
    seeds = np.flatnonzero(label >= 0)
    if 0 < len(seeds) < len(label):
        # A step costs little beside a turn, so that labels run along surfaces first.
        cost = 1e-3 + mesh.turning
        row, col = mesh.facet_pairs.T
        graph = coo_matrix((cost, (row, col)), shape=(len(label), len(label))).tocsr()
        _, _, source = dijkstra(
            graph, directed=False, indices=seeds, min_only=True, return_predecessors=True
        )
        label = np.where(source >= 0, label[np.maximum(source, 0)], -1)
    left = label < 0
    component, _ = grow_regions(left.astype(np.int64), mesh.facet_pairs)
    return np.where(left, component + label.max(initial=-1) + 1, label)


def number_facet_regions(label: IntArray, mesh: Mesh) -> tuple[IntArray, int]:
    """Number labels 0, 1, ... by first facet; also how many there are.

    Facets without area get -1, and those of label -1 keep it.
    """
    region = np.full(len(label), -1, dtype=np.int64)
    solid = (mesh.areas > 0.0) & (label >= 0)
    region[solid], count = number_by_first(label[solid])
    return region, count
