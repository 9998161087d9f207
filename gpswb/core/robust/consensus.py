# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cylinders, cones, spheres and tori on which connected facets agree to within a tolerance.

Nominal vertices lie on their surface to rounding. A surface fitted to a part of the mesh that lies
in one face is therefore exact, and grows to the whole face; a part across a border fits nothing. So
all parts are fitted at once, the initial regions first; the surfaces that explain their part are
grown in order of evidence, and parts that aren't explained are halved and tried again.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.reference import spread
from gpswb.core.robust.evidence import BEND, drifts, enough_evidence, is_exact, sagitta
from gpswb.core.robust.fitting import fit, fit_patches
from gpswb.core.robust.growth import Grown, fit_facets, flood, grow, residual, to_world
from gpswb.core.robust.parts import connected_parts, halves, spread_over
from gpswb.core.robust.patches import Patches, patches_around, patches_of
from gpswb.core.robust.surfaces import UNKNOWNS, Kind, distance
from gpswb.core.robust.topology import FacetGraph

CREASE = np.deg2rad(40.0)
"""Patches don't cross edges that turn by more: coarse tessellations turn by 28.6° (0.5 rad)."""

KINDS: tuple[Kind, ...] = ("cylinder", "cone", "sphere", "torus")
"""Ruled kinds first: two rings of vertices lie on a cylinder or cone, but also on spheres."""

SIMPLER = 3e-4
"""Share of a region's height that a simpler surface may leave: less than any modelled draft."""

BATCH = 128
"""Parts fitted together: enough to spread numpy's overhead, few enough for the cache."""

LIKE = 16.0
"""Ratio of two neighbours' areas from which they are not of one part: the strips of a cylinder
beside the small facets of its fillet would be most of the part's size, and few of its facets."""

SAMPLE = 48
"""Facets of a part that are fitted: seven unknowns need far fewer, borders make themselves felt."""

LEAST = 4
"""Facets that can prove a surface, at least."""

LEAST_BEND = 4.0
"""Tolerances that a part's vertices must leave their mean plane by: a flatter one proves nothing,
and its halves are flatter still."""

LEAST_HALF = 12
"""The same for a half of a part where the tolerance is wider than rounding: with few facets, pieces
of anything lie on some surface."""

MOST = 512
"""Parts of one level that are fitted, larger first, unless some of them are explained: what has
fallen into more pieces than that is mostly freeform."""

ROUNDS = 3
"""Descents from what is left, each with new parts: pieces cut by one are whole in the next."""

WORTHWHILE = 0.01
"""Share of the free facets that a descent must explain to give another one hope of new parts."""

VAIN = 16
"""Hypotheses of a batch that prove nothing, one after the other, before the rest is given up: on a
freeform face every part lies on some surface to within a wide tolerance."""

SMALL = 64
"""Facets of a group that hangs together by itself in which every facet deserves a try of its own
neighbourhood."""

RINGS: tuple[int, ...] = (2, 4)
"""Sizes of those neighbourhoods, in steps from facet to facet."""

ROBUST_SHARE = 0.3
"""Share of a part that a robust fit must explain: below it hypotheses are found by chance."""

ROBUST_LEAST = 16
"""Vertices of a part in which a robust fit may choose; smaller parts are halved instead."""

FREEFORM = 0.03
"""A part whose best torus leaves less than this share of the part's own height, but more than the
tolerance, looks like a piece of a freeform surface. Two tangent surfaces of nearly equal curvature
look so, too, but not the halves of their part: two levels in a row must."""


@dataclass(frozen=True)
class Hypothesis:
    """A surface that explains a part: ``seed`` lies on it, ``score`` is the number of facets."""

    kind: Kind
    surface: FloatArray
    seed: int
    score: float


