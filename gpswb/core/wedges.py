# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wedges: the fans of facets around a vertex between two creases.

A vertex on a sharp edge has one normal for each side of the edge. A wedge is one such side: the
corners (facet, vertex) that can be reached from one another around the vertex without crossing a
crease. Away from creases a vertex has exactly one wedge. Whatever is averaged "at a vertex"
(normals, curvature tensors) is averaged over wedges, so that nothing leaks across a feature edge.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from gpswb.core.half_edges import next_in_facet, single_sides
from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh


@dataclass(frozen=True, eq=False)
class Wedges:
    """The wedge of each corner of each facet.

    Args:
        of_corner: (m, 3) int wedge of each facet's corner.
        vertex: (w,) int vertex that each wedge belongs to.
    """

    of_corner: IntArray
    vertex: IntArray

    @property
    def count(self) -> int:
        """Number of wedges w."""
        return len(self.vertex)

    def sum_corners(self, values: FloatArray, facets: IntArray | slice = slice(None)) -> FloatArray:
        """Sum corner values (m, 3), or (k, 3) of some facets, over each wedge: (w,)."""
        total = np.bincount(self.of_corner[facets].ravel(), values.ravel(), self.count)
        return total.astype(np.float64, copy=False)


def find_wedges(mesh: Mesh, crease: BoolArray | None = None) -> Wedges:
    """Group the corners of a mesh into wedges.

    Args:
        mesh: the mesh.
        crease: (e,) bool aligned with ``mesh.facet_pairs``: edges that nothing is averaged across;
            ``None`` joins all corners of a vertex, whether its fan is closed or not.
    """
    n = len(mesh.vertices)
    if crease is None:
        return Wedges(mesh.triangles, np.arange(n, dtype=np.int64))
    corner_vertex = mesh.triangles.ravel()
    divided = _divided_vertices(mesh, crease)
    # Elsewhere the corners of a vertex are one wedge, and need no search (closed sheets that touch
    # in nothing but a vertex share it).
    corner = np.flatnonzero(divided[corner_vertex])
    number = np.full(3 * len(mesh.triangles), -1, dtype=np.int64)
    number[corner] = np.arange(len(corner))
    start, end = divided.take(mesh.pair_edges.T)
    near = np.flatnonzero((start | end) & ~crease)
    row, col = _joined_corners(mesh, near)
    kept = (number[row] >= 0) & (number[col] >= 0)
    row, col = number[row[kept]], number[col[kept]]
    graph = coo_matrix((np.ones(len(row), dtype=np.int8), (row, col)), (len(corner), len(corner)))
    count, label = connected_components(graph, directed=False)
    whole = np.zeros(n, dtype=bool)
    whole[corner_vertex] = True
    whole &= ~divided
    of_vertex = np.cumsum(whole) - 1
    of_corner = of_vertex[corner_vertex]
    of_corner[corner] = int(whole.sum()) + label
    vertex = np.concatenate([np.flatnonzero(whole), np.empty(count, dtype=np.int64)])
    vertex[of_corner[corner]] = corner_vertex[corner]
    return Wedges(of_corner.reshape(-1, 3), vertex)


def _divided_vertices(mesh: Mesh, crease: BoolArray) -> BoolArray:
    """(n,) vertices at a crease, or at a side without a single neighbour: they may have several
    wedges."""
    divided = np.zeros(len(mesh.vertices), dtype=bool)
    divided[mesh.pair_edges[crease]] = True
    half = single_sides(mesh)
    for end in (half, next_in_facet(half)):
        divided[mesh.triangles.ravel()[end]] = True
    return divided


def _joined_corners(mesh: Mesh, edges: IntArray) -> tuple[IntArray, IntArray]:
    """Corners that meet at either end of each edge, as two arrays."""
    first, second = mesh.half_edge_pairs[edges].T
    after, beyond = next_in_facet(first), next_in_facet(second)
    # Neighbours run along their edge in opposite directions, unless one is turned over.
    vertex = mesh.triangles.ravel()
    turned = vertex[first] == vertex[second]
    row = np.concatenate([first, after])
    col = np.concatenate([np.where(turned, second, beyond), np.where(turned, beyond, second)])
    return row, col
