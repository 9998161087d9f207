# SPDX-License-Identifier: LGPL-2.1-or-later
"""Planes, cylinders, cones, spheres and tori, from narrow tolerances to wide."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import BoolArray, IntArray, Mesh
from gpswb.core.robust.competition import compete
from gpswb.core.robust.consensus import find_surfaces
from gpswb.core.robust.evidence import INSIDE, is_exact
from gpswb.core.robust.freeform import dissolve
from gpswb.core.robust.growth import Grown, fit_facets, flood
from gpswb.core.robust.jump_memory import JumpMemory
from gpswb.core.robust.reclaim import reclaim
from gpswb.core.robust.rejoin import rejoin
from gpswb.core.robust.stacked_bands import stacked_bands
from gpswb.core.robust.steep_faces import steep_faces
from gpswb.core.robust.topology import FacetGraph
from gpswb.core.robust.trials import Trials
from gpswb.core.stages import StageClock

TIERS: tuple[float, ...] = (1e-7, 1e-5, 3e-5, 1e-4)
"""Distances that count as none, as shares of the diagonal, tried one after the other: analytic
surfaces hold to rounding, approximated ones only to their modelling tolerance, and edges to that of
exchanged files. Strips of coarse exports have no vertices but those of edges."""

STILL = 0.7
"""Share of a weak region that nothing else has taken, from which it stays for the next tolerance:
of less, what took it is more likely the surface."""


def simple_surfaces(
    mesh: Mesh,
    graph: FacetGraph,
    polygon: IntArray,
    certain: BoolArray,
    initial: IntArray,
    jumps: JumpMemory,
    clock: StageClock,
) -> list[Grown]:
    """Planes, cylinders, cones, spheres and tori with the connected facets that prove them.

    Args:
        mesh: the mesh.
        graph: its adjacency.
        polygon: (m,) coplanar polygon of each facet.
        certain: (k,) polygons that are planes unless a surface takes them whole.
        initial: (m,) initial regions, where the search begins.
        jumps: the jumps of curvature that are known.
        clock: told of the progress.
    """
    fine, wide = TIERS[0] * mesh.diagonal, TIERS[-1] * mesh.diagonal
    whole = mesh.areas > 0.0
    found: list[Grown] = []
    smooth = np.zeros(len(whole))
    lone = whole & (np.bincount(polygon)[polygon] == 1)
    trials = Trials(mesh)
    for number, tier in enumerate(TIERS):
        tolerance = tier * mesh.diagonal
        # What isn't exact yet may be a piece of something larger, which shows at a wider tolerance.
        weak = [g for g in found if not is_exact(mesh, g)]
        free = whole & ~certain[polygon]
        found = [g for g in found if is_exact(mesh, g)]
        for g in found:
            free[g.facets] = False
        if tier <= INSIDE:
            # Beyond, an exact region would grow into its tangent neighbours.
            found = [_regrow(mesh, graph, g, free, tolerance) for g in found]
        exact = number == 0
        new = find_surfaces(mesh, graph, free, initial, tolerance, smooth, trials, exact)
        for g in new:
            free[g.facets] = False
        found += new + _still_free(weak, free)
        if exact:
            found += steep_faces(mesh, graph, free, lone, tolerance, trials)
            found += stacked_bands(mesh, graph, found, whole & ~certain[polygon], fine)
        found = compete(mesh, graph, found, polygon, certain, fine, wide)
        clock.report("refine", (number + 1) / (len(TIERS) + 1))
    found = dissolve(mesh, graph, found, polygon, whole & ~certain[polygon], jumps)
    # What the dissolved regions had taken may belong to those that stay.
    found = compete(mesh, graph, found, polygon, certain, fine, wide)
    found = reclaim(mesh, graph, found, certain[polygon], fine)
    found = rejoin(mesh, graph, found, fine)
    planes = []
    order = np.argsort(polygon, kind="stable")
    bounds = np.searchsorted(polygon[order], np.arange(len(certain) + 1))
    taken = np.zeros(len(whole), dtype=bool)
    for g in found:
        taken[g.facets] = True
    for i in np.flatnonzero(certain):
        facets = order[bounds[i] : bounds[i + 1]]
        if taken[facets[0]]:
            continue
        planes.append(Grown("plane", fit_facets(mesh, "plane", facets), facets))
    return planes + found


def _still_free(weak: list[Grown], free: BoolArray) -> list[Grown]:
    """Regions of which most is still free, larger first, without what is not."""
    kept = []
    for g in sorted(weak, key=lambda g: -len(g.facets)):
        own = g.facets[free[g.facets]]
        if len(own) > STILL * len(g.facets):
            free[own] = False
            kept.append(Grown(g.kind, g.surface, own))
    return kept


def _regrow(
    mesh: Mesh, graph: FacetGraph, grown: Grown, free: BoolArray, tolerance: float
) -> Grown:
    """Take in the facets that a wider tolerance adds, and mark them as no longer free.

    The surface stays what it is: what is taken in is off it by the tolerance of an edge.
    """
    free[grown.facets] = True
    more = flood(mesh, graph, grown.kind, grown.surface, grown.facets, free, tolerance)
    facets = np.union1d(grown.facets, more)
    free[facets] = False
    return Grown(grown.kind, grown.surface, facets)
