# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cylinders, cones, spheres and tori on which connected facets agree to within a tolerance.

Nominal vertices lie on their surface to rounding. A surface fitted to a part of the mesh that lies
in one face is therefore exact, and grows to the whole face; a part across a border fits nothing. So
all parts are fitted at once, the initial regions first; the surfaces that explain their part are
grown in order of evidence, and parts that aren't explained are halved and tried again.
"""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.robust.growth import Grown
from gpswb.core.robust.hypotheses import FEW, FREEFORM, Hypothesis
from gpswb.core.robust.parts import connected_parts, halves, spread_over
from gpswb.core.robust.patches import rings_of
from gpswb.core.robust.proof import LEAST, SAMPLE, proved
from gpswb.core.robust.topology import FacetGraph
from gpswb.core.robust.trials import Trials
from gpswb.core.robust.unbroken import unbroken_parts

CREASE = np.deg2rad(40.0)
"""Patches don't cross edges that turn by more: coarse tessellations turn by 28.6° (0.5 rad)."""

BATCH = 128
"""Parts fitted together: enough to spread numpy's overhead, few enough for the cache."""

LIKE = 16.0
"""Ratio of two neighbours' areas from which they are not of one part: the strips of a cylinder
beside the small facets of its fillet would be most of the part's size, and few of its facets."""

ALIKE = 30.0
"""Tolerances within which a part of one face lies near a surface: its pieces may lie on it."""

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


def find_surfaces(
    mesh: Mesh,
    graph: FacetGraph,
    free: BoolArray,
    initial: IntArray,
    tolerance: float,
    smooth: FloatArray,
    trials: Trials,
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
        trials: fits to parts so far.
        exact: whether the tolerance is that of rounding, so that few facets prove a surface.
    """
    free = free.copy()
    found: list[Grown] = []
    group = initial
    for _ in range(ROUNDS):
        new = _descend(mesh, graph, group, free, tolerance, smooth, trials, exact)
        found += new
        if sum(len(g.facets) for g in new) < WORTHWHILE * free.sum():
            break
        group = np.zeros(len(free), dtype=np.int64)
    return found + _around_seeds(mesh, graph, free, tolerance, smooth, trials, exact)


def _descend(
    mesh: Mesh,
    graph: FacetGraph,
    group: IntArray,
    free: BoolArray,
    tolerance: float,
    smooth: FloatArray,
    trials: Trials,
    exact: bool,
) -> list[Grown]:
    """Surfaces of parts, of their halves, and so on; their facets are no longer free afterwards."""
    found: list[Grown] = []
    doubt = np.zeros(len(free))
    least = LEAST
    flat = _smooth_and_alike(mesh, graph, free)
    links = graph.pairs[flat]
    while True:
        open_ = free & (smooth <= tolerance)
        part = connected_parts(np.where(open_, group, -1), links)
        facets, size = spread_over(part, SAMPLE)
        order = np.argsort(-size, kind="stable")
        order = order[size[order] >= least]
        if not len(order):
            return found
        tried = np.zeros(len(size), dtype=bool)
        left, freeform = np.zeros(len(size)), np.full(len(size), np.nan)
        for start in range(0, len(order), BATCH):
            batch = order[start : start + BATCH]
            known = len(found)
            trial = trials.of(facets[batch], size[batch], tolerance)
            batch = batch[trial.bent]
            if not len(batch):
                continue
            tried[batch] = True
            found += _grow_all(mesh, graph, trial.hypotheses, free, tolerance)
            freeform[batch] = trial.freeform[trial.bent]
            far = trial.residual > np.maximum(ALIKE * tolerance, FREEFORM * trial.bend)
            left[batch] = np.where(far & trial.fresh, trial.residual, 0.0)[trial.bent]
            if start >= MOST and len(found) == known:
                break
        _note_freeform(freeform, part, doubt, smooth)
        least = LEAST if exact else FEW
        part = np.where(free, part, -1)
        whole = unbroken_parts(mesh, graph, part, flat, left > 0.0)
        # What is of one face, and isn't near any surface, has no part that is on one.
        inside = np.append(whole, False)[part]
        smooth[inside] = np.append(left, 0.0)[part[inside]]
        worth = np.append(tried & (size > least) & ~whole, False)
        group = halves(np.where(worth[part], part, -1), links)


def _note_freeform(
    freeform: FloatArray, part: IntArray, doubt: FloatArray, smooth: FloatArray
) -> None:
    """Note that parts look freeform.

    Args:
        freeform: (k,) mm, what the parts' tori leave, 0 where they don't look so, NaN where none
            was fitted.
        part: (m,) part of each facet, -1 for none.
        doubt: (m,) mm, what the torus of the whole left that each part is a half of; brought up to
            date. Where that looked freeform, too, it is noted in ``smooth`` (m,).
    """
    seen = np.append(freeform, np.nan)[part]
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
    for h in sorted(hypotheses, key=lambda h: -h.score):
        if not free[h.seed]:
            continue
        grown = proved(mesh, graph, h, free, tolerance)
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
    trials: Trials,
    exact: bool,
) -> list[Grown]:
    """Surfaces from the neighbourhoods of facets that are left.

    Halves may cut a narrow face lengthwise, its neighbourhoods don't. Every facet of a small group
    is tried; of large groups, where the tolerance is that of rounding, some that are spread.
    """
    found: list[Grown] = []
    for rings in RINGS:
        group = connected_parts(np.where(free, 0, -1), graph.pairs[graph.within(free)])
        few = np.append(np.bincount(group[group >= 0]) <= SMALL, False)[group]
        open_ = free & (smooth <= tolerance)
        open_[open_] = graph.passable(free, np.flatnonzero(open_), CREASE).any(axis=1)
        seeds = np.flatnonzero(open_ & few)
        if exact:
            seeds = np.concatenate([seeds, _spread(mesh, graph, open_ & ~few, rings)])
        seeds = seeds[np.argsort(-mesh.areas[seeds], kind="stable")][:MOST]
        for start in range(0, len(seeds), BATCH):
            batch = seeds[start : start + BATCH]
            batch = batch[free[batch]]
            batch = batch[graph.passable(free, batch, CREASE).any(axis=1)]
            if not len(batch):
                continue
            facets = rings_of(
                graph, batch[:, None], lambda f: graph.passable(free, f, CREASE), rings
            )
            trial = trials.of(facets, (facets >= 0).sum(axis=1), tolerance)
            found += _grow_all(mesh, graph, trial.hypotheses, free, tolerance)
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


def _smooth_and_alike(mesh: Mesh, graph: FacetGraph, free: BoolArray) -> BoolArray:
    """(e,) pairs of free facets of like areas without a crease between them."""
    chosen: BoolArray = (graph.pair_dihedral < CREASE) & graph.within(free)
    first, second = np.maximum(mesh.areas[graph.pairs[chosen].T], 1e-300)
    chosen[chosen] = np.abs(np.log(first / second)) < np.log(LIKE)
    return chosen
