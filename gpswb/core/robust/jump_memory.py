# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jumps of curvature that need not be sought again where nothing has changed around an edge."""

from __future__ import annotations

import numpy as np

from gpswb.core.distinct import distinct
from gpswb.core.mesh import BoolArray, FloatArray, Mesh
from gpswb.core.robust.curvature_jumps import RINGS, curvature_jumps
from gpswb.core.robust.topology import FacetGraph


class JumpMemory:
    """The jumps across the edges of one mesh that was asked about last.

    Args:
        mesh: the mesh; nominal, see ``curvature_jumps``.
        graph: its adjacency.
    """

    def __init__(self, mesh: Mesh, graph: FacetGraph) -> None:
        self._mesh, self._graph = mesh, graph
        self._joined = np.zeros(len(graph.pairs), dtype=bool)
        self._jump, self._none = np.zeros(0), np.zeros(0, dtype=bool)

    def across(self, joined: BoolArray) -> tuple[FloatArray, BoolArray]:
        """What ``curvature_jumps`` says of all pairs (e,) of facets that hang together."""
        edges, before = np.flatnonzero(joined), self._joined
        known = before[edges] & ~self._changed(joined)[self._graph.pairs[edges]].any(axis=1)
        place = np.cumsum(before) - 1
        jump, none = np.zeros(len(edges)), np.zeros(len(edges), dtype=bool)
        old = place[edges[known]]
        jump[known], none[known] = self._jump[old], self._none[old]
        jump[~known], none[~known] = curvature_jumps(self._mesh, self._graph, edges[~known], joined)
        self._joined, self._jump, self._none = joined.copy(), jump, none
        return jump, none

    def _changed(self, joined: BoolArray) -> BoolArray:
        """(m,) facets from which a pair that has been joined or parted is seen."""
        changed = np.zeros(len(self._mesh.triangles), dtype=bool)
        front = self._graph.pairs[joined != self._joined].ravel()
        changed[front] = True
        for _ in range(RINGS - 1):
            front = self._graph.neighbour[front].ravel()
            front = front[front >= 0]
            front = distinct(front[~changed[front]])
            changed[front] = True
        return changed
