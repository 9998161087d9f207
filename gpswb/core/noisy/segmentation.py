# SPDX-License-Identifier: LGPL-2.1-or-later
"""Multi-model fitting: hypotheses, labels, refitted surfaces, fewer regions, until it settles."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import IntArray, Mesh
from gpswb.core.noisy.absorption import absorb
from gpswb.core.noisy.chains import divide_by_profiles
from gpswb.core.noisy.expansion import expand
from gpswb.core.noisy.freeform import Freeform
from gpswb.core.noisy.hypotheses import find_models, lies_on
from gpswb.core.noisy.joining import join_regions
from gpswb.core.noisy.merging import drop_models, facets_of, merge_models
from gpswb.core.noisy.models import SAMPLE, Model, Surface, fit_models
from gpswb.core.noisy.noisy_mesh import NoisyMesh
from gpswb.core.noisy.swept import Swept
from gpswb.core.robust.growth import Grown, fit_facets

CYCLES = 3
"""Rounds of labelling and fitting; labels hardly change in the third."""

FINAL = 1500
"""Vertices of a region that the last fit uses: it decides the kind."""

FEW = 12
"""Facets without a surface that are taken for a plane: fewer could prove nothing else."""

CORE = 0.6
"""Share of a region that its surface must explain for the rest to be left out of the fit."""


def segment(mesh: Mesh, sigma: float) -> tuple[list[Grown], IntArray, dict[int, InvarianceClass]]:
    """Divide a noisy mesh into regions that lie on simple surfaces, swept ones, and others.

    Args:
        mesh: the mesh.
        sigma: noise of the vertices, mm, > 0.

    Returns:
        The simple surfaces with their facets; (m,) int64 labels: the number of each facet's
        surface, and numbers of their own beyond these for swept regions and for connected facets
        that no surface explains; the classes of the swept ones by label.
    """
    noisy = NoisyMesh.of(mesh, sigma)
    models, label = find_models(noisy)
    for _ in range(CYCLES):
        models, label = _cycle(noisy, models, label)
    count = len(models)
    models, label = divide_by_profiles(noisy, models, label)
    if len(models) > count:
        models, label = _cycle(noisy, models, label)
    joined, label = join_regions(noisy, models, label)
    label = expand(noisy, joined, label)
    label = drop_models(noisy, joined, label)
    label = absorb(noisy, joined, label)
    return _described(noisy, joined, label)


def _cycle(noisy: NoisyMesh, models: list[Model], label: IntArray) -> tuple[list[Model], IntArray]:
    """One round: facets labelled, surfaces fitted, regions joined and dropped."""
    label = expand(noisy, models, label)
    models, label = _refitted(noisy, models, label)
    models, label = merge_models(noisy, models, label)
    return models, drop_models(noisy, models, label)


def _described(
    noisy: NoisyMesh, found: Sequence[Surface], label: IntArray
) -> tuple[list[Grown], IntArray, dict[int, InvarianceClass]]:
    """What `segment` returns."""
    simple = np.array([isinstance(surface, Model) for surface in found] + [False])
    models = [surface for surface in found if isinstance(surface, Model)]
    rank = np.append(np.cumsum(simple[:-1]) - 1, -1)
    models, out = _refitted(noisy, models, np.where(simple[label], rank[label], -1), last=True)
    groups = facets_of(out, len(models))
    surfaces = [Grown(m.kind, m.surface, g) for m, g in zip(models, groups, strict=True)]
    special = [
        (surface.invariance_class, np.flatnonzero(label == i))
        for i, surface in enumerate(found)
        if isinstance(surface, Swept | Freeform)
    ]
    loose = _unexplained(noisy, label)
    for facets in loose:
        if len(facets) < FEW:
            out[facets] = len(surfaces)
            surfaces.append(Grown("plane", fit_facets(noisy.mesh, "plane", facets), facets))
    names: dict[int, InvarianceClass] = {}
    for name, facets in special:
        names[len(surfaces) + len(names)] = name
        out[facets] = len(surfaces) + len(names) - 1
    count = len(surfaces) + len(names)
    for number, facets in enumerate(f for f in loose if len(f) >= FEW):
        out[facets] = count + number
    return surfaces, out, names


def _unexplained(noisy: NoisyMesh, label: IntArray) -> list[IntArray]:
    """Facets without a surface, as far as they hang together, small groups first."""
    none = np.flatnonzero((label < 0) & (noisy.mesh.areas > 0.0))
    both = np.logical_and(*(label < 0)[noisy.graph.pairs].T)
    part = noisy.graph.components(both, len(label))[none]
    order = np.argsort(part, kind="stable")
    groups = np.split(none[order], np.flatnonzero(np.diff(part[order])) + 1)
    return sorted((g for g in groups if len(g)), key=len)


def _refitted(
    noisy: NoisyMesh, models: list[Model], label: IntArray, last: bool = False
) -> tuple[list[Model], IntArray]:
    """The likeliest surface of each region, of any kind; labels numbered anew."""
    kept = [g for g in facets_of(label, len(models)) if len(g)]
    cores = [_core(noisy, models[label[g[0]]], g) for g in kept]
    fitted = fit_models(noisy, cores, FINAL if last else SAMPLE, thorough=last)
    out = np.full_like(label, -1)
    found: list[Model] = []
    for facets, model in zip(kept, fitted, strict=True):
        if model is not None:
            out[facets] = len(found)
            found.append(model)
    return found, out


def _core(noisy: NoisyMesh, model: Model, facets: IntArray) -> IntArray:
    """Facets of a region that its surface explains, neighbours averaged, if they are most of it.

    A region may hold a fillet along its border that is too small to be a region of its own: that
    must not bend the surface.
    """
    core = facets[lies_on(noisy, model, averaged=True)[facets]]
    return core if len(core) > CORE * len(facets) else facets