def find_surfaces(
    mesh: Mesh,
    graph: FacetGraph,
    free: BoolArray,
    initial: IntArray,
    tolerance: float,
    smooth: FloatArray,
    exact: bool,
) -> list[Grown]:
    """Surfaces that connected facets lie on, largest evidence first.

    Args:
        mesh: the mesh.
        graph: its adjacency.
        free: (m,) facets that may be explained.
        initial: (m,) initial regions (paper, 5.2): the first parts.
        tolerance: distance that counts as none, mm.
        smooth: (m,) mm, residual of the best torus where facets were seen to be freeform, 0 where
            they were not; what is seen here is added for calls with wider tolerances.
        exact: whether the tolerance is that of rounding, so that few facets prove a surface.
    """
    free = free.copy()
    found: list[Grown] = []
    group = initial
    for _ in range(ROUNDS):
        new = _descend(mesh, graph, group, free, tolerance, smooth, exact)
        found += new
        if sum(len(g.facets) for g in new) < WORTHWHILE * free.sum():
            break
        group = np.zeros(len(free), dtype=np.int64)
    return found + _around_seeds(mesh, graph, free, tolerance, smooth, exact)


def _descend(
    mesh: Mesh,
    graph: FacetGraph,
    group: IntArray,
    free: BoolArray,
    tolerance: float,
    smooth: FloatArray,
    exact: bool,
) -> list[Grown]:
    """Surfaces of parts, of their halves, and so on; their facets are no longer free afterwards."""
    found: list[Grown] = []
    doubt = np.zeros(len(free))
    least = LEAST
    area = np.maximum(mesh.areas[graph.pairs], 1e-300)
    flat = np.abs(graph.pair_dihedral) < CREASE
    flat &= np.abs(np.log(area[:, 0] / area[:, 1])) < np.log(LIKE)
    while True:
        open_ = free & (smooth <= tolerance)
        part = connected_parts(graph, np.where(open_, group, -1), flat)
        facets, size = spread_over(part, SAMPLE)
        order = np.argsort(-size, kind="stable")
        order = order[size[order] >= least]
        if not len(order):
            return found
        tried = np.zeros(len(size), dtype=bool)
        for start in range(0, len(order), BATCH):
            batch = order[start : start + BATCH]
            known = len(found)
            patches = patches_of(mesh, facets[batch])
            bent = np.flatnonzero(_sagitta(patches) * patches.scale > LEAST_BEND * tolerance)
            batch, patches = batch[bent], patches.take(bent)
            if not len(batch):
                continue
            tried[batch] = True
            hypotheses, freeform = explain(mesh, patches, size[batch], tolerance)
            hypotheses.sort(key=lambda h: -h.score)
            found += _grow_all(mesh, graph, hypotheses, free, tolerance)
            _note_freeform(part, batch, freeform, doubt, smooth)
            if start >= MOST and len(found) == known:
                break
        least = LEAST if exact else LEAST_HALF
        worth = np.append(tried & (size > least), False)
        group = halves(graph, np.where(free & worth[part], part, -1), flat)


def _note_freeform(
    part: IntArray, batch: IntArray, freeform: FloatArray, doubt: FloatArray, smooth: FloatArray
) -> None:
    """Note that parts look freeform.

    Args:
        part: (m,) part of each facet, -1 for none.
        batch: (b,) parts; ``freeform`` (b,) mm, what their tori leave, 0 where they don't look so.
        doubt: (m,) mm, what the torus of the whole left that each part is a half of; brought up to
            date. Where that looked freeform, too, it is noted in ``smooth`` (m,).
    """
    residual = np.full(int(part.max()) + 2, np.nan)
    residual[batch] = freeform
    seen = residual[part]  # the last entry is that of facets in no part
    again = (seen > 0.0) & (doubt > 0.0)
    smooth[again] = doubt[again]
    told = np.isfinite(seen)
    doubt[told] = seen[told]


def _grow_all(
    mesh: Mesh, graph: FacetGraph, hypotheses: list[Hypothesis], free: BoolArray, tolerance: float
) -> list[Grown]:
    """The regions of hypotheses that prove their surface; they are no longer free afterwards."""
    found: list[Grown] = []
    vain = 0
    for h in hypotheses:
        if not free[h.seed]:
            continue
        grown = _proved(mesh, graph, h, free, tolerance)
        vain += 1
        if grown is not None:
            found.append(grown)
            free[grown.facets] = False
            vain = 0
        elif vain == VAIN:
            break
    return found


