# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facets that lie exactly on one surface, and only nearly on that of the region they are in."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.robust.competition import OUTLYING
from gpswb.core.robust.freeform import SMOOTH
from gpswb.core.robust.growth import Grown, flood, stand_off, vertices_of
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
    out = []
    for i, g in enumerate(found):
        own = np.flatnonzero(owner == i)
        outlying = np.intersect1d(own, g.facets[far[i] & ~flat[g.facets]])
        own = np.setdiff1d(own, _leaked(graph, own, outlying))
        if len(own):
            out.append(Grown(g.kind, g.surface, own))
    return sorted(out, key=lambda g: -len(g.facets))


def _leaked(graph: FacetGraph, own: IntArray, outlying: IntArray) -> IntArray:
    """Those outlying facets of a region that smoothly continue, over one another, into what is not
    of it. The others end at a crease: there edges are off their faces by modelling tolerance."""
    m = len(graph.neighbour)
    inside, far = np.zeros(m, dtype=bool), np.zeros(m, dtype=bool)
    inside[own] = far[outlying] = True
    smooth = (graph.neighbour >= 0) & (np.abs(graph.dihedral) < SMOOTH)
    beyond = np.maximum(graph.neighbour, 0)
    front = outlying[(smooth[outlying] & ~inside[beyond[outlying]]).any(axis=1)]
    leaked = np.zeros(m, dtype=bool)
    while len(front):
        leaked[front] = True
        step = np.unique(beyond[front][smooth[front]])
        front = step[far[step] & ~leaked[step]]
    return np.flatnonzero(leaked)


def _largest(mesh: Mesh, grown: Grown) -> FloatArray:
    """(k,) largest distance of each facet's corners from the region's surface, mm."""
    corners = mesh.corners[grown.facets].reshape(1, -1, 3)
    d, _ = distance(grown.kind, grown.surface[None], corners)
    largest: FloatArray = np.abs(d).reshape(-1, 3).max(axis=1)
    return largest
