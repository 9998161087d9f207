# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions joined where one surface describes both, and dropped where their neighbours do."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gpswb.core.mesh import FloatArray, IntArray
from gpswb.core.noisy.expansion import border_prices, facet_costs
from gpswb.core.noisy.models import Model, Surface, fit_models
from gpswb.core.noisy.noisy_mesh import NoisyMesh

SMOOTH = 0.5
"""Mean turn (rad) of the denoised normals across a border, at most, for one surface to continue
there: coarse meshes turn by 0.26 rad, averaging lowers what creases turn by."""

REGION = 24.0
"""Price of a region of its own, in the unit of chi-square (twice nats), besides its unknowns."""


def merge_models(
    noisy: NoisyMesh, models: Sequence[Model], label: IntArray
) -> tuple[list[Model], IntArray]:
    """Join neighbours as long as one surface describes two regions for less.

    Description length: chi-square of the vertices, plus ln n for each unknown, plus a price a
    region. The best pairs that have no region in common are joined at once.
    """
    models = list(models)
    label = label.copy()
    tried: set[tuple[int, int]] = set()
    while True:
        groups = facets_of(label, len(models))
        candidates = [p for p in smooth_neighbours(noisy, label) if p not in tried]
        tried.update(candidates)
        if not candidates:
            break
        unions = [np.concatenate([groups[a], groups[b]]) for a, b in candidates]
        fitted = fit_models(noisy, unions)
        gains = []
        for (a, b), union, model in zip(candidates, unions, fitted, strict=True):
            if model is None or not model.explains:
                continue
            before = length_of(noisy, models[a], groups[a])
            before += length_of(noisy, models[b], groups[b])
            gain = before - length_of(noisy, model, union)
            if gain > 0.0:
                gains.append((gain, a, b, model))
        used: set[int] = set()
        for _, a, b, model in sorted(gains, key=lambda g: -g[0]):
            if a in used or b in used:
                continue
            used |= {a, b}
            label[groups[b]] = a
            models[a] = model
        if not used:
            break
        tried = {p for p in tried if not used & set(p)}
    return models, label


def drop_models(noisy: NoisyMesh, models: Sequence[Surface], label: IntArray) -> IntArray:
    """Give regions away whose neighbours describe them for less than they cost; smallest first."""
    label = label.copy()
    graph = noisy.graph
    price = border_prices(noisy)
    groups = facets_of(label, len(models))
    for i in sorted(range(len(models)), key=lambda i: len(groups[i])):
        facets = np.flatnonzero(label == i)
        if not len(facets):
            continue
        own = facet_costs(noisy, models[i], facets)
        near = graph.neighbour[facets]
        around = np.unique(label[near[near >= 0]])
        around = around[(around >= 0) & (around != i)]
        if not len(around):
            continue
        cost = np.array([facet_costs(noisy, models[j], facets) for j in around])
        least = cost.min(axis=0)
        touched = (label[graph.pairs] == i).any(axis=1)
        border = _border(label, graph.pairs[touched], price[touched])
        trial = label.copy()
        trial[facets] = around[cost.argmin(axis=0)]
        border -= _border(trial, graph.pairs[touched], price[touched])
        worth = 2.0 * (least.sum() - own.sum() - border)
        if worth < models[i].price(len(noisy.vertices_of(facets))) + REGION:
            label = trial
    return label


def _border(label: IntArray, pairs: IntArray, price: FloatArray) -> float:
    """Price of the borders along some edges."""
    return float(price[label[pairs[:, 0]] != label[pairs[:, 1]]].sum())


def facets_of(label: IntArray, count: int) -> list[IntArray]:
    """Facets of each label 0..count-1."""
    order = np.argsort(label, kind="stable")
    bounds = np.searchsorted(label[order], np.arange(count + 1))
    return [order[bounds[i] : bounds[i + 1]] for i in range(count)]


def smooth_neighbours(noisy: NoisyMesh, label: IntArray) -> list[tuple[int, int]]:
    """Pairs of regions that meet without a crease along most of their border."""
    pair = np.sort(label[noisy.graph.pairs], axis=1)
    border = (pair[:, 0] != pair[:, 1]) & (pair[:, 0] >= 0)
    pair, turn = pair[border], noisy.pair_turn[border]
    unique, which = np.unique(pair, axis=0, return_inverse=True)
    which = which.reshape(-1)
    count = np.bincount(which, minlength=len(unique))
    mean = np.bincount(which, turn, minlength=len(unique)) / np.maximum(count, 1)
    return [(int(a), int(b)) for a, b in unique[mean < SMOOTH]]


def length_of(noisy: NoisyMesh, model: Surface, facets: IntArray) -> float:
    """Description length of a region on a surface, in the unit of chi-square."""
    n = len(noisy.vertices_of(facets))
    chi = 2.0 * float(facet_costs(noisy, model, facets).sum())
    return chi + model.price(n) + REGION