def _around_seeds(
    mesh: Mesh,
    graph: FacetGraph,
    free: BoolArray,
    tolerance: float,
    smooth: FloatArray,
    exact: bool,
) -> list[Grown]:
    """Surfaces from the neighbourhoods of facets that are left.

    Halves may cut a narrow face lengthwise, its neighbourhoods don't. Every facet of a small group
    is tried; of large groups, where the tolerance is that of rounding, some that are spread.
    """
    found: list[Grown] = []
    for rings in RINGS:
        group = connected_parts(graph, np.where(free, 0, -1), np.ones(len(graph.pairs), dtype=bool))
        few = np.append(np.bincount(group[group >= 0]) <= SMALL, False)[group]
        passable = _passable(graph, free)
        open_ = free & (smooth <= tolerance) & passable.any(axis=1)
        seeds = np.flatnonzero(open_ & few)
        if exact:
            seeds = np.concatenate([seeds, _spread(mesh, graph, open_ & ~few, rings)])
        seeds = seeds[np.argsort(-mesh.areas[seeds], kind="stable")][:MOST]
        for start in range(0, len(seeds), BATCH):
            batch = seeds[start : start + BATCH]
            batch = batch[free[batch]]
            passable = _passable(graph, free)
            batch = batch[passable[batch].any(axis=1)]
            if not len(batch):
                continue
            patches = patches_around(mesh, graph, batch, passable, rings)
            count = (patches.facets >= 0).sum(axis=1)
            hypotheses, _ = explain(mesh, patches, count, tolerance)
            hypotheses.sort(key=lambda h: -h.score)
            found += _grow_all(mesh, graph, hypotheses, free, tolerance)
    return found


def _spread(mesh: Mesh, graph: FacetGraph, candidates: BoolArray, spacing: int) -> IntArray:
    """At most ``MOST`` facets, large ones first, none within so many steps of another."""
    index = np.flatnonzero(candidates)
    order = index[np.argsort(-mesh.areas[index], kind="stable")]
    covered = np.zeros(len(candidates), dtype=bool)
    seeds: list[int] = []
    for facet in order.tolist():
        if covered[facet]:
            continue
        seeds.append(facet)
        if len(seeds) == MOST:
            break
        front = np.array([facet])
        for _ in range(spacing):
            front = graph.neighbour[front].ravel()
            front = front[front >= 0]
            covered[front] = True
    return np.array(seeds, dtype=np.int64)


def _proved(
    mesh: Mesh, graph: FacetGraph, h: Hypothesis, free: BoolArray, tolerance: float
) -> Grown | None:
    """The region that a hypothesis grows to, None where it doesn't prove its surface."""
    touched = flood(mesh, graph, h.kind, h.surface, np.array([h.seed]), free, tolerance)
    if len(touched) < LEAST:
        return None
    rough = Grown(h.kind, h.surface, touched)
    if not is_exact(mesh, rough) and (
        sagitta(mesh, rough) < BEND * tolerance or drifts(mesh, graph, rough, tolerance)
    ):
        return None
    grown = grow(mesh, graph, h.kind, h.surface, np.array([h.seed]), free, tolerance)
    if len(grown.facets):
        grown = simplest(mesh, graph, grown, free, tolerance)
    return grown if enough_evidence(mesh, graph, grown, tolerance) else None


def simplest(
    mesh: Mesh, graph: FacetGraph, grown: Grown, free: BoolArray, tolerance: float
) -> Grown:
    """The region of a simpler kind, where that explains all of a region as well.

    Two coaxial rings of vertices lie on a sphere, but also on a cylinder or cone; a torus without
    a hole to speak of is a sphere; a cone takes up what borders stand off a cylinder.
    """
    limit = max(tolerance, min(4.0 * tolerance, SIMPLER * sagitta(mesh, grown)))
    some = grown.facets[spread(len(grown.facets), SAMPLE)]
    points = mesh.vertices[np.unique(mesh.triangles[grown.facets])]
    for kind in KINDS[: KINDS.index(grown.kind)]:
        near = Grown(kind, fit_facets(mesh, kind, some), some)
        if residual(mesh, near) > limit:
            continue
        surface = fit_facets(mesh, kind, grown.facets)
        if np.abs(distance(kind, surface[None], points[None])[0]).max() <= limit:
            other = grow(mesh, graph, kind, surface, grown.facets, free, limit)
            if len(other.facets) >= len(grown.facets):
                return other
    return grown


