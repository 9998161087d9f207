# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small exact pieces of a surface give the whole surface, to rounding."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from known_surfaces import CURVED, Frame, misfit, patch_mesh, surface_of

from gpswb.core.robust.first_guess import velocity_moments
from gpswb.core.robust.fitting import fit_patches
from gpswb.core.robust.growth import fit_facets, to_world
from gpswb.core.robust.patches import patches_around
from gpswb.core.robust.surfaces import Kind, distance
from gpswb.core.robust.topology import FacetGraph

seeds = st.integers(0, 10**6)


@pytest.mark.parametrize("kind", ["plane", *CURVED])
@settings(max_examples=30)
@given(seed=seeds)
def test_a_small_exact_patch_gives_its_surface(kind: Kind, seed: int) -> None:
    frame = Frame(seed)
    mesh = patch_mesh(kind, frame)
    found = fit_facets(mesh, kind, np.arange(len(mesh.triangles)))
    assert misfit(kind, found, surface_of(kind, frame)) < 1e-7


@pytest.mark.parametrize("kind", CURVED)
def test_all_patches_of_a_mesh_are_fitted_together(kind: Kind) -> None:
    frame = Frame(11)
    mesh = patch_mesh(kind, frame, n=10, size=2.0)
    graph = FacetGraph.of(mesh)
    seeds = np.arange(0, len(mesh.triangles), 5)
    patches = patches_around(mesh, graph, seeds, graph.neighbour >= 0, 10)
    local = fit_patches(kind, patches.points, patches.weights, patches.centroids, patches.normals)
    world = to_world(local, patches.centre, patches.scale, kind)
    for row in world:
        assert misfit(kind, row, surface_of(kind, frame)) < 1e-6


@pytest.mark.parametrize("kind", CURVED)
def test_a_robust_fit_keeps_to_the_majority(kind: Kind) -> None:
    frame = Frame(2)
    mesh = patch_mesh(kind, frame, n=8)
    vertices = mesh.vertices.copy()
    far = np.arange(len(vertices)) % 9 == 0  # a ninth stands off by 0.2 mm
    vertices[far] += 0.2 * frame.rotation[:, 0]
    centre = vertices.mean(axis=0)
    scale = np.abs(vertices - centre).max()
    share = np.sqrt(mesh.areas / mesh.areas.sum())[:, None]
    arguments = (
        kind,
        (vertices - centre)[None] / scale,
        np.ones((1, len(vertices))),
        (mesh.centroids - centre)[None] / scale,
        (mesh.facet_normals * share)[None],
    )
    worst = []
    for floor in (1e-6, None):
        local = fit_patches(*arguments, floor)
        surface = to_world(local, centre[None], np.array([scale]), kind)
        d = np.abs(distance(kind, surface, mesh.vertices[None])[0][0])
        worst.append(d[~far].max())
    assert worst[0] < 1e-4 < worst[1]


@given(seed=seeds)
def test_velocity_moments_are_mean_squared_velocities(seed: int) -> None:
    rng = np.random.default_rng(seed)
    points, weight = rng.normal(size=(2, 7, 3)), rng.random((2, 7))
    twist = rng.normal(size=6)
    velocity = np.cross(twist[:3], points) + twist[3:]
    expected = np.einsum("bf,bfk,bfk->b", weight, velocity, velocity)
    found = np.einsum("i,bij,j->b", twist, velocity_moments(points, weight), twist)
    assert found == pytest.approx(expected)


def test_patches_hold_the_facets_within_reach_and_no_others() -> None:
    mesh = patch_mesh("sphere", Frame(0))
    graph = FacetGraph.of(mesh)
    passable = graph.neighbour >= 0
    passable[:, :] &= (np.arange(len(mesh.triangles)) % 7 != 3)[:, None]
    patches = patches_around(mesh, graph, np.array([20, 45]), passable, 3)
    for row, seed in enumerate((20, 45)):
        reach = {seed}
        for _ in range(3):
            reach |= {int(graph.neighbour[f, k]) for f in reach for k in range(3) if passable[f, k]}
        assert set(patches.facets[row].tolist()) - {-1} == reach
        corners = set(mesh.triangles[sorted(reach)].ravel().tolist())
        assert set(patches.vertices[row].tolist()) - {-1} == corners
        real = patches.weights[row] > 0
        world = patches.centre[row] + patches.scale[row] * patches.points[row][real]
        assert np.abs(world - mesh.vertices[patches.vertices[row][real]]).max() < 1e-12
        assert np.abs(patches.points[row]).max() == pytest.approx(1.0)
        assert (patches.normals[row] ** 2).sum() == pytest.approx(1.0)
