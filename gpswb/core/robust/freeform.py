# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces that were only seen in a freeform one: local fits that go on smoothly around."""

from __future__ import annotations

import numpy as np

from gpswb.core.facet_edges import side_lengths
from gpswb.core.mesh import BoolArray, IntArray, Mesh
from gpswb.core.robust.evidence import is_exact
from gpswb.core.robust.growth import Grown
from gpswb.core.robust.jump_memory import JumpMemory
from gpswb.core.robust.smooth_parts import smooth_parts
from gpswb.core.robust.strips import few_polygons
from gpswb.core.robust.topology import SMOOTH, FacetGraph

SHARE = 0.4
"""Share of a weak region's border that smoothly continues into unexplained facets, above which the
region is a piece of what is unexplained. A true face ends at creases or at other true faces."""

SEEN_SHARE = 0.2
"""The same where the curvature is seen not to jump: a piece of a narrow face ends like it does on
either side, and only the ends of the piece are within the face."""


def dissolve(
    mesh: Mesh,
    graph: FacetGraph,
    found: list[Grown],
    polygon: IntArray,
    whole: BoolArray,
    jumps: JumpMemory,
) -> list[Grown]:
    """Drop the weak regions that are pieces of something unexplained, until none is left.

    Args:
        mesh: the mesh.
        graph: its adjacency.
        found: regions, without common facets.
        polygon: (m,) coplanar polygon of each facet.
        whole: (m,) facets that could be explained: those of no region are not, yet.
        jumps: the jumps of curvature that are known.
    """
    weak = [not is_exact(mesh, g) for g in found]
    if not any(weak):
        return found
    owner = np.full(len(whole), -1, dtype=np.int64)
    unexplained = whole.copy()
    for i, g in enumerate(found):
        owner[g.facets] = i
        unexplained[g.facets] = False
    # A plane of few facets proves nothing either, but it ends where it ends.
    unexplained &= ~few_polygons(graph, polygon, unexplained)
    open_ = unexplained | (owner >= 0) & np.append(weak, False)[owner]
    goes_on = _goes_on(mesh, graph, open_, jumps)
    length = side_lengths(mesh)
    keep = [True] * len(found)
    changed = True
    while changed:
        changed = False
        for i, g in enumerate(found):
            if not (weak[i] and keep[i]):
                continue
            neighbour = graph.neighbour[g.facets]
            beyond = np.maximum(neighbour, 0)
            border = (neighbour < 0) | (owner[beyond] != i)
            smooth = border & (neighbour >= 0) & (graph.dihedral[g.facets] < SMOOTH)
            smooth &= unexplained[beyond]
            seen = border & goes_on[g.facets]
            edge = length[g.facets]
            total = edge[border].sum()
            if edge[smooth].sum() > SHARE * total or edge[seen].sum() > SEEN_SHARE * total:
                keep[i] = False
                unexplained[g.facets] = True
                changed = True
    return [g for g, kept in zip(found, keep, strict=True) if kept]


def _goes_on(mesh: Mesh, graph: FacetGraph, open_: BoolArray, jumps: JumpMemory) -> BoolArray:
    """(m, 3) edges between open facets across which curvature is seen not to jump."""
    joined = graph.within(open_) & graph.smooth
    part, seen = smooth_parts(mesh, graph, joined, jumps)
    within = seen & (part[graph.pairs[:, 0]] == part[graph.pairs[:, 1]])
    return graph.sides(np.flatnonzero(within))