def explain(
    mesh: Mesh, patches: Patches, size: IntArray, tolerance: float
) -> tuple[list[Hypothesis], FloatArray]:
    """The simplest surface that explains each patch, where one does.

    Plain least squares first; where a patch crosses a border, a robust fit may still find the
    surface that most of it lies on.

    Args:
        mesh: the mesh.
        patches: b patches.
        size: (b,) facets of the part that each patch is a sample of.
        tolerance: distance that counts as none, mm.

    Returns:
        The hypotheses, and (b,) mm: what the best torus leaves of the patches that look freeform,
        0 for the others.
    """
    hypotheses: list[Hypothesis] = []
    freeform = np.zeros(len(patches.centre))
    nearest = np.zeros((len(freeform), 8))
    left = np.arange(len(patches.centre))
    for robust in (False, True):
        for kind in KINDS:
            if robust:
                # A torus has too many unknowns to choose its points without a good first guess.
                left = left[(freeform[left] > 0.0) | (kind != "torus")]
            if not len(left):
                continue
            some = patches.take(left)
            floor = float(np.median(tolerance / some.scale)) if robust else None
            if robust and kind == "torus":
                local = fit(kind, nearest[left], some.points, some.weights, floor)
            else:
                local = fit_patches(
                    kind, some.points, some.weights, some.centroids, some.normals, floor
                )
            world = to_world(local, some.centre, some.scale, kind)
            d, _ = distance(kind, local, some.points)
            d = np.where(some.weights > 0, np.abs(d), 0.0)
            inside = (d <= (tolerance / some.scale)[:, None]) & (some.weights > 0)
            share = inside.sum(axis=1) / np.maximum(some.weights.sum(axis=1), 1.0)
            # A robust fit chooses its own points: it needs more of them to prove something.
            good = inside.sum(axis=1) - UNKNOWNS[kind] >= (3 if robust else 2)
            good &= (share >= (ROBUST_SHARE if robust else 1.0)) & _is_finite(kind, local)
            for row in np.flatnonzero(good):
                seed = _seed(mesh, kind, world[row], some.facets[row], tolerance)
                if seed is not None:
                    score = float(share[row] * size[left[row]])
                    hypotheses.append(Hypothesis(kind, world[row], seed, score))
            if kind == "torus" and not robust:
                nearest[left] = local
                worst = d.max(axis=1)
                looks = ~good & (worst < FREEFORM * _sagitta(some)) & (size[left] >= LEAST_HALF)
                freeform[left[looks]] = (worst * some.scale)[looks]
            # What a robust fit explains in part is no freeform surface.
            freeform[left[good]] = 0.0
            left = left[~good]
        left = left[patches.weights[left].sum(axis=1) >= ROBUST_LEAST]
    return hypotheses, freeform


def _seed(
    mesh: Mesh, kind: Kind, surface: FloatArray, facets: IntArray, tolerance: float
) -> int | None:
    """The largest of some facets (-1 for none) that has its corners on a surface."""
    facets = facets[facets >= 0]
    d, _ = distance(kind, surface[None], mesh.corners[facets].reshape(1, -1, 3))
    on = facets[(np.abs(d).reshape(-1, 3) <= tolerance).all(axis=1)]
    return int(on[np.argmax(mesh.areas[on])]) if len(on) else None


def _sagitta(patches: Patches) -> FloatArray:
    """(b,) how far each patch's vertices leave its mean plane, in local units."""
    moment = np.einsum("bni,bnj->bij", patches.points, patches.points)
    normal = np.linalg.eigh(moment)[1][:, :, 0]
    height = np.einsum("bnk,bk->bn", patches.points, normal)
    sagitta: FloatArray = np.ptp(height, axis=1)
    return sagitta


def _is_finite(kind: Kind, local: FloatArray) -> BoolArray:
    """Whether the surface bends at all on the scale of its patch; else it is all but a plane."""
    size = local[:, 7] if kind == "torus" else local[:, 6]
    finite: BoolArray = np.isfinite(local).all(axis=1) & (np.abs(size) < 1e3)
    return finite


def _passable(graph: FacetGraph, free: BoolArray) -> BoolArray:
    neighbour = graph.neighbour
    passable: BoolArray = (
        (neighbour >= 0) & free[np.maximum(neighbour, 0)] & (np.abs(graph.dihedral) < CREASE)
    )
    return passable
