# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coordinates of a cone at a patch: what they change, and that fits in them converge."""

from __future__ import annotations

import numpy as np
import pytest
from known_surfaces import slope_of_moves
from scipy.spatial.transform import Rotation

from gpswb.core.mesh import FloatArray
from gpswb.core.robust.cone_chart import LEAST, ConeChart
from gpswb.core.robust.fitting import fit, fit_patches
from gpswb.core.robust.surfaces import distance


def cones(rng: np.random.Generator, n: int) -> FloatArray:
    axis = rng.normal(size=(n, 3))
    axis /= np.linalg.norm(axis, axis=1)[:, None]
    sizes = np.column_stack([rng.uniform(1.0, 9.0, n), rng.uniform(-1.2, 1.2, n)])
    return np.column_stack([rng.normal(size=(n, 3)), axis, sizes])


def test_the_foot_is_on_the_cone_and_the_chart_gives_the_cone_back() -> None:
    rng = np.random.default_rng(0)
    surface, points = cones(rng, 20), 5.0 * rng.normal(size=(20, 3))
    chart = ConeChart.at(surface, points)
    d, normal = distance("cone", surface, chart.foot[:, None])
    assert np.abs(d).max() < 1e-12
    assert np.abs(normal[:, 0] - chart.normal).max() < 1e-12
    # The reference point has slid along the axis: the distances are the same.
    elsewhere = rng.normal(size=(20, 30, 3))
    again = distance("cone", chart.surface, elsewhere)[0]
    assert again == pytest.approx(distance("cone", surface, elsewhere)[0], abs=1e-11)


def test_at_the_apex_the_foot_moves_away_along_a_ruling() -> None:
    surface = np.array([[0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.5]])
    chart = ConeChart.at(surface, np.array([[1e-6, 0.0, -1.0]]))
    assert np.hypot(*chart.foot[0, :2]) == pytest.approx(LEAST)
    assert distance("cone", surface, chart.foot[:, None])[0] == pytest.approx(0.0, abs=1e-12)


def test_the_derivative_is_that_of_the_moves() -> None:
    rng = np.random.default_rng(1)
    chart = ConeChart.at(cones(rng, 10), rng.normal(size=(10, 3)))
    change = slope_of_moves(lambda step: chart.moved(step).surface, (10, 6))
    assert change == pytest.approx(chart.derivative(), rel=1e-5, abs=1e-5)


def test_the_half_angle_keeps_ruling_and_curvature() -> None:
    rng = np.random.default_rng(2)
    chart = ConeChart.at(cones(rng, 5), rng.normal(size=(5, 3)))
    step = np.zeros((5, 6))
    step[:, 5] = 0.3
    moved = chart.moved(step).surface
    along = chart.foot[:, None] + np.linspace(-0.1, 0.1, 5)[:, None] * chart.ruling[:, None]
    assert np.abs(distance("cone", moved, along)[0]).max() < 1e-12
    # Across, both leave the tangent plane by the same parabola; they differ in the third order.
    side = np.cross(chart.normal, chart.ruling)
    near = chart.foot[:, None] + 1e-3 * side[:, None]
    both = [distance("cone", s, near)[0] for s in (chart.surface, moved)]
    assert both[0] == pytest.approx(both[1], rel=1e-4)


@pytest.mark.parametrize("degrees", [10.0, 41.0, 65.0])
def test_fits_of_shallow_patches_converge_in_a_dozen_steps(degrees: float) -> None:
    """A patch a tenth as long as it is away from the apex, from the cylinder nearest to it."""
    half = np.radians(degrees)
    for seed in range(10):
        rng = np.random.default_rng(seed)
        s, t = np.meshgrid(np.linspace(9.5, 10.5, 6), np.linspace(-0.05, 0.05, 7), indexing="ij")
        t = t.ravel() / np.sin(half)
        s = s.ravel() * (1.0 + 0.05 * rng.uniform(-1, 1) * t)
        rho = s * np.sin(half)
        points = np.column_stack([rho * np.cos(t), rho * np.sin(t), s * np.cos(half)])
        points = points @ Rotation.random(random_state=seed).as_matrix()
        points -= points.mean(axis=0)
        points /= np.abs(points).max()
        weights = np.ones((1, len(points)))
        none = np.zeros((1, 0, 3))
        cylinder = fit_patches("cylinder", points[None], weights, none, none)
        cylinder[:, 7] = 0.0
        cone = fit("cone", cylinder, points[None], weights, iterations=12)
        assert np.abs(distance("cone", cone, points[None])[0]).max() < 1e-9
        assert abs(cone[0, 7]) == pytest.approx(half, abs=1e-5)
