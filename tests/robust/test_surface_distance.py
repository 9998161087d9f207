# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distances to the five surfaces against their geometry, derivatives against differences."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from known_surfaces import CURVED, HALF_ANGLE, SIZES, Frame, point_on, surface_of

from gpswb.core.robust.growth import slide, to_local, to_world
from gpswb.core.robust.surfaces import (
    UNKNOWNS,
    Kind,
    distance,
    distance_jacobian,
    largest_curvature,
)

KINDS: tuple[Kind, ...] = ("plane", *CURVED)
seeds = st.integers(0, 10**6)


def grid() -> tuple[np.ndarray, np.ndarray]:
    u, v = np.meshgrid(np.linspace(-3.0, 3.0, 9), np.linspace(-1.3, 1.2, 7), indexing="ij")
    return u.ravel(), v.ravel()


@pytest.mark.parametrize("off", [-1.5, 0.0, 0.01, 2.0])
@pytest.mark.parametrize("kind", KINDS)
def test_points_along_a_normal_are_as_far_as_they_went(kind: Kind, off: float) -> None:
    frame = Frame(3)
    points = frame.point(point_on(kind, *grid(), off))
    d, normal = distance(kind, surface_of(kind, frame)[None], points[None])
    assert d[0] == pytest.approx(np.full(len(points), off), abs=1e-12)
    # The foot of the perpendicular is the point that it started from.
    foot = frame.point(point_on(kind, *grid()))
    assert np.abs(points - off * normal[0] - foot).max() < 1e-12


def test_distances_by_hand() -> None:
    z = [0.0, 0.0, 0.0, 0.0, 0.0, 1.0]
    p = np.array([[[3.0, 4.0, 12.0]]])
    s = np.sin(np.pi / 6.0)
    assert distance("plane", np.array([[*z, 0.0, 0.0]]), p)[0].item() == 12.0
    assert distance("cylinder", np.array([[*z, 2.0, 0.0]]), p)[0].item() == pytest.approx(3.0)
    assert distance("sphere", np.array([[*z, 10.0, 0.0]]), p)[0].item() == pytest.approx(3.0)
    # Torus R0 r10 is the sphere; R10: the hypotenuse of 5 and 12.
    assert distance("torus", np.array([[*z, 0.0, 10.0]]), p)[0].item() == pytest.approx(3.0)
    assert distance("torus", np.array([[*z, 10.0, 1.0]]), p)[0].item() == pytest.approx(12.0)
    # Cone of 30 degrees with its apex at the origin: 5 cos 30 - 12 sin 30.
    expected = 5.0 * np.sqrt(1.0 - s * s) - 12.0 * s
    cone = np.array([[*z, 0.0, np.pi / 6.0]])
    assert distance("cone", cone, p)[0].item() == pytest.approx(expected)


@pytest.mark.parametrize("kind", KINDS)
@given(seed=seeds)
def test_derivatives_are_those_of_the_distance(kind: Kind, seed: int) -> None:
    frame = Frame(seed)
    u, v = np.random.default_rng(seed).uniform(-1.2, 1.2, (2, 8))
    surface = surface_of(kind, frame)
    points = frame.point(point_on(kind, u, v, 0.3))
    _, jacobian = distance_jacobian(kind, surface[None], points[None])
    _, normal = distance(kind, surface[None], points[None])
    h = 1e-5
    for k in range(8):
        # The direction is a unit vector: only what turns it counts.
        step = np.eye(8)[k]
        if 3 <= k < 6:
            step[3:6] -= (step[3:6] @ surface[3:6]) * surface[3:6]
        up, down = surface + h * step, surface - h * step
        slope = (
            distance(kind, up[None], points[None])[0] - distance(kind, down[None], points[None])[0]
        ) / (2 * h)
        assert slope[0] == pytest.approx(jacobian[0] @ step, abs=1e-6)
    for k in range(3):
        move = h * np.eye(3)[k]
        ahead = distance(kind, surface[None], points[None] + move)[0]
        behind = distance(kind, surface[None], points[None] - move)[0]
        assert ((ahead - behind) / (2 * h))[0] == pytest.approx(normal[0][:, k], abs=1e-6)


@pytest.mark.parametrize("kind", KINDS)
def test_the_unknowns_are_the_rank_of_the_derivatives(kind: Kind) -> None:
    # Sliding along an axis, spinning about it and stretching the direction change nothing.
    frame = Frame(5)
    surface = surface_of(kind, frame)[None]
    points = frame.point(point_on(kind, *grid()))[None]
    jacobian = distance_jacobian(kind, surface, points)[1][0]
    turned = np.eye(8)
    turned[3:6, 3:6] -= np.outer(frame.axis, frame.axis)
    assert np.linalg.matrix_rank(jacobian @ turned, tol=1e-9) == UNKNOWNS[kind]


@given(seed=seeds)
def test_frames_and_free_points_do_not_change_the_surface(seed: int) -> None:
    frame = Frame(seed)
    rng = np.random.default_rng(seed)
    centre, scale = 30.0 * rng.normal(size=(1, 3)), np.array([rng.uniform(0.01, 100.0)])
    points = frame.point(point_on("sphere", *grid(), 4.0))[None]
    for kind in KINDS:
        surface = surface_of(kind, frame)[None]
        d, _ = distance(kind, surface, points)
        slid = slide(surface, centre, kind)
        assert distance(kind, slid, points)[0] == pytest.approx(d, abs=1e-10)
        local = to_local(surface, centre, scale, kind)
        there = distance(kind, local, (points - centre) / scale)[0]
        assert scale * there == pytest.approx(d, abs=1e-10)
        back = to_world(local, centre, scale, kind)
        assert distance(kind, back, points)[0] == pytest.approx(d, abs=1e-10)


def test_largest_curvature_by_hand() -> None:
    frame = Frame(7)
    one = {
        "plane": 0.0,
        "cylinder": 1.0 / 5.0,
        "cone": np.cos(HALF_ANGLE) / 6.0,
        "sphere": 1.0 / 7.0,
        "torus": 1.0 / 3.0,
    }
    for kind in KINDS:
        # At v = 0: the cone's radius is 6 there, the torus is at its equator.
        points = frame.point(point_on(kind, np.array([0.4]), np.array([0.0])))
        found = largest_curvature(kind, surface_of(kind, frame), points)
        assert found == pytest.approx([one[kind]])
    # On the inside of a nearly closed ring the parallel bends more than the tube.
    tight = np.array([0.0, 0, 0, 0, 0, 1, SIZES["torus"][0], 9.0])
    inner = largest_curvature("torus", tight, np.array([[1.0, 0.0, 0.0]]))
    assert inner == pytest.approx([1.0])
