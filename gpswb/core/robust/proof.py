# SPDX-License-Identifier: LGPL-2.1-or-later
"""The region that a hypothesis grows to, if that proves its surface."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import BoolArray, Mesh
from gpswb.core.reference import spread
from gpswb.core.robust.evidence import (
    BEND,
    drifts,
    enough_evidence,
    holds_inside,
    is_exact,
    sagitta,
)
from gpswb.core.robust.growth import Grown, fit_facets, flood, grow, residual, vertices_of
from gpswb.core.robust.hypotheses import KINDS, Hypothesis
from gpswb.core.robust.surfaces import distance
from gpswb.core.robust.topology import FacetGraph

SIMPLER = 3e-4
"""Share of a region's height that a simpler surface may leave: less than any modelled draft."""

SAMPLE = 48
"""Facets of a part that are fitted: seven unknowns need far fewer, borders make themselves felt."""

LEAST = 4
"""Facets that can prove a surface, at least."""


def proved(
    mesh: Mesh, graph: FacetGraph, h: Hypothesis, free: BoolArray, tolerance: float
) -> Grown | None:
    """The region that a hypothesis grows to, None where it doesn't prove its surface."""
    touched = flood(mesh, graph, h.kind, h.surface, np.array([h.seed]), free, tolerance)
    if len(touched) < LEAST:
        return None
    rough = Grown(h.kind, h.surface, touched)
    if not is_exact(mesh, rough) and (
        sagitta(mesh, rough) < BEND * tolerance
        or drifts(mesh, graph, rough, tolerance)
        or not holds_inside(mesh, graph, rough, tolerance)
    ):
        return None
    grown = grow(mesh, graph, h.kind, h.surface, np.array([h.seed]), free, tolerance, touched)
    if len(grown.facets):
        grown = simplest(mesh, graph, grown, free, tolerance)
    return grown if enough_evidence(mesh, graph, grown, tolerance) else None


def simplest(
    mesh: Mesh, graph: FacetGraph, grown: Grown, free: BoolArray, tolerance: float
) -> Grown:
    """The region of a simpler kind, where that explains all of a region as well.

    Two coaxial rings of vertices lie on a sphere, but also on a cylinder or cone; a torus without
    a hole to speak of is a sphere; a cone takes up what borders stand off a cylinder.
    """
    limit = max(tolerance, min(4.0 * tolerance, SIMPLER * sagitta(mesh, grown)))
    some = grown.facets[spread(len(grown.facets), SAMPLE)]
    points = vertices_of(mesh, grown.facets)
    for kind in KINDS[: KINDS.index(grown.kind)]:
        near = Grown(kind, fit_facets(mesh, kind, some), some)
        if residual(mesh, near) > limit:
            continue
        surface = fit_facets(mesh, kind, grown.facets)
        if np.abs(distance(kind, surface[None], points[None])[0]).max() <= limit:
            other = grow(mesh, graph, kind, surface, grown.facets, free, limit)
            if len(other.facets) >= len(grown.facets):
                return other
    return grown
