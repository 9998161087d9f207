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
        tolerance = max(OUTLYING * stand_off(g, vertices_of(mesh, own)), floor)
        facets = flood(mesh, graph, g.kind, g.surface, own, free, tolerance)
        facets = np.union1d(facets, own)
        flat = facets[certain[polygon[facets]]]
        taken = np.bincount(polygon[flat], minlength=len(certain))
        creased = _creased(graph, facets, polygon, certain)
        bridging = _bridging(mesh, g, facets, polygon, certain)
        part = certain[polygon[facets]] & ((taken < size) | creased | bridging)[polygon[facets]]
        facets = facets[~part]
        free[facets] = False
        out.append(Grown(g.kind, g.surface, facets))
    return out


def _bridging(
    mesh: Mesh, grown: Grown, facets: IntArray, polygon: IntArray, certain: BoolArray
) -> BoolArray:
    """(k,) certain polygons whose facets pass far below the surface that their corners lie on.

    All vertices of a flat end may lie on the circle at which the fillet around it touches it.
    """
    d, _ = distance(grown.kind, grown.surface[None], mesh.centroids[facets][None])
    chord = np.abs(d[0])
    flat = certain[polygon[facets]]
    far = flat & (chord > CHORD * float(chord[~flat].max(initial=0.0)))
    out = np.zeros(len(certain), dtype=bool)
    out[polygon[facets[far]]] = True
    return out


def _creased(
    graph: FacetGraph, facets: IntArray, polygon: IntArray, certain: BoolArray
) -> BoolArray:
    """(k,) certain polygons that meet the rest of a region at a crease: they only touch it."""
    inside = np.zeros(len(polygon), dtype=bool)
    inside[facets] = True
    a, b = graph.pairs.T
    across = inside[a] & inside[b] & (polygon[a] != polygon[b])
    across &= np.abs(graph.pair_dihedral) > CREASED
    out = np.zeros(len(certain), dtype=bool)
    out[polygon[graph.pairs[across]].ravel()] = True
    return out & certain
