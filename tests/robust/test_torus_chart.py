# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coordinates of a torus at a patch: what they change, and that fits in them converge."""

from __future__ import annotations

import numpy as np
import pytest
from known_surfaces import slope_of_moves
from scipy.spatial.transform import Rotation

from gpswb.core.mesh import FloatArray
from gpswb.core.robust.fitting import fit_patches
from gpswb.core.robust.surfaces import distance
from gpswb.core.robust.torus_chart import TorusChart


def tori(rng: np.random.Generator, n: int) -> FloatArray:
    axis = rng.normal(size=(n, 3))
    axis /= np.linalg.norm(axis, axis=1)[:, None]
    sizes = np.column_stack([rng.uniform(3.0, 9.0, n), rng.uniform(0.5, 2.0, n)])
    return np.column_stack([rng.normal(size=(n, 3)), axis, sizes])


def test_the_foot_is_on_the_torus_and_the_chart_gives_the_torus_back() -> None:
    rng = np.random.default_rng(0)
    surface = tori(rng, 20)
    chart = TorusChart.at(surface, 5.0 * rng.normal(size=(20, 3)))
    d, normal = distance("torus", surface, chart.foot[:, None])
    assert np.abs(d).max() < 1e-12
    assert np.abs(normal[:, 0] - chart.normal).max() < 1e-12
    assert np.abs(chart.surface - surface).max() < 1e-12


def test_the_derivative_is_that_of_the_moves() -> None:
    rng = np.random.default_rng(1)
    chart = TorusChart.at(tori(rng, 10), rng.normal(size=(10, 3)))
    change = slope_of_moves(lambda step: chart.moved(step).surface, (10, 7))
    assert np.abs(change - chart.derivative()).max() < 1e-7


def test_turns_are_about_the_foot() -> None:
    rng = np.random.default_rng(2)
    chart = TorusChart.at(tori(rng, 5), rng.normal(size=(5, 3)))
    step = np.zeros((5, 7))
    step[:, 1:4] = rng.normal(size=(5, 3))
    turned = chart.moved(step)
    for i in range(5):
        turn = Rotation.from_rotvec(step[i, 1:4])
        assert turned.axis[i] == pytest.approx(turn.apply(chart.axis[i]))
    d, _ = distance("torus", turned.surface, chart.foot[:, None])
    assert np.abs(d).max() < 1e-12


def patch(rng: np.random.Generator, extent: float) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Vertices, centroids and weighted normals of a 7 by 7 patch of a torus r1, R1.2 to 8."""
    major = rng.uniform(1.2, 8.0)
    u = rng.uniform(0, 2 * np.pi) + np.linspace(0, extent * rng.uniform(0.5, 1.5) / major, 7)
    v = rng.uniform(0, 2 * np.pi) + np.linspace(0, extent * rng.uniform(0.5, 1.5), 7)
    around, along = np.meshgrid(u, v, indexing="ij")
    rho = major + np.cos(along)
    points = np.stack([rho * np.cos(around), rho * np.sin(around), np.sin(along)], axis=-1)
    points = (
        points.reshape(-1, 3) @ Rotation.random(random_state=int(rng.integers(1 << 30))).as_matrix()
    )
    points -= points.mean(axis=0)
    points /= np.abs(points).max()
    corner = np.array([7 * i + j for i in range(6) for j in range(6)])
    triangles = np.concatenate(
        [
            np.column_stack([corner, corner + 7, corner + 1]),
            np.column_stack([corner + 7, corner + 8, corner + 1]),
        ]
    )
    corners = points[triangles]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(normal, axis=1)
    weighted = normal / area[:, None] * np.sqrt(area / area.sum())[:, None]
    return points, corners.mean(axis=1), weighted


def test_fits_of_small_patches_converge() -> None:
    """A patch of a third of the tube's radius determines the torus; nine of ten fits find it."""
    rng = np.random.default_rng(3)
    points, centres, normals = (
        np.array(x) for x in zip(*(patch(rng, 0.3) for _ in range(100)), strict=True)
    )
    found = fit_patches("torus", points, np.ones(points.shape[:2]), centres, normals)
    d, _ = distance("torus", found, points)
    assert (np.abs(d).max(axis=1) < 1e-9).mean() >= 0.9
