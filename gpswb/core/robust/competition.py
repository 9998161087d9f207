# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facets that two surfaces claim go to the one with more behind it."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import BoolArray, IntArray, Mesh
from gpswb.core.robust.growth import Grown, flood, stand_off, vertices_of
from gpswb.core.robust.surfaces import distance
from gpswb.core.robust.topology import FacetGraph

OUTLYING = 6.0
"""Stand-offs beyond which a vertex isn't of a surface: the largest of thousands of normal
deviations is half as far."""

KEPT = 0.5
"""A region that loses more than this share of its facets to larger ones was a piece of them."""

CHORD = 4.0
"""Times the largest chord error of the rest of a region that a flat polygon in it may have: one
tessellation keeps its chord error."""

CREASED = 0.5
"""Turning angle (rad) at which a flat polygon is not part of the curved region beside it: the
coarsest usual export turns by that much."""


def compete(
    mesh: Mesh,
    graph: FacetGraph,
    found: list[Grown],
    polygon: IntArray,
    certain: BoolArray,
    floor: float,
    ceiling: float,
) -> list[Grown]:
    """Let the larger regions grow over the smaller ones that lie on their surfaces.

    A small patch of a torus lies nearly on a cylinder; found first, it would block the torus. Flat
    polygons may be taken only whole: two rings of a torus about its top lie in a plane, too.

    Args:
        mesh: the mesh.
        graph: its adjacency.
        found: regions, without common facets.
        polygon: (m,) polygon of each facet.
        certain: (k,) polygons that were taken for planes.
        floor: least tolerance, mm; a region is grown as far as its own vertices stand off.
        ceiling: the largest, mm: a region that has grown at a wider one stands off further, and
            would grow further each time.

    Returns:
        The regions that are left, largest first, without common facets.
    """
    free = mesh.areas > 0.0
    size = np.bincount(polygon, minlength=len(certain))
    out: list[Grown] = []
    for g in sorted(found, key=lambda g: -len(g.facets)):
        own = g.facets[free[g.facets]]
        if len(own) < max(1.0, KEPT * len(g.facets)):
            continue
        off = stand_off(g, vertices_of(mesh, own))
        tolerance = min(max(OUTLYING * off, floor), ceiling)
        facets = flood(mesh, graph, g.kind, g.surface, own, free, tolerance)
        facets = np.union1d(facets, own)
        facets = facets[~_not_its_own(mesh, graph, g, facets, polygon, certain, size)]
        free[facets] = False
        out.append(Grown(g.kind, g.surface, facets))
    return out


def _not_its_own(
    mesh: Mesh,
    graph: FacetGraph,
    grown: Grown,
    facets: IntArray,
    polygon: IntArray,
    certain: BoolArray,
    size: IntArray,
) -> BoolArray:
    """Which facets are of a plane that the region took in part, only touches, or bridges.

    Args:
        mesh: the mesh.
        graph: its adjacency.
        grown: the surface.
        facets: (f,) what it grew to.
        polygon: (m,) polygon of each facet.
        certain: (k,) polygons that were taken for planes; ``size`` (k,) their facets.

    Returns:
        (f,) bool.
    """
    own = polygon[facets]
    flat = certain[own]
    if not flat.any():
        return flat
    polygons, number = np.unique(own[flat], return_inverse=True)
    taken = np.bincount(number)
    # All vertices of a flat end may lie on the circle at which the fillet around it touches it; its
    # facets pass far below the surface that their corners lie on.
    d, _ = distance(grown.kind, grown.surface[None], mesh.centroids[facets][None])
    chord = np.abs(d[0])
    far = chord[flat] > CHORD * float(chord[~flat].max(initial=0.0))
    # Or it meets the rest of the region at a crease.
    inside = np.zeros(len(polygon), dtype=bool)
    inside[facets] = True
    neighbour = graph.neighbour[facets[flat]]
    across = (neighbour >= 0) & inside[neighbour] & (polygon[neighbour] != own[flat, None])
    creased = (across & (graph.dihedral[facets[flat]] > CREASED)).any(axis=1)
    refused = taken < size[polygons]
    refused[number[far | creased]] = True
    out = flat.copy()
    out[flat] = refused[number]
    return out
