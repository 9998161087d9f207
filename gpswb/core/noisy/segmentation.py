# SPDX-License-Identifier: LGPL-2.1-or-later
"""Multi-model fitting: hypotheses, labels, refitted surfaces, fewer regions, until it settles."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import IntArray
from gpswb.core.noisy.expansion import expand
from gpswb.core.noisy.hypotheses import find_models, lies_on
from gpswb.core.noisy.merging import drop_models, facets_of, merge_models
from gpswb.core.noisy.models import SAMPLE, Model, fit_models
from gpswb.core.noisy.noisy_mesh import NoisyMesh
from gpswb.core.robust.surfaces import distance

CYCLES = 3

FEW = 30

LARGER = 0.6

FINAL = 1500


def segment(noisy: NoisyMesh) -> tuple[list[Model], IntArray]:
    models, label = find_models(noisy)
    for _ in range(CYCLES):
        label = expand(noisy, models, label)
        models, label = _refitted(noisy, models, label)
        models, label = merge_models(noisy, models, label)
        label = drop_models(noisy, models, label)
    label = expand(noisy, models, label)
    label = absorb(noisy, models, label)
    return _refitted(noisy, models, label, FINAL)


def absorb(noisy: NoisyMesh, models: list[Model], label: IntArray) -> IntArray:
    """Give unexplained facets to the neighbour they are nearest to, in small groups only.

    Some vertices are off by four sigma; a group of facets that many are off is something else.
    """
    label = label.copy()
    graph = noisy.graph
    part = graph.components((label[graph.pairs] == -1).all(axis=1), len(label))
    size = np.bincount(part, minlength=len(label))
    todo = (label == -1) & (size[part] <= FEW)
    while todo.any():
        a, b = graph.pairs.T
        best = np.full(len(label), np.inf)
        take = np.full(len(label), -1, dtype=np.int64)
        for mine, other in ((a, b), (b, a)):
            rim = todo[mine] & (label[other] >= 0)
            for i in np.unique(label[other[rim]]):
                at = np.unique(mine[rim & (label[other] == i)])
                corners = noisy.mesh.corners[at].reshape(1, -1, 3)
                d = distance(models[i].kind, models[i].surface[None], corners)[0].reshape(-1, 3)
                cost = (d**2).sum(axis=1)
                better = cost < best[at]
                best[at[better]] = cost[better]
                take[at[better]] = i
        found = take >= 0
        if not found.any():
            break
        label[found] = take[found]
        todo &= ~found
    return label


def _refitted(
    noisy: NoisyMesh, models: list[Model], label: IntArray, sample: int = SAMPLE
) -> tuple[list[Model], IntArray]:
    groups = facets_of(label, len(models))
    kept = [g for g in groups if len(g) >= 4]
    fitted = fit_models(noisy, [_inliers(noisy, models, label, g) for g in kept], sample=sample)
    out = np.where(label == -2, -2, -1)
    found: list[Model] = []
    for facets, model in zip(kept, fitted, strict=True):
        if model is not None:
            out[facets] = len(found)
            found.append(model)
    return found, out


def _inliers(
    noisy: NoisyMesh, models: list[Model], label: IntArray, facets: IntArray
) -> IntArray:
    """Facets of a region that its surface explains on average; all where that is the smaller part.

    A region may hold a fillet of its border that is too small to be a region: it must not bend the
    surface.
    """
    core = facets[lies_on(noisy, models[label[facets[0]]], True)[facets]]
    return core if len(core) > LARGER * len(facets) else facets
