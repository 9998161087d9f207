# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions side by side that have a motion in common, divided anew by the profile of all of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray, IntArray
from gpswb.core.noisy.general_surface import LEAST, SLIP, priced
from gpswb.core.noisy.merging import REGION, facets_of, length_of, smooth_neighbours
from gpswb.core.noisy.models import Model
from gpswb.core.noisy.noisy_mesh import NoisyMesh
from gpswb.core.noisy.profile_chain import Chain, profile_chain
from gpswb.core.noisy.swept_fit import fit_swept
from gpswb.core.recognition import slip_of
from gpswb.core.reference import Reference


def divide_by_profiles(
    noisy: NoisyMesh, models: Sequence[Model], label: IntArray
) -> tuple[list[Model], IntArray]:
    """Replace connected regions of one motion by the chain that is their profile, if it is shorter.

    On the surface itself a narrow round between two planes has few facets across, and neighbours
    divide it among themselves. Around the axis, or along the direction, it has many. What is saved
    has to be worth a region: the same regions are a little cheaper as a chain, since they share the
    motion. Where one spline describes all for less than the chain, nothing is divided.

    Args:
        noisy: the mesh and its noise.
        models: the surfaces.
        label: (m,) the number of each facet's surface, -1 for none.

    Returns:
        Surfaces, and labels numbered anew.
    """
    models, label = list(models), label.copy()
    near = _neighbours(noisy, label, len(models))
    done: set[int] = set()
    groups = facets_of(label, len(models))
    tried: set[tuple[InvarianceClass, frozenset[int]]] = set()
    for seed in sorted(range(len(models)), key=lambda i: -len(groups[i])):
        if seed in done or not len(groups[seed]):
            continue
        for name, reference in _motions(models[seed]):
            group = _sharing(noisy, groups, near, seed, name, reference, done)
            if (name, frozenset(group)) in tried:
                continue
            tried.add((name, frozenset(group)))
            before = sum(length_of(noisy, models[i], groups[i]) for i in group)
            facets = np.concatenate([groups[i] for i in group])
            chain = _chain(noisy, facets, name, reference, before - REGION)
            if chain is not None:
                for part, model in chain.parts:
                    label[part] = len(models)
                    models.append(model)
                done |= set(group)
                break
    return models, label


def _chain(
    noisy: NoisyMesh, facets: IntArray, name: InvarianceClass, reference: Reference, most: float
) -> Chain | None:
    """The chain of some facets that is shorter than ``most`` and than one spline of all."""
    if len(facets) < LEAST:
        return None
    swept = fit_swept(noisy, facets, name, [reference])
    if swept is None or not swept.explains:
        return None
    chain = profile_chain(noisy, facets, swept)
    one = priced(swept) + REGION
    return chain if chain is not None and chain.length < min(most, one) else None


def _motions(model: Model) -> Iterator[tuple[InvarianceClass, Reference]]:
    """The motions that a surface has and its neighbours may share."""
    reference = Reference(model.surface[:3], model.surface[3:6])
    if model.kind == "cylinder":
        yield "prismatic", reference
    if model.kind in ("cylinder", "cone", "torus"):
        yield "revolute", reference


def _neighbours(noisy: NoisyMesh, label: IntArray, count: int) -> list[set[int]]:
    near: list[set[int]] = [set() for _ in range(count)]
    for a, b in smooth_neighbours(noisy, label):
        near[a].add(b)
        near[b].add(a)
    return near


def _sharing(
    noisy: NoisyMesh,
    groups: Sequence[IntArray],
    near: Sequence[set[int]],
    seed: int,
    name: InvarianceClass,
    reference: Reference,
    done: set[int],
) -> list[int]:
    """The regions that hang together with one and slip along its motion."""
    group, front = {seed}, [seed]
    while front:
        for i in near[front.pop()] - group - done:
            if _slip(noisy, groups[i], name, reference) < SLIP:
                group.add(i)
                front.append(i)
    return sorted(group)


def _slip(noisy: NoisyMesh, facets: IntArray, name: InvarianceClass, reference: Reference) -> float:
    mesh = noisy.mesh
    areas: FloatArray = mesh.areas[facets]
    return slip_of(mesh.centroids[facets], noisy.normals[facets], areas, name, reference)
