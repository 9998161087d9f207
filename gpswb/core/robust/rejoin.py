# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pieces of one surface that was modelled less exactly than its pieces fit."""

from __future__ import annotations

import numpy as np

from gpswb.core.merging import merge_regions
from gpswb.core.mesh import FloatArray, IntArray, Mesh
from gpswb.core.robust.evidence import INSIDE, is_exact
from gpswb.core.robust.growth import Grown, fit_facets, residual, stand_off, vertices_of
from gpswb.core.robust.reclaim import NEARER
from gpswb.core.robust.seen_borders import SEEN, SeenBorders
from gpswb.core.robust.surfaces import Kind
from gpswb.core.robust.topology import FacetGraph


def rejoin(mesh: Mesh, graph: FacetGraph, found: list[Grown], floor: float) -> list[Grown]:
    """Join neighbours of one kind that lie on one surface about as well as on their own.

    A spline that stands for a circle leaves it by its modelling tolerance; its pieces fit circles
    of their own better, but not by the orders of magnitude that tell two surfaces apart. If
    the larger one is exact, its surface is that of both. Where curvature is seen not to jump
    between them, the tolerance of approximated surfaces is enough; not for tori, since a stretch of
    any narrow band lies on one.

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
    rim = np.flatnonzero(graph.smooth & graph.borders(owner))
    borders = SeenBorders(mesh, graph, rim, owner)
    rule = _OneSurface(mesh, found, borders, floor)
    kept = merge_regions(len(found), borders.ends, rule, 1.0)
    out = [rule.regions[i] for i in np.unique(kept)]
    return sorted(out, key=lambda g: -len(g.facets))


class _OneSurface:
    """Likeness of regions: how far their union may stand off one surface, as a multiple of how far
    it does (a ``MergeRule``); 0 for regions of different kinds."""

    def __init__(self, mesh: Mesh, found: list[Grown], borders: SeenBorders, floor: float) -> None:
        self._mesh, self._borders, self._floor = mesh, borders, floor
        self.regions = list(found)
        self._off = [stand_off(g, vertices_of(mesh, g.facets)) for g in found]
        self._union: dict[tuple[int, int], tuple[Grown, float]] = {}

    def score(self, first: IntArray, second: IntArray) -> FloatArray:
        return np.array(
            [self._likeness(a, b) for a, b in zip(first.tolist(), second.tolist(), strict=True)]
        )

    def join(self, kept: IntArray, gone: IntArray) -> None:
        self._borders.join(kept, gone, len(self.regions))
        for a, b in zip(kept.tolist(), gone.tolist(), strict=True):
            self.regions[a], self._off[a] = self._union[min(a, b), max(a, b)]

    def _likeness(self, a: int, b: int) -> float:
        one, other = self.regions[a], self.regions[b]
        if one.kind != other.kind:
            return 0.0
        key = min(a, b), max(a, b)
        limit = max(NEARER * max(self._off[a], self._off[b]), self._floor)
        larger, smaller = sorted((one, other), key=lambda g: -len(g.facets))
        facets = np.concatenate([one.facets, other.facets])
        if is_exact(self._mesh, larger):
            union, off = self._on_larger(larger, smaller, facets)
        else:
            union, off = self._fitted(one.kind, facets)
        self._union[key] = union, off
        if off <= limit or one.kind == "torus" or self._borders.share(a, b) < SEEN:
            return limit / max(off, 1e-300)
        union, off = self._fitted(one.kind, facets)
        most, limit = residual(self._mesh, union), INSIDE * self._mesh.diagonal
        if most <= limit:
            self._union[key] = union, off
        return limit / max(most, 1e-300)

    def _on_larger(self, larger: Grown, smaller: Grown, facets: IntArray) -> tuple[Grown, float]:
        """Union on the surface of the larger region, and how far the smaller stands off it, mm."""
        # The vertices of their border lie on both, whatever they are.
        triangles = self._mesh.triangles
        own = np.setdiff1d(triangles[smaller.facets], triangles[larger.facets])
        union = Grown(larger.kind, larger.surface, facets)
        return union, stand_off(union, self._mesh.vertices[own]) if len(own) else 0.0

    def _fitted(self, kind: Kind, facets: IntArray) -> tuple[Grown, float]:
        """Union on a surface fitted to its facets, and how far they stand off it, mm."""
        union = Grown(kind, fit_facets(self._mesh, kind, facets), facets)
        return union, stand_off(union, vertices_of(self._mesh, facets))
