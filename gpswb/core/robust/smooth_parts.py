# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces that join without a crease, told apart by the jumps of curvature along their borders."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components, minimum_spanning_tree

from gpswb.core.facet_edges import edge_lengths
from gpswb.core.merging import merge_regions
from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.robust.curvature_jumps import BORDER
from gpswb.core.robust.jump_memory import JumpMemory
from gpswb.core.robust.topology import FacetGraph

DISTINCT = 0.25
"""Relative jump at which an edge may be of a border; a border has some that aren't seen."""

CORE = 8
"""Facets from which a part between such edges is a face's, and not a gap between two borders."""

ROOT = 1e-9
"""Weight that ties cores together: less than any edge has, for an edge without weight is none."""


def smooth_parts(
    mesh: Mesh, graph: FacetGraph, joined: BoolArray, jumps: JumpMemory
) -> tuple[IntArray, BoolArray]:
    """Parts of a mesh, divided where curvature jumps.

    Facets that no border edge touches, not even at an end, hang together in cores: that closes
    gaps in the borders. The others join a core across the least jumps (a watershed). Cores between
    which the border's jumps are small on average are of one face.

    Args:
        mesh: the mesh; nominal, see ``curvature_jumps``.
        graph: its adjacency.
        joined: (e,) pairs of facets that hang together smoothly.
        jumps: the jumps of curvature that are known.

    Returns:
        (m,) 0-based part of each facet, with gaps, and (e,) pairs of ``joined`` across which
        curvature is seen not to jump.
    """
    m = len(mesh.triangles)
    edges = np.flatnonzero(joined)
    jump, none = jumps.across(joined)
    jump = np.minimum(jump, 1.0)
    seen = np.zeros(len(joined), dtype=bool)
    seen[edges] = none
    touched = np.zeros(len(mesh.vertices), dtype=bool)
    touched[graph.pair_edges[edges[jump > DISTINCT]]] = True
    clear = joined.copy()
    clear[edges] = ~touched[graph.pair_edges[edges]].any(axis=1)
    core = graph.components(clear, m)
    is_core = np.bincount(core, minlength=m)[core] >= CORE
    label = _watershed(graph.pairs[edges], jump, np.where(is_core, core, -1))
    count = int(label.max(initial=-1)) + 1
    ends = label[graph.pairs[edges]]
    rule = _BorderJumps(ends, jump, edge_lengths(mesh, edges), count)
    kept = merge_regions(count, ends, rule, 1.0 - BORDER)
    return kept[label], seen


def _watershed(pairs: IntArray, height: FloatArray, core: IntArray) -> IntArray:
    """(m,) 0-based basin of each facet: a core, and what is reached from it over the lowest edges;
    where there is no core, what hangs together.

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
    basin = connected_components(forest, directed=False)[1][node]
    label: IntArray = np.unique(basin, return_inverse=True)[1].reshape(-1)
    return label


class _BorderJumps:
    """Likeness of regions: 1 less the mean jump along their common border (a ``MergeRule``)."""

    def __init__(self, ends: IntArray, jump: FloatArray, length: FloatArray, count: int) -> None:
        self._ends = ends  # (k, 2) regions on either side of each edge
        self._jump, self._length = jump * length, length
        self._count = count

    def score(self, first: IntArray, second: IntArray) -> FloatArray:
        low, high = self._ends.min(axis=1), self._ends.max(axis=1)
        border, which = np.unique(low * self._count + high, return_inverse=True)
        mean = np.bincount(which, self._jump) / np.maximum(np.bincount(which, self._length), 1e-300)
        asked = np.minimum(first, second) * self._count + np.maximum(first, second)
        likeness: FloatArray = 1.0 - mean[np.searchsorted(border, asked)]
        return likeness

    def join(self, kept: IntArray, gone: IntArray) -> None:
        now = np.arange(self._count)
        now[gone] = kept
        self._ends = now[self._ends]
