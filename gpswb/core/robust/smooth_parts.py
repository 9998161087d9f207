# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces that join without a crease, told apart by the jumps of curvature along their borders."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components, minimum_spanning_tree

from gpswb.core.merging import merge_regions
from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.robust.curvature_jumps import curvature_jumps
from gpswb.core.robust.topology import FacetGraph

DISTINCT = 0.25
"""Relative jump at which an edge may be of a border; a border has some that aren't seen."""

BORDER = 0.35
"""Mean of a border's jumps from which there are two faces: B-spline faces, too, have lines inside
along which curvature jumps, by less than a third in those that were seen."""

CORE = 8
"""Facets from which a part between such edges is a face's, and not a gap between two borders."""

ROOT = 1e-9
"""Weight that ties cores together: less than any edge has, for an edge without weight is none."""


def smooth_parts(mesh: Mesh, graph: FacetGraph, joined: BoolArray) -> IntArray:
    """Parts of a mesh, divided where curvature jumps.

    Facets that no border edge touches, not even at an end, hang together in cores: that closes
    gaps in the borders. The others join a core across the least jumps (a watershed). Cores between
    which the border's jumps are small on average are of one face.

    Args:
        mesh: the mesh; nominal, see ``curvature_jumps``.
        graph: its adjacency.
        joined: (e,) pairs of facets that hang together smoothly.

    Returns:
        (m,) 0-based part of each facet, with gaps.
    """
    m = len(mesh.triangles)
    edges = np.flatnonzero(joined)
    inside = np.zeros((m, 3), dtype=bool)
    for side in (0, 1):
        facet, other = graph.pairs[edges, side], graph.pairs[edges, 1 - side]
        inside[facet] |= graph.neighbour[facet] == other[:, None]
    jump = np.minimum(curvature_jumps(mesh, graph, edges, inside), 1.0)
    touched = np.zeros(len(mesh.vertices), dtype=bool)
    touched[graph.pair_edges[edges[jump > DISTINCT]]] = True
    clear = joined.copy()
    clear[edges] = ~touched[graph.pair_edges[edges]].any(axis=1)
    core = graph.components(clear, m)
    is_core = np.bincount(core, minlength=m)[core] >= CORE
    label = _watershed(graph.pairs[edges], jump, np.where(is_core, core, -1))
    names, label = np.unique(label, return_inverse=True)
    length = np.linalg.norm(np.diff(mesh.vertices[graph.pair_edges[edges]], axis=1)[:, 0], axis=1)
    a, b = label[graph.pairs[edges]].T
    rule = _BorderJumps(a, b, jump, length)
    kept = merge_regions(len(names), np.column_stack([a, b])[a != b], rule, 1.0 - BORDER)
    return kept[label]


def _watershed(pairs: IntArray, height: FloatArray, core: IntArray) -> IntArray:
    """(m,) core that each facet is reached from over the lowest edges; where there is none, the
    number of one of the facets that hang together.

    Args:
        pairs: (k, 2) facets that hang together; ``height`` (k,) of the edge between them.
        core: (m,) core of each facet, -1 for none; cores are numbered below m.
    """
    m = len(core)
    node = np.where(core >= 0, core + m, np.arange(m))
    a, b = node[pairs].T
    root = 2 * m
    roots = np.unique(core[core >= 0]) + m
    row = np.concatenate([a[a != b], roots])
    column = np.concatenate([b[a != b], np.full(len(roots), root)])
    weight = np.concatenate([height[a != b] + 2.0 * ROOT, np.full(len(roots), ROOT)])
    lowest = np.lexsort((weight, column, row))
    # scipy's spanning tree takes 32-bit indices only.
    row, column = row[lowest].astype(np.int32), column[lowest].astype(np.int32)
    weight = weight[lowest]
    first = np.r_[True, (np.diff(row) != 0) | (np.diff(column) != 0)]
    links = coo_array((weight[first], (row[first], column[first])), shape=(root + 1, root + 1))
    tree = minimum_spanning_tree(links.tocsr()).tocoo()
    within = (tree.row != root) & (tree.col != root)
    forest = coo_array(
        (np.ones(within.sum()), (tree.row[within], tree.col[within])), shape=links.shape
    )
    tree_of = connected_components(forest, directed=False)[1]
    name = np.full(root + 1, m, dtype=np.int64)
    np.minimum.at(name, tree_of[:m], np.arange(m))
    np.minimum.at(name, tree_of[node], np.arange(m))
    label: IntArray = name[tree_of[node]]
    return label


class _BorderJumps:
    """Likeness of regions: 1 less the mean jump along their common border (a ``MergeRule``)."""

    def __init__(self, a: IntArray, b: IntArray, jump: FloatArray, length: FloatArray) -> None:
        self._sum: dict[int, dict[int, FloatArray]] = {}
        for first, second, value in zip(
            a.tolist(), b.tolist(), np.column_stack([jump * length, length]), strict=True
        ):
            if first != second:
                self._add(first, second, value)
                self._add(second, first, value)

    def score(self, first: IntArray, second: IntArray) -> FloatArray:
        total = np.array(
            [self._sum[a][b] for a, b in zip(first.tolist(), second.tolist(), strict=True)]
        )
        likeness: FloatArray = 1.0 - total[:, 0] / np.maximum(total[:, 1], 1e-300)
        return likeness

    def join(self, kept: int, gone: int) -> None:
        for other, value in self._sum.pop(gone).items():
            del self._sum[other][gone]
            if other != kept:
                self._add(kept, other, value)
                self._add(other, kept, value)

    def _add(self, first: int, second: int, value: FloatArray) -> None:
        row = self._sum.setdefault(first, {})
        row[second] = row[second] + value if second in row else value
