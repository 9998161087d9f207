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

    def sum_corners(self, values: FloatArray) -> FloatArray:
        """Sum corner values (m, 3, ...) over each wedge: (w, ...)."""
        index = self.of_corner.ravel()
        flat = values.reshape(index.size, -1)
        columns = [
            np.bincount(index, weights=flat[:, k], minlength=self.count)
            for k in range(flat.shape[1])
        ]
        return np.stack(columns, axis=1).reshape((self.count, *values.shape[2:]))


def find_wedges(mesh: Mesh, crease: BoolArray | None = None) -> Wedges:
    """Group the corners of a mesh into wedges.

    Args:
        mesh: the mesh.
        crease: (e,) bool aligned with ``mesh.facet_pairs``: edges that nothing is averaged across;
            ``None`` joins all corners of a vertex, whether its fan is closed or not.
    """
    m = len(mesh.triangles)
    if crease is None:
        return Wedges(mesh.triangles, np.arange(len(mesh.vertices), dtype=np.int64))
    keep = ~crease
    pairs, ends = mesh.facet_pairs[keep], mesh.pair_edges[keep]
    first = [_corner_index(mesh, pairs[:, 0], ends[:, k]) for k in (0, 1)]
    second = [_corner_index(mesh, pairs[:, 1], ends[:, k]) for k in (0, 1)]
    row, col = np.concatenate(first), np.concatenate(second)
    graph = coo_matrix((np.ones(len(row), dtype=np.int8), (row, col)), shape=(3 * m, 3 * m))
    count, label = connected_components(graph, directed=False)
    label = label.astype(np.int64)
    vertex = np.empty(count, dtype=np.int64)
    vertex[label] = mesh.triangles.ravel()
    return Wedges(label.reshape(m, 3), vertex)


def _corner_index(mesh: Mesh, facet: IntArray, vertex: IntArray) -> IntArray:
    """Flat index 3 f + k of the corner of each facet that lies at the given vertex."""
    local = np.argmax(mesh.triangles[facet] == vertex[:, None], axis=1)
    index: IntArray = 3 * facet + local
    return index
