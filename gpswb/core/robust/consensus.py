# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cylinders, cones, spheres and tori on which connected facets agree to within a tolerance.

Nominal vertices lie on their surface to rounding. A surface fitted to a small patch that lies in
one face is therefore exact, and grows to the whole face; a patch across a border fits nothing. So
many patches are fitted at once, the hypotheses that explain their patch are grown in order of
evidence, and what isn't explained is tried again with other patches.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.robust.evidence import drifts, enough_evidence, is_exact, sagitta
from gpswb.core.robust.fitting import fit_patches
from gpswb.core.robust.growth import Grown, fit_facets, flood, grow, to_world
from gpswb.core.robust.patches import Patches, patches_around
from gpswb.core.robust.surfaces import UNKNOWNS, Kind, distance
from gpswb.core.robust.topology import FacetGraph

CREASE = np.deg2rad(40.0)
"""Patches don't cross edges that turn by more: coarse tessellations turn by 28.6° (0.5 rad)."""

KINDS: tuple[Kind, ...] = ("cylinder", "cone", "sphere", "torus")
"""Ruled kinds first: two rings of vertices lie on a cylinder or cone, but also on spheres."""

SIMPLER = 3e-4
"""Share of a region's height that a simpler surface may leave: less than any modelled draft."""

BATCH = 128
"""Patches fitted together: enough to spread numpy's overhead, few enough for the cache."""


PASSES: tuple[tuple[int, int | None], ...] = ((3, None), (1, None), (0, 64))
"""Spacing of the seeds in each pass, in facets, and the largest group of unexplained facets that
the pass looks at: only small groups deserve a try from every facet."""

MOST = 400
"""Seeds tried at once; more follow as long as they find something."""

FURTHER = 1.5
"""How many times the facets a less simple surface must explain."""

SHARE = 16
"""Seeds that an initial region gets in a pass: a face that needs more has been broken up by others,
and the pieces get their own in the next pass."""

FREEFORM = 0.03
"""A patch whose best torus leaves less than this share of the patch's own height, but more than
the tolerance, is smooth and no simple surface: further patches there would fail too."""


@dataclass(frozen=True)
class Hypothesis:
    """A surface that explains a patch: ``score`` counts its vertices beyond the unknowns."""

    kind: Kind
    surface: FloatArray
    seed: int
    score: int


def find_surfaces(
    mesh: Mesh,
    graph: FacetGraph,
    free: BoolArray,
    initial: IntArray,
    tolerance: float,
    smooth: FloatArray,
    rings: tuple[int, ...] = (2, 4, 8),
) -> list[Grown]:
    """Surfaces that connected facets lie on, largest evidence first.

    Args:
        mesh: the mesh.
        graph: its adjacency.
        free: (m,) facets that may be explained.
        initial: (m,) initial regions (paper, 5.2): each gets its share of the seeds.
        tolerance: distance that counts as none, mm.
        smooth: (m,) mm, residual of the best torus where facets were seen to be freeform, 0 where
            they were not; what is seen here is added for calls with wider tolerances.
        rings: sizes of the patches tried, in steps from facet to facet, rising; only the largest
            tells a simple surface from a freeform one.
    """
    free = free.copy()
    found: list[Grown] = []
    for spacing, largest in PASSES:
        while True:
            passable = _passable(graph, free)
            wanted = free & (smooth <= tolerance) & passable.any(axis=1)
            if largest is not None:
                wanted &= _component_size(graph, free) <= largest
            seeds = _fair(_seeds(mesh, graph, wanted, spacing), initial)
            more = len(seeds) > MOST
            if more:
                seeds = seeds[np.linspace(0, len(seeds) - 1, MOST).astype(np.int64)]
            known = len(found)
            for start in range(0, len(seeds), BATCH):
                batch = seeds[start : start + BATCH]
                found += _found_from(mesh, graph, batch, free, tolerance, smooth, rings)
            if not more or len(found) == known:
                break
    return found


def _found_from(
    mesh: Mesh,
    graph: FacetGraph,
    batch: IntArray,
    free: BoolArray,
    tolerance: float,
    smooth: FloatArray,
    rings: tuple[int, ...],
) -> list[Grown]:
    """Surfaces found from one batch of seeds; their facets are no longer free afterwards."""
    found: list[Grown] = []
    passable = _passable(graph, free)
    for size in rings:
        batch = batch[free[batch] & (smooth[batch] <= tolerance)]
        if not len(batch):
            break
        patches = patches_around(mesh, graph, batch, passable, size)
        hypotheses = explain(mesh, patches, tolerance, smooth if size == rings[-1] else None)
        hypotheses.sort(key=lambda h: -h.score)
        for h in hypotheses:
            if not free[h.seed] or smooth[h.seed] > tolerance:
                continue
            grown = _proved(mesh, graph, h, free, tolerance)
            if grown is not None:
                found.append(grown)
                free[grown.facets] = False
    return found


def _proved(
    mesh: Mesh, graph: FacetGraph, h: Hypothesis, free: BoolArray, tolerance: float
) -> Grown | None:
    """The region that a hypothesis grows to, None where it doesn't prove its surface."""
    touched = flood(mesh, graph, h.kind, h.surface, np.array([h.seed]), free, tolerance)
    if len(touched) < 4:
        return None
    rough = Grown(h.kind, h.surface, touched)
    sure = is_exact(mesh, rough)
    if not sure and drifts(mesh, graph, rough, tolerance):
        return None
    grown = simplest(mesh, graph, h, free, tolerance)
    if not sure:
        grown = _upgraded(mesh, graph, grown, free, tolerance)
    return grown if enough_evidence(mesh, graph, grown, tolerance) else None


