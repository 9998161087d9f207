# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces that patches of falling size lie on within the noise, grown to all they explain."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import BoolArray, FloatArray, IntArray
from gpswb.core.noisy.models import Model, fit_models, refit
from gpswb.core.noisy.noisy_mesh import NoisyMesh
from gpswb.core.robust.patches import patches_around
from gpswb.core.robust.surfaces import distance
from gpswb.core.robust.topology import FacetGraph

RINGS = (20, 12, 7, 4, 2)
"""Steps from the seed facet to the rim of its patch. Large patches come first: they tell kinds
apart, and small ones lie on many surfaces."""

CREASE = 0.6
"""Turn (rad) of the denoised normals at which no patch goes on."""

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

    Returns:
        The models and (m,) int64 the number of each facet's model, -1 for none.
    """
    mesh, graph, normals = noisy.mesh, noisy.graph, noisy.normals
    random = np.random.default_rng(0)
    label = np.where(mesh.areas > 0.0, -1, -2)
    models: list[Model] = []
    turn = _turn(graph, normals)
    for rings in RINGS:
        for _ in range(2):
            free = label == -1
            index = np.flatnonzero(free)
            if not len(index):
                break
            passable = (graph.neighbour >= 0) & free[np.maximum(graph.neighbour, 0)]
            passable &= turn < CREASE
            size = 1.5 * rings**2 + 3 * rings + 1
            count = int(min(max(4.0 * len(index) / size, 8), 600, len(index)))
            seeds = random.choice(index, count, replace=False)
            groups = []
            for start in range(0, len(seeds), 64):
                found = patches_around(mesh, graph, seeds[start : start + 64], passable, rings)
                groups += [row[row >= 0] for row in found.facets]
            groups = [g for g in groups if len(g) >= 6]
            hypotheses = fit_models(noisy, groups)
            good = [
                (len(g), i)
                for i, (g, h) in enumerate(zip(groups, hypotheses, strict=True))
                if h is not None and h.explains
            ]
            for _, i in sorted(good, reverse=True):
                model = hypotheses[i]
                still = groups[i][label[groups[i]] == -1]
                if model is None or len(still) < 0.6 * len(groups[i]):
                    continue
                model, facets = grow(noisy, model, still, label == -1, rings > STRIP)
                if len(facets) >= 0.5 * len(still) and model.explains:
                    label[facets] = len(models)
                    models.append(model)
    return models, np.where(label == -2, -1, label)


def grow(
    noisy: NoisyMesh, model: Model, seed: IntArray, free: BoolArray, averaged: bool
) -> tuple[Model, IntArray]:
    """Take in the connected facets that lie on a surface, and fit it again, until it settles."""
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
    d = distance(model.kind, model.surface[None], mesh.vertices[None])[0][0] / noisy.sigma
    near = np.abs(d) <= GATE
    ok: BoolArray = near[mesh.triangles].all(axis=1)
    if averaged:
        squares = noisy.around.multiply(noisy.around) @ near.astype(np.float64)
        drift = noisy.around @ (d * near) / np.sqrt(np.maximum(squares, 1.0))
        ok &= np.abs(drift[mesh.triangles].mean(axis=1)) <= GATE
    index = np.flatnonzero(ok)
    toward = distance(model.kind, model.surface[None], mesh.centroids[index][None])[1][0]
    cosine = model.side * np.einsum("ik,ik->i", toward, noisy.normals[index])
    ok[index[cosine < np.cos(TILT)]] = False
    return ok


def _turn(graph: FacetGraph, normals: FloatArray) -> FloatArray:
    """(m, 3) angle between each facet's normal and those across its edges."""
    other = normals[np.maximum(graph.neighbour, 0)]
    cosine = np.einsum("mk,mek->me", normals, other)
    sine = np.linalg.norm(np.cross(normals[:, None], other), axis=2)
    angle: FloatArray = np.arctan2(sine, cosine)
    return angle
