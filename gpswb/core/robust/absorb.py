# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pieces that are no face of their own, given to the larger region that they smoothly continue."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gpswb.core.initial import InitialPartition
from gpswb.core.mesh import BoolArray, IntArray, Mesh
from gpswb.core.robust.evidence import CHANCE, EXACT, sagitta
from gpswb.core.robust.growth import Grown, stand_off, vertices_of
from gpswb.core.robust.hosts import hosts_of, sides_that_go_on
from gpswb.core.robust.leftover import classes_of
from gpswb.core.robust.rim import inner_vertices
from gpswb.core.robust.topology import FacetGraph
from gpswb.core.tolerances import Tolerances

SHARE = 0.5
"""Share of a piece's border across which it must continue smoothly into what surrounds it."""

TOUCH = 0.05
"""The same where the larger region has a motion and keeps it: the end of a thread, say."""

OFF = 0.1
"""Share of a piece's own extent that its vertices may stand off the surface that takes it."""

ALONE = 0.9
"""Share of a piece's smooth border from which it has one neighbour: the rest are creases."""

EDGES = 1e-4
"""Share of the diagonal by which the vertices of such a piece may be off its neighbour's surface:
those of an edge hold to the modelling tolerance of exchanged files only."""

ROUNDS = 3
"""A piece may continue another one that has just been taken."""


def absorb_pieces(
    mesh: Mesh,
    graph: FacetGraph,
    first: InitialPartition,
    label: IntArray,
    surfaces: Sequence[Grown],
    sure: BoolArray,
    sigma: float,
    tolerances: Tolerances,
) -> IntArray:
    """Merge pieces into what they are pieces of.

    A piece has few facets, or lies on its surface only by chance, or goes on without a jump of
    curvature. It goes to the region that it continues smoothly along most of its border, where its
    vertices lie near that region's surface, or both together keep the motion that the region has,
    or the region has none.

    Args:
        mesh: the mesh.
        graph: its adjacency.
        first: the first step's result.
        label: (m,) region of each facet, -1 for none; the first regions are those of ``surfaces``.
        surfaces: what the facets of a label lie on.
        sure: (m,) facets that stay what they are: those of certain planes.
        sigma: noise of the vertices, mm.
        tolerances: thresholds of recognition.

    Returns:
        (m,) labels, with gaps.
    """
    out = label.copy()
    few = tolerances.confident_facets
    kept = np.bincount(label[sure & (label >= 0)], minlength=int(label.max(initial=-1)) + 1) > 0
    chance, exact = np.zeros((2, len(kept)), dtype=bool)
    for i, g in enumerate(surfaces):
        bend, off = sagitta(mesh, g), stand_off(g, vertices_of(mesh, g.facets))
        exact[i] = g.kind != "plane" and bend >= EXACT * off
        # A strip between two arcs about one axis lies on a cone, whatever it is of.
        strip = g.kind == "cone" and not len(inner_vertices(mesh, graph, g.facets))
        kept[i] |= g.kind == "plane" or (exact[i] and len(g.facets) >= few and not strip)
        chance[i] = bend < CHANCE * off
    goes_on = sides_that_go_on(mesh, graph, label)
    for _ in range(ROUNDS):
        size = np.bincount(out[out >= 0], minlength=len(kept))
        pieces = np.flatnonzero((size > 0) & ~kept)
        names: dict[int, str] = {}
        moved = False
        for piece in pieces[np.argsort(size[pieces], kind="stable")]:
            facets = np.flatnonzero(out == piece)
            for host in hosts_of(mesh, graph, out, facets, goes_on, surfaces):
                if host.smooth < TOUCH or host.size < 2 * len(facets):
                    continue
                piecemeal = host.smooth >= SHARE and (size[piece] < few or chance[piece])
                piecemeal |= host.seen >= SHARE
                if host.number < len(surfaces):
                    # Vertices are on an exact surface, but for those of edges.
                    fits = piecemeal and host.far <= OFF * host.extent and not exact[host.number]
                    near = host.far <= EDGES * mesh.diagonal
                    fits |= near and (host.only >= ALONE or host.smooth >= SHARE)
                else:
                    if not names:
                        names = _names(mesh, first, out, len(surfaces), sigma, tolerances)
                    name = names[host.number]
                    fits = piecemeal
                    if name != "complex":
                        union = np.where(out == host.number, 0, -1)
                        union[facets] = 0
                        found = classes_of(mesh, union, first.crease, sigma, tolerances)
                        fits = bool(found[0] == name)
                if fits:
                    out[facets] = host.number
                    moved = True
                    break
        if not moved:
            break
    return out


def _names(
    mesh: Mesh,
    first: InitialPartition,
    label: IntArray,
    start: int,
    sigma: float,
    tolerances: Tolerances,
) -> dict[int, str]:
    """Class of each label from ``start`` on."""
    used = np.unique(label[label >= start])
    local = np.full(len(label), -1, dtype=np.int64)
    inside = label >= start
    local[inside] = np.searchsorted(used, label[inside])
    names = classes_of(mesh, local, first.crease, sigma, tolerances)
    return dict(zip(used.tolist(), names.tolist(), strict=True))
