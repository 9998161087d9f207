# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces that were only seen in a freeform one: local fits that the mesh around drifts from."""

from __future__ import annotations

import numpy as np

from gpswb.core.facet_edges import side_lengths
from gpswb.core.mesh import BoolArray, IntArray, Mesh
from gpswb.core.robust.evidence import is_exact
from gpswb.core.robust.growth import Grown
from gpswb.core.robust.strips import few_polygons
from gpswb.core.robust.topology import FacetGraph

SMOOTH = 0.35
"""Turning angle (rad) below which a border may be one within a freeform surface."""

SHARE = 0.4
"""Share of a weak region's border that smoothly continues into unexplained facets, above which the
region is a piece of what is unexplained. A true face ends at creases or at other true faces."""


def dissolve(
    mesh: Mesh, graph: FacetGraph, found: list[Grown], polygon: IntArray, whole: BoolArray
) -> list[Grown]:
    """Drop the weak regions that are pieces of something unexplained, until none is left.

    Args:
        mesh: the mesh.
        graph: its adjacency.
        found: regions, without common facets.
        polygon: (m,) coplanar polygon of each facet.
        whole: (m,) facets that could be explained: those of no region are not, yet.
    """
    weak = [not is_exact(mesh, g) for g in found]
    unexplained = whole.copy()
    for g in found:
        unexplained[g.facets] = False
    # A plane of few facets proves nothing either, but it ends where it ends.
    unexplained &= ~few_polygons(graph, polygon, unexplained)
    length = side_lengths(mesh)
    keep = [True] * len(found)
    changed = True
    while changed:
        changed = False
        for i, g in enumerate(found):
            if not (weak[i] and keep[i]):
                continue
            inside = np.zeros(len(whole), dtype=bool)
            inside[g.facets] = True
            neighbour = graph.neighbour[g.facets]
            border = ~inside[np.maximum(neighbour, 0)] | (neighbour < 0)
            smooth = border & (neighbour >= 0) & (np.abs(graph.dihedral[g.facets]) < SMOOTH)
            smooth &= unexplained[np.maximum(neighbour, 0)]
            edge = length[g.facets]
            if edge[smooth].sum() > SHARE * edge[border].sum():
                keep[i] = False
                unexplained[g.facets] = True
                changed = True
    return [g for g, kept in zip(found, keep, strict=True) if kept]
