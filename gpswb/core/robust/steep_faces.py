# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curved faces of so few facets that each of their edges could be one of the part."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import BoolArray, IntArray, Mesh
from gpswb.core.robust.consensus import CREASE, MOST, RINGS
from gpswb.core.robust.growth import Grown
from gpswb.core.robust.patches import rings_of
from gpswb.core.robust.proof import proved
from gpswb.core.robust.topology import FacetGraph
from gpswb.core.robust.trials import Trials

STEEP = np.deg2rad(75.0)
"""Turn of such an edge at most: rings of six vertices turn by 60°."""


def steep_faces(
    mesh: Mesh,
    graph: FacetGraph,
    free: BoolArray,
    lone: BoolArray,
    tolerance: float,
    trials: Trials,
) -> list[Grown]:
    """Cylinders and tori of staggered triangles that turn by more than a crease.

    A prism's sides are quadrangles. Where vertices are staggered from ring to ring, no two facets
    are in a plane, and what is built of triangles lies on no cylinder: a pyramid does on a cone, a
    die on a sphere, and of a die of twenty faces a belt of ten on a cylinder, beyond which it goes
    on in the same way.

    Args:
        mesh: the mesh.
        graph: its adjacency.
        free: (m,) facets that may be explained; no longer those of what is found.
        lone: (m,) facets that lie in a plane with none of their neighbours.
        tolerance: distance that counts as none, mm: that of rounding.
        trials: fits to parts so far.

    Returns:
        The regions, without common facets.
    """
    found: list[Grown] = []
    for rings in RINGS:
        open_ = free & lone

        def passable(facets: IntArray, open_: BoolArray = open_) -> BoolArray:
            return graph.passable(open_, facets, STEEP)

        seeds = np.flatnonzero(open_)
        # Where nothing turns by more than a crease, all has been tried already.
        steep = passable(seeds) & (graph.dihedral[seeds] >= CREASE)
        seeds = seeds[steep.any(axis=1)]
        seeds = seeds[np.argsort(-mesh.areas[seeds], kind="stable")][:MOST]
        if not len(seeds):
            break
        facets = rings_of(graph, seeds[:, None], passable, rings)
        trial = trials.of(facets, (facets >= 0).sum(axis=1), tolerance)
        for h in sorted(trial.hypotheses, key=lambda h: -h.score):
            grown = proved(mesh, graph, h, free, tolerance) if free[h.seed] else None
            if grown is None or grown.kind not in ("cylinder", "torus"):
                continue
            if not _goes_on(graph, grown.facets, lone):
                found.append(grown)
                free[grown.facets] = False
    return found


def _goes_on(graph: FacetGraph, facets: IntArray, lone: BoolArray) -> bool:
    """Whether most of a region's border leads to more facets of its sort."""
    inside = np.zeros(len(lone), dtype=bool)
    inside[facets] = True
    neighbour = graph.neighbour[facets]
    beyond = (neighbour >= 0) & ~inside[neighbour]
    more = beyond & graph.passable(lone, facets, STEEP)
    return 2 * int(more.sum()) > int(beyond.sum())
