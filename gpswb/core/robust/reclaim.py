# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facets that lie exactly on one surface, and only nearly on that of the region they are in."""

from __future__ import annotations

import numpy as np

from gpswb.core.facet_edges import edge_lengths
from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.robust.competition import OUTLYING
from gpswb.core.robust.curvature_jumps import curvature_jumps
from gpswb.core.robust.growth import Grown, flood, regions_of, stand_off, vertices_of
from gpswb.core.robust.surfaces import distance
from gpswb.core.robust.topology import FacetGraph

NEARER = 10.0
"""Ratio of two regions' stand-offs from which what both claim is the nearer one's: a tangent
neighbour stays within a wide tolerance for a facet or two, but leaves an exact surface at once."""


def reclaim(
    mesh: Mesh, graph: FacetGraph, found: list[Grown], flat: BoolArray, floor: float
) -> list[Grown]:
    """Give every region the facets that lie on its surface far better than on their own.

    A region grown at a wide tolerance has grown into its tangent neighbours, by the facets whose
    corners are within that tolerance. Where the neighbour's surface is known more exactly, they
    are its own; where not, they are left to be explained.

    Args:
        mesh: the mesh.
        graph: its adjacency.
        found: regions, without common facets.
        flat: (m,) facets of polygons that only go whole: they stay where they are.
        floor: distance that counts as none, mm.

    Returns:
        The regions, largest first, without common facets.
    """
    off = np.array([max(stand_off(g, vertices_of(mesh, g.facets)), floor) for g in found])
    far = [_largest(mesh, g) > OUTLYING * o for g, o in zip(found, off, strict=True)]
    owner = np.full(len(mesh.triangles), -1, dtype=np.int64)
    for i, g in enumerate(found):
        owner[g.facets] = i
    # The last entry is that of facets in no region, which are nobody's to give.
    claimable = np.append(off, 0.0)
    for i in np.argsort(off, kind="stable"):
        g = found[i]
        core = g.facets[~far[i] & (owner[g.facets] == i)]
        if len(core):
            allowed = (owner == i) | ((claimable[owner] > NEARER * off[i]) & ~flat)
            limit = OUTLYING * off[i]
            owner[flood(mesh, graph, g.kind, g.surface, core, allowed, limit)] = i
    outlying = np.zeros(len(owner), dtype=bool)
    for i, g in enumerate(found):
        outlying[g.facets[far[i]]] = owner[g.facets[far[i]]] == i
    owner[_leaked(mesh, graph, owner, outlying & ~flat)] = -1
    return sorted(regions_of(owner, found), key=lambda g: -len(g.facets))


def _leaked(mesh: Mesh, graph: FacetGraph, owner: IntArray, outlying: BoolArray) -> BoolArray:
    """(m,) those outlying facets before which curvature jumps more than behind them.

    Others are off their surface because their edge is, by modelling tolerance.
    """
    a, b = graph.pairs.T
    within = graph.smooth & outlying[a] & outlying[b] & (owner[a] == owner[b])
    piece = graph.components(within, len(owner))
    rim = np.flatnonzero(graph.smooth & (outlying[a] | outlying[b]) & ~within)
    jump, _ = curvature_jumps(mesh, graph, rim, graph.smooth)
    length = edge_lengths(mesh, rim)
    # Both sides of the rim, seen from each of its facets that is outlying.
    one, other = np.concatenate([a[rim], b[rim]]), np.concatenate([b[rim], a[rim]])
    weight, jumps = np.tile(length, 2), np.tile(np.minimum(jump, 1.0) * length, 2)
    means = []
    inside = owner[one] == owner[other]
    for side, alone in ((outlying[one] & inside, 0.0), (outlying[one] & ~inside, np.inf)):
        total = np.bincount(piece[one[side]], weight[side], len(owner))
        jumped = np.bincount(piece[one[side]], jumps[side], len(owner))
        means.append(np.where(total > 0.0, jumped / np.maximum(total, 1e-300), alone))
    before, behind = means
    leaked: BoolArray = outlying & (before > behind)[piece]
    return leaked


def _largest(mesh: Mesh, grown: Grown) -> FloatArray:
    """(k,) largest distance of each facet's corners from the region's surface, mm."""
    corners = mesh.corners_of(grown.facets).reshape(1, -1, 3)
    d, _ = distance(grown.kind, grown.surface[None], corners)
    largest: FloatArray = np.abs(d).reshape(-1, 3).max(axis=1)
    return largest
