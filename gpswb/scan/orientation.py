# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which way round triangles run, and what hangs together."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import breadth_first_order, connected_components

from gpswb.core.mesh import BoolArray, IntArray, Mesh


def components(n: int, triangles: IntArray) -> IntArray:
    """(n,) number of the connected component of each vertex, across shared vertices."""
    ends = triangles[:, [[0, 1], [1, 2]]].reshape(-1, 2)
    graph = coo_array((np.ones(len(ends)), (ends[:, 0], ends[:, 1])), shape=(n, n))
    label: IntArray = connected_components(graph, directed=False)[1].astype(np.int64)
    return label


def flips(mesh: Mesh) -> tuple[BoolArray, int]:
    """Facets to turn round so that neighbours run alike and closed parts look outward.

    Neighbours are facets on a manifold edge. Each part that hangs together by them is made
    consistent along a spanning tree; then the whole part is turned if its signed volume, taken
    about its own centre, is negative: exact for a closed part, a guess for an open one.

    Returns:
        (m,) bool; the number of neighbours that still run against each other, as on a Möbius
        strip.
    """
    m = len(mesh.triangles)
    a, b = mesh.facet_pairs.T
    against = _runs_along(mesh, a) == _runs_along(mesh, b)
    graph = coo_array((np.ones(len(a)), (a, b)), shape=(m, m)).tocsr()
    count, part = connected_components(graph, directed=False)
    part = part.astype(np.int64)
    flip = np.zeros(m, dtype=bool)
    if against.any():
        flip = _along_trees(m, a, b, against, part, count)
    triangles = np.where(flip[:, None], mesh.triangles[:, ::-1], mesh.triangles)
    corner = mesh.vertices[triangles]
    size = np.maximum(np.bincount(part, minlength=count), 1)
    middle = np.column_stack(
        [np.bincount(part, mesh.centroids[:, k], minlength=count) / size for k in range(3)]
    )
    corner = corner - middle[part][:, None]
    volume = np.einsum("ij,ij->i", corner[:, 0], np.cross(corner[:, 1], corner[:, 2]))
    # A flat part has no volume but rounding: it stays as it is.
    flat = 1e-9 * np.bincount(part, mesh.areas, minlength=count) ** 1.5
    inward = np.bincount(part, volume, minlength=count) < -flat
    left = int((against ^ flip[a] ^ flip[b]).sum())
    return np.asarray(flip ^ inward[part]), left


def _runs_along(mesh: Mesh, facet: IntArray) -> BoolArray:
    """(e,) bool: the facet passes the shared edge from its smaller vertex to the larger one."""
    triangle = mesh.triangles[facet]
    first = triangle == mesh.pair_edges[:, :1]
    following = np.take_along_axis(triangle, (first.argmax(axis=1)[:, None] + 1) % 3, axis=1)
    return np.asarray(following[:, 0] == mesh.pair_edges[:, 1])


def _along_trees(
    m: int, a: IntArray, b: IntArray, against: BoolArray, part: IntArray, count: int
) -> BoolArray:
    """(m,) bool: facets that run against the first facet of their part."""
    # A root joined to one facet of each part makes one tree of them all.
    first = np.full(count, m, dtype=np.int64)
    np.minimum.at(first, part, np.arange(m))
    row = np.r_[a, np.full(count, m)]
    col = np.r_[b, first]
    weight = np.r_[np.where(against, 2.0, 1.0), np.ones(count)]
    graph = coo_array((weight, (row, col)), shape=(m + 1, m + 1)).tocsr()
    graph = (graph + graph.T).tocsr()
    order, before = breadth_first_order(graph, m, directed=False)
    flip = np.zeros(m + 1, dtype=bool)
    step = np.asarray(graph[before[order[1:]], order[1:]]).ravel() > 1.5
    for node, parent, turn in zip(
        order[1:].tolist(), before[order[1:]].tolist(), step.tolist(), strict=True
    ):
        flip[node] = flip[parent] ^ turn
    return flip[:m]