def simplest(
    mesh: Mesh, graph: FacetGraph, h: Hypothesis, free: BoolArray, tolerance: float
) -> Grown:
    """Grow a hypothesis; where a simpler kind explains all that it found, grow that instead.

    Two coaxial rings of vertices lie on a sphere, but also on a cylinder or cone; a torus without
    a hole to speak of is a sphere.
    """
    grown = grow(mesh, graph, h.kind, h.surface, np.array([h.seed]), free, tolerance)
    if not len(grown.facets):
        return grown
    limit = max(tolerance, min(4.0 * tolerance, SIMPLER * sagitta(mesh, grown)))
    for kind in KINDS[: KINDS.index(h.kind)]:
        surface = fit_facets(mesh, kind, grown.facets)
        points = mesh.vertices[np.unique(mesh.triangles[grown.facets])]
        d, _ = distance(kind, surface[None], points[None])
        if np.abs(d).max() <= limit:
            other = grow(mesh, graph, kind, surface, grown.facets, free, limit)
            if len(other.facets) >= len(grown.facets):
                return other
    return grown


def _upgraded(
    mesh: Mesh, graph: FacetGraph, grown: Grown, free: BoolArray, tolerance: float
) -> Grown:
    """A less simple surface through a region, where it reaches much further.

    To within a tolerance a short piece of a torus lies on a cylinder, but only the torus goes on.
    """
    for kind in KINDS[KINDS.index(grown.kind) + 1 :]:
        if len(grown.facets):
            surface = fit_facets(mesh, kind, grown.facets)
            other = grow(mesh, graph, kind, surface, grown.facets, free, tolerance)
            if len(other.facets) > FURTHER * len(grown.facets):
                grown = other
    return grown


def explain(
    mesh: Mesh, patches: Patches, tolerance: float, smooth: FloatArray | None = None
) -> list[Hypothesis]:
    """The simplest surface that explains each patch, where one does.

    Plain least squares first; where a patch crosses a border, a robust fit may still find the
    surface that most of it lies on.

    Args:
        mesh: the mesh.
        patches: the patches.
        tolerance: distance that counts as none, mm.
        smooth: for large patches: where a torus fits well but not exactly, the patch is freeform,
            and its residual is noted here; no robust fits then.
    """
    hypotheses: list[Hypothesis] = []
    for robust in (False, True) if smooth is None else (False,):
        # A torus has too many unknowns to choose its points as well.
        for kind in KINDS[:-1] if robust else KINDS:
            if not len(patches.seed):
                return hypotheses
            floor = float(np.median(tolerance / patches.scale)) if robust else None
            local = fit_patches(
                kind, patches.points, patches.weights, patches.centroids, patches.normals, floor
            )
            world = to_world(local, patches.centre, patches.scale, kind)
            d, _ = distance(kind, local, patches.points)
            d = np.where(patches.weights > 0, np.abs(d), 0.0)
            inside = (d <= (tolerance / patches.scale)[:, None]) & (patches.weights > 0)
            score = inside.sum(axis=1) - UNKNOWNS[kind]
            on_seed, _ = distance(kind, world, mesh.corners[patches.seed])
            # A robust fit chooses its own points: it needs more of them to prove something.
            good = (score >= (3 if robust else 1)) & _is_finite(kind, local)
            good &= (np.abs(on_seed) <= tolerance).all(axis=1)
            hypotheses.extend(
                Hypothesis(kind, world[row], int(patches.seed[row]), int(score[row]))
                for row in np.flatnonzero(good)
            )
            if kind == "torus" and smooth is not None:
                worst = d.max(axis=1)
                freeform = ~good & (worst < FREEFORM * _sagitta(patches))
                for row in np.flatnonzero(freeform):
                    facets = patches.facets[row]
                    smooth[facets[facets >= 0]] = worst[row] * patches.scale[row]
            patches = patches.take(np.flatnonzero(~good))
    return hypotheses


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


def _component_size(graph: FacetGraph, free: BoolArray) -> IntArray:
    """(m,) number of free facets that hang together with each."""
    joined = np.logical_and(free[graph.pairs[:, 0]], free[graph.pairs[:, 1]])
    label = graph.components(joined, len(free))
    size: IntArray = np.bincount(label)[label]
    return size


def _seeds(mesh: Mesh, graph: FacetGraph, candidates: BoolArray, spacing: int) -> IntArray:
    """Facets spread over the candidates: large ones first, none within ``spacing`` steps."""
    index = np.flatnonzero(candidates)
    order = index[np.argsort(-mesh.areas[index], kind="stable")]
    covered = np.zeros(len(candidates), dtype=bool)
    seeds = []
    for facet in order:
        if covered[facet]:
            continue
        seeds.append(facet)
        front = np.array([facet])
        for _ in range(spacing):
            front = graph.neighbour[front].ravel()
            front = front[front >= 0]
            covered[front] = True
    return np.array(seeds, dtype=np.int64)


def _fair(seeds: IntArray, initial: IntArray) -> IntArray:
    """At most ``SHARE`` seeds of each initial region, spread over its own in their order."""
    if not len(seeds):
        return seeds
    group = initial[seeds]
    order = np.argsort(group, kind="stable")
    counts = np.unique(group[order], return_counts=True)[1]
    rank = np.arange(len(seeds)) - np.repeat(np.cumsum(counts) - counts, counts)
    stride = np.repeat(-(-counts // SHARE), counts)
    chosen = np.zeros(len(seeds), dtype=bool)
    chosen[order] = rank % stride == 0
    fair: IntArray = seeds[chosen]
    return fair
