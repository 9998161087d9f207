# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pieces that are no face of their own, given to the larger region that they smoothly continue."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gpswb.core.initial import InitialPartition
from gpswb.core.mesh import BoolArray, IntArray, Mesh
from gpswb.core.robust.curvature_jumps import curvature_jumps
from gpswb.core.robust.evidence import EXACT, sagitta
from gpswb.core.robust.freeform import SMOOTH
from gpswb.core.robust.growth import Grown, stand_off, vertices_of
from gpswb.core.robust.leftover import classes_of
from gpswb.core.robust.surfaces import distance
from gpswb.core.robust.topology import FacetGraph
from gpswb.core.tolerances import Tolerances

CHANCE = 1000.0
"""A region that bends by less than so many times what it stands off may be a chance fit: two
tangent surfaces whose curvatures differ by a third leave as much."""

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
    curvature. It goes to the region that it
    continues smoothly along most of its border, where its vertices lie near that region's surface,
    or both together keep the motion that the region has, or the region has none.

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
    chance = np.zeros(len(kept), dtype=bool)
    for i, g in enumerate(surfaces):
        bend, off = sagitta(mesh, g), stand_off(g, vertices_of(mesh, g.facets))
        kept[i] |= g.kind == "plane" or (bend >= EXACT * off and len(g.facets) >= few)
        chance[i] = bend < CHANCE * off
    goes_on = _goes_on(mesh, graph, label)
    for _ in range(ROUNDS):
        size = np.bincount(out[out >= 0], minlength=len(kept))
        pieces = np.flatnonzero((size > 0) & ~kept)
        names = None
        moved = False
        for piece in pieces[np.argsort(size[pieces], kind="stable")]:
            facets = np.flatnonzero(out == piece)
            host, share, only, seen = _host(mesh, graph, out, facets, goes_on)
            if share < TOUCH or (out == host).sum() < 2 * len(facets):
                continue
            piecemeal = share >= SHARE and (size[piece] < few or chance[piece])
            piecemeal |= seen >= SHARE
            if host < len(surfaces):
                far, extent = _far(mesh, surfaces[host], facets)
                fits = piecemeal and far <= OFF * extent
                fits |= (only >= ALONE or share >= SHARE) and far <= EDGES * mesh.diagonal
            else:
                if names is None:
                    names = _names(mesh, first, out, len(surfaces), sigma, tolerances)
                if names[host] == "complex":
                    fits = piecemeal
                else:
                    fits = _keeps(mesh, first, out, host, facets, names[host], sigma, tolerances)
            if fits:
                out[facets] = host
                moved = True
        if not moved:
            break
    return out


def _goes_on(mesh: Mesh, graph: FacetGraph, label: IntArray) -> BoolArray:
    """(m, 3) sides at which another label begins and curvature is seen not to jump."""
    smooth = np.abs(graph.pair_dihedral) < SMOOTH
    rim = np.flatnonzero(smooth & (label[graph.pairs[:, 0]] != label[graph.pairs[:, 1]]))
    _, none = curvature_jumps(mesh, graph, rim, graph.sides(np.flatnonzero(smooth)))
    return graph.sides(rim[none])


def _host(
    mesh: Mesh, graph: FacetGraph, label: IntArray, facets: IntArray, goes_on: BoolArray
) -> tuple[int, float, float, float]:
    """The largest label that facets smoothly continue into, of those that share half as much border
    as the one that shares most; shares: of the border that is smooth, of the smooth border that is
    the label's, of the border across which curvature is seen not to jump there. -1 and 0 for none.
    """
    own = label[facets[0]]
    neighbour = graph.neighbour[facets]
    other = np.where(neighbour >= 0, label[np.maximum(neighbour, 0)], -1)
    border = other != own
    corners = mesh.corners_of(facets)
    length = np.linalg.norm(corners[:, [1, 2, 0]] - corners, axis=2)
    turn = np.abs(graph.dihedral[facets])
    # A facet that is folded over lies in the region beside it all the same.
    smooth = border & (other >= 0) & (np.minimum(turn, np.pi - turn) < SMOOTH)
    if not smooth.any():
        return -1, 0.0, 0.0, 0.0
    total = np.bincount(other[smooth], length[smooth])
    # Another piece may share more of the border: it is the larger region that is continued.
    hosts = np.flatnonzero(total >= 0.5 * total.max())
    size = np.bincount(label[label >= 0])
    host = int(hosts[np.argmax(size[hosts])])
    around = max(float(length[border].sum()), 1e-300)
    seen = float(length[goes_on[facets] & (other == host)].sum())
    smoothly = float(total.sum())
    return host, smoothly / around, float(total[host]) / smoothly, seen / around


def _far(mesh: Mesh, host: Grown, facets: IntArray) -> tuple[float, float]:
    """How far facets' corners are off the host's surface, and how far apart, mm."""
    points = mesh.corners_of(facets).reshape(-1, 3)
    d, _ = distance(host.kind, host.surface[None], points[None])
    return float(np.abs(d).max()), float(np.linalg.norm(np.ptp(points, axis=0)))


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


def _keeps(
    mesh: Mesh,
    first: InitialPartition,
    label: IntArray,
    host: int,
    facets: IntArray,
    name: str,
    sigma: float,
    tolerances: Tolerances,
) -> bool:
    """Whether a host with facets added has the class that it has without."""
    trial = np.where(label == host, 0, -1)
    trial[facets] = 0
    return bool(classes_of(mesh, trial, first.crease, sigma, tolerances)[0] == name)
