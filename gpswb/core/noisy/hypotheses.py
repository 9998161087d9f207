# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces that patches of falling size lie on within the noise, grown to all they explain."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import BoolArray, IntArray
from gpswb.core.noisy.models import Model, fit_models, refit
from gpswb.core.noisy.noisy_mesh import NoisyMesh
from gpswb.core.robust.patches import patches_around

RINGS = (20, 12, 7, 4, 2)
"""Steps from the seed facet to the rim of its patch. Large patches come first: they tell kinds
apart, and small ones lie on many surfaces."""

CREASES = (0.6, 0.3, 0.15)
"""Turns (rad) of the denoised normals at which the mesh may be cut into components. The first is
more than a coarse mesh turns by; patches stop there, too."""

SEEDS = 600
"""Patches of one size at most."""

OVERLAP = 4
"""Patches that a facet lies in, on average: a seed at a border fails, the next may not."""

LEAST = 6
"""Facets of a group at least: fewer have hardly more vertices than a plane has unknowns."""

UNCLAIMED = 0.6
"""Share of a group that no other surface may have taken before its turn."""

KEPT = 0.5
"""Share of its seed that a surface must keep when it is grown."""

GATE = 3.0
"""Distance in sigma up to which a vertex may belong to a surface."""

STRIP = 2
"""Patches of so few rings may be strips, in which every vertex is near the rim: their facets aren't
judged by averages."""

TILT = 0.8
"""Angle (rad) between denoised normal and surface up to which a facet may belong to it."""

ROUNDS = 6
"""Rounds of growing and fitting at most."""


def find_models(noisy: NoisyMesh) -> tuple[list[Model], IntArray]:
    """Surfaces and the facets each was grown to.

    Args:
        noisy: the mesh and its noise.

    Returns:
        The models and (m,) int64 the number of each facet's model, -1 for none.
    """
    random = np.random.default_rng(0)
    label = np.full(len(noisy.mesh.triangles), -1, dtype=np.int64)
    models: list[Model] = []
    for rings in RINGS:
        for propose in (_components, _patches):
            free = (label < 0) & (noisy.mesh.areas > 0.0)
            if free.any():
                _claim(noisy, propose(noisy, free, rings, random), label, models, rings > STRIP)
    return models, label


def _claim(
    noisy: NoisyMesh, groups: list[IntArray], label: IntArray, models: list[Model], averaged: bool
) -> None:
    """Grow the surfaces that explain their group, those of large groups first."""
    usable = noisy.mesh.areas > 0.0
    hypotheses = fit_models(noisy, groups)
    for i in sorted(range(len(groups)), key=lambda i: -len(groups[i])):
        model = hypotheses[i]
        seed = groups[i][label[groups[i]] < 0]
        if model is None or not model.explains or len(seed) < UNCLAIMED * len(groups[i]):
            continue
        model, facets = grow(noisy, model, seed, usable & (label < 0), averaged)
        if len(facets) >= KEPT * len(seed) and model.explains:
            label[facets] = len(models)
            models.append(model)


def _components(
    noisy: NoisyMesh, free: BoolArray, rings: int, random: np.random.Generator
) -> list[IntArray]:
    """What hangs together without a crease, for several ideas of what a crease is.

    A face between creases is one such component, and so is a fillet once what it rounds is known.
    """
    groups = []
    graph = noisy.graph
    joined = free[graph.pairs].all(axis=1)
    for crease in CREASES:
        part = graph.components(joined & (noisy.pair_turn < crease), len(free))
        index = np.flatnonzero(free)
        index = index[np.argsort(part[index], kind="stable")]
        start = np.flatnonzero(np.diff(part[index], prepend=-1))
        groups += [g for g in np.split(index, start[1:]) if len(g) >= LEAST]
    return groups


def _patches(
    noisy: NoisyMesh, free: BoolArray, rings: int, random: np.random.Generator
) -> list[IntArray]:
    """Patches around random seeds; those of which borders leave less than half are left out."""
    graph = noisy.graph
    turn = np.linalg.norm(
        noisy.normals[:, None] - noisy.normals[np.maximum(graph.neighbour, 0)], axis=2
    )
    passable = (graph.neighbour >= 0) & free[np.maximum(graph.neighbour, 0)] & (turn < CREASES[0])
    index = np.flatnonzero(free)
    size = 1.5 * rings**2 + 3 * rings + 1
    count = int(min(max(OVERLAP * len(index) / size, 8), SEEDS, len(index)))
    seeds = random.choice(index, count, replace=False)
    groups = []
    for start in range(0, len(seeds), 64):
        batch = seeds[start : start + 64]
        found = patches_around(noisy.mesh, graph, batch, passable, rings)
        groups += [row[row >= 0] for row in found.facets]
    least = max(0.5 * size, LEAST) if rings > RINGS[-1] else LEAST
    return [g for g in groups if len(g) >= least]


def grow(
    noisy: NoisyMesh, model: Model, seed: IntArray, free: BoolArray, averaged: bool
) -> tuple[Model, IntArray]:
    """Take in the connected facets that lie on a surface, and fit it again, until it settles.

    Args:
        noisy: the mesh and its noise.
        model: the surface.
        seed: facets to start from.
        free: (m,) facets that may be taken.
        averaged: see `lies_on`.
    """
    graph = noisy.graph
    facets = seed
    for step in range(ROUNDS):
        ok = free & lies_on(noisy, model, averaged)
        joined = ok[graph.pairs[:, 0]] & ok[graph.pairs[:, 1]]
        part = graph.components(joined, len(free))
        inside = seed[ok[seed]]
        if not len(inside):
            return model, inside
        home = np.bincount(part[inside]).argmax()
        found = np.flatnonzero(ok & (part == home))
        settled = len(found) <= 1.02 * len(facets) and step > 0
        facets = found
        if settled:
            break
        model = refit(noisy, model, facets)
        if not model.explains:
            other = fit_models(noisy, [facets])[0]
            if other is None or not other.explains:
                break
            model = other
    return model, facets


def lies_on(noisy: NoisyMesh, model: Model, averaged: bool) -> BoolArray:
    """(m,) facets that lie on a surface within the noise and face the same way.

    Each corner by itself is within the gate; and, if ``averaged``, so is the mean over the vertices
    around: where a surface drifts away, neighbours are all off to the same side.
    """
    mesh = noisy.mesh
    d = model.distance(mesh.vertices)[0] / noisy.sigma
    near: BoolArray = np.asarray(np.abs(d) <= GATE, dtype=bool)
    ok: BoolArray = np.asarray(near[mesh.triangles].all(axis=1), dtype=bool)
    if averaged:
        weight = noisy.around_squared @ near.astype(np.float64)
        drift = noisy.around @ (d * near) / np.sqrt(np.maximum(weight, 1.0))
        ok &= np.abs(drift[mesh.triangles].mean(axis=1)) <= GATE
    index = np.flatnonzero(ok)
    toward = model.distance(mesh.centroids[index])[1]
    cosine = model.side * np.einsum("ik,ik->i", toward, noisy.normals[index])
    ok[index[cosine < np.cos(TILT)]] = False
    return ok
