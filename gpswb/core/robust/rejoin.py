# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pieces of one surface that was modelled less exactly than its pieces fit."""

from __future__ import annotations

import numpy as np

from gpswb.core.merging import merge_regions
from gpswb.core.mesh import FloatArray, IntArray, Mesh
from gpswb.core.robust.evidence import is_exact
from gpswb.core.robust.growth import Grown, fit_facets, stand_off, vertices_of
from gpswb.core.robust.reclaim import NEARER
from gpswb.core.robust.topology import FacetGraph


def rejoin(mesh: Mesh, graph: FacetGraph, found: list[Grown], floor: float) -> list[Grown]:
    """Join neighbours of one kind that lie on one surface about as well as on their own.

    A spline that stands for a circle leaves it by its modelling tolerance; its pieces fit circles
    of their own better, but not by the orders of magnitude that tell two surfaces apart. If
    the larger one is exact, its surface is that of both.

    Args:
        mesh: the mesh.
        graph: its adjacency.
        found: regions, without common facets.
        floor: distance that counts as none, mm.

    Returns:
        The regions, largest first, without common facets.
    """
    owner = np.full(len(mesh.triangles), -1, dtype=np.int64)
    for i, g in enumerate(found):
        owner[g.facets] = i
    ends = owner[graph.pairs[graph.smooth]]
    ends = ends[(ends >= 0).all(axis=1)]
    rule = _OneSurface(mesh, found, floor)
    kept = merge_regions(len(found), ends, rule, 1.0)
    out = [rule.regions[i] for i in np.unique(kept)]
    return sorted(out, key=lambda g: -len(g.facets))


class _OneSurface:
    """Likeness of regions: how far their union may stand off one surface, as a multiple of how far
    it does (a ``MergeRule``); 0 for regions of different kinds."""

    def __init__(self, mesh: Mesh, found: list[Grown], floor: float) -> None:
        self._mesh, self._floor = mesh, floor
        self.regions = list(found)
        self._off = [stand_off(g, vertices_of(mesh, g.facets)) for g in found]
        self._union: dict[tuple[int, int], tuple[Grown, float]] = {}

    def score(self, first: IntArray, second: IntArray) -> FloatArray:
        return np.array(
            [self._likeness(a, b) for a, b in zip(first.tolist(), second.tolist(), strict=True)]
        )

    def join(self, kept: IntArray, gone: IntArray) -> None:
        for a, b in zip(kept.tolist(), gone.tolist(), strict=True):
            self.regions[a], self._off[a] = self._union[min(a, b), max(a, b)]

    def _likeness(self, a: int, b: int) -> float:
        one, other = self.regions[a], self.regions[b]
        if one.kind != other.kind:
            return 0.0
        limit = max(NEARER * max(self._off[a], self._off[b]), self._floor)
        facets = np.concatenate([one.facets, other.facets])
        larger, smaller = (one, other) if len(one.facets) >= len(other.facets) else (other, one)
        if is_exact(self._mesh, larger):
            union = Grown(one.kind, larger.surface, facets)
            off = stand_off(union, vertices_of(self._mesh, smaller.facets))
        else:
            union = Grown(one.kind, fit_facets(self._mesh, one.kind, facets), facets)
            off = stand_off(union, vertices_of(self._mesh, facets))
        self._union[min(a, b), max(a, b)] = union, off
        return limit / max(off, 1e-300)
