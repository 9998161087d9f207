# SPDX-License-Identifier: LGPL-2.1-or-later
"""Borders between regions across which curvature is seen not to jump."""

from __future__ import annotations

import numpy as np

from gpswb.core.facet_edges import edge_lengths
from gpswb.core.mesh import BoolArray, IntArray, Mesh
from gpswb.core.robust.curvature_jumps import curvature_jumps
from gpswb.core.robust.topology import FacetGraph

SEEN = 0.5
"""Share of a common border across which curvature must be seen not to jump for one face."""


class SeenBorders:
    """How much of the border of two regions is seen to be none, while regions are joined."""

    def __init__(self, mesh: Mesh, graph: FacetGraph, rim: IntArray, region: IntArray) -> None:
        """
        Args:
            mesh: the mesh.
            graph: its adjacency.
            rim: (k,) edges between regions, as in ``graph.pairs``.
            region: (m,) region of each facet.
        """
        _, none = curvature_jumps(mesh, graph, rim, graph.smooth)
        self.ends = region[graph.pairs[rim]]
        self._length = edge_lengths(mesh, rim)
        self._seen = none * self._length

    def between(self, a: int, b: int) -> BoolArray:
        """(k,) edges of the common border of regions a and b."""
        common: BoolArray = ((self.ends == a) | (self.ends == b)).all(axis=1)
        common &= self.ends[:, 0] != self.ends[:, 1]
        return common

    def share(self, a: int, b: int) -> float:
        """Share of the border of regions a and b across which curvature is seen not to jump."""
        common = self.between(a, b)
        return float(self._seen[common].sum() / max(float(self._length[common].sum()), 1e-300))

    def join(self, kept: IntArray, gone: IntArray, count: int) -> None:
        """Let each region ``kept`` (p,) take ``gone`` (p,), of so many regions."""
        now = np.arange(count)
        now[gone] = kept
        self.ends = now[self.ends]
