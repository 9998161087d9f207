# SPDX-License-Identifier: LGPL-2.1-or-later
"""Associated features of disturbed surfaces whose form deviation is known in closed form."""

import numpy as np
import pytest

from gpswb.gps.association import associate
from gpswb.gps.roundness import roundness


def turned(points: np.ndarray, seed: int = 4) -> tuple[np.ndarray, np.ndarray]:
    """Points in another pose, and the rotation."""
    q, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    q *= np.sign(np.linalg.det(q))
    return points @ q.T + [30, -20, 55], q


def start(kind: str, q: np.ndarray, a: float = 0.0, b: float = 0.0) -> np.ndarray:
    """A nominal surface half a degree and some hundredths off."""
    axis = q[:, 2] + 0.008 * q[:, 0]
    return np.r_[[30.03, -20.02, 55.01], axis / np.linalg.norm(axis), a, b]


def test_wavy_plane() -> None:
    # z = h cos(2πx/5) cos(2πy/5) on whole periods with both extremes hit: the zone is 2h, and the
    # least-squares plane is z = 0 by symmetry.
    g = np.arange(0, 20, 0.25)
    x, y = (v.ravel() for v in np.meshgrid(g, g))
    z = 0.03 * np.cos(2 * np.pi * x / 5) * np.cos(2 * np.pi * y / 5)
    points, q = turned(np.column_stack([x, y, z]))
    for criterion in ("least squares", "minimax"):
        found = associate("plane", start("plane", q), points, criterion)
        assert found is not None
        assert found.zone == pytest.approx(0.06, abs=1e-9)


def test_minimax_is_narrower_where_least_squares_is_not_best() -> None:
    # A parabolic arch h x² on [-1, 1], drawn out. The minimax line is h/2 by the
    # equioscillation theorem: deviations of ±h/2, a zone of h; no line does better.
    x, z = (v.ravel() for v in np.meshgrid(np.linspace(-1, 1, 41), np.linspace(0, 3, 9)))
    points, q = turned(np.column_stack([x, z, 0.02 * x**2]))
    found = associate("plane", start("plane", q), points, "minimax")
    assert found is not None
    assert found.zone == pytest.approx(0.02, abs=1e-9)
    # Skewed, with a bump on one side, least squares is wider than the minimum.
    bump = points + np.outer(0.01 * np.exp(-8 * (x - 0.6) ** 2), q[:, 2])
    gauss = associate("plane", start("plane", q), bump, "least squares")
    least = associate("plane", start("plane", q), bump, "minimax")
    assert gauss is not None
    assert least is not None
    assert least.zone < 0.98 * gauss.zone
    d = np.abs(least.deviations)
    # Characterisation of a best plane: at least four points touch the zone.
    assert (d > d.max() * (1 - 1e-6)).sum() >= 4


def lobed_cylinder(lobes: int, h: float, radius: float = 10.0) -> tuple[np.ndarray, np.ndarray]:
    phi, z = np.meshgrid(2 * np.pi * np.arange(120) / 120, np.linspace(-8, 8, 20))
    phi, z = phi.ravel(), z.ravel()
    rho = radius + h * np.cos(lobes * phi)
    return turned(np.column_stack([rho * np.cos(phi), rho * np.sin(phi), z]))


@pytest.mark.parametrize("lobes", [2, 3, 5])
def test_lobed_cylinder(lobes: int) -> None:
    # r = R + h cos(kφ), k >= 2: by symmetry both criteria keep the axis and R; the zone is 2h.
    points, q = lobed_cylinder(lobes, 0.02)
    for criterion in ("least squares", "minimax"):
        found = associate("cylinder", start("cylinder", q, 10.0), points, criterion)
        assert found is not None
        assert found.zone == pytest.approx(0.04, abs=2e-7)
        assert found.surface[6] == pytest.approx(10.0, abs=1e-5)
        assert abs(found.surface[3:6] @ q[:, 2]) == pytest.approx(1.0, abs=1e-10)
    measured = roundness(points, found.surface[:3], found.surface[3:6])
    assert measured is not None
    gauss, zone, sections = measured
    assert sections == 10
    assert gauss == pytest.approx(0.04, abs=1e-5)
    assert zone == pytest.approx(0.04, abs=1e-5)


def test_barrel_is_round_but_not_cylindrical() -> None:
    # r = R + h (z/8)²: each section is a circle; the cylindricity zone is h.
    phi, z = np.meshgrid(2 * np.pi * np.arange(90) / 90, np.linspace(-8, 8, 30))
    phi, z = phi.ravel(), z.ravel()
    rho = 10 + 0.05 * (z / 8) ** 2
    points, q = turned(np.column_stack([rho * np.cos(phi), rho * np.sin(phi), z]))
    least = associate("cylinder", start("cylinder", q, 10.0), points, "minimax")
    assert least is not None
    # The middle rings stand at z = ±8/29, not at 0.
    assert least.zone == pytest.approx(0.05 * (1 - 1 / 29**2), abs=1e-6)
    measured = roundness(points, least.surface[:3], least.surface[3:6])
    assert measured is not None
    # A section is three of the thirty rings; the steepest one's radii differ by this much.
    expected = 0.05 * (1 - (1 - 2 * 2 / 29) ** 2)
    assert measured[1] == pytest.approx(expected, abs=1e-6)


def test_sphere_cone_and_torus_with_waves() -> None:
    random = np.random.default_rng(2)
    h = 0.01
    u = random.normal(size=(4000, 3))
    u /= np.linalg.norm(u, axis=1, keepdims=True)
    # ± h in equal numbers at antipodes: the sphere can't move, so the zone is 2h.
    sign = np.where(np.arange(4000) % 2, 1.0, -1.0)
    ball = np.r_[(15 + h * sign)[:, None] * u, -(15 + h * sign)[:, None] * u]
    points, q = turned(ball)
    found = associate("sphere", start("sphere", q, 15.0), points, "minimax")
    assert found is not None
    assert found.zone == pytest.approx(2 * h, rel=2e-3)

    phi, t = np.meshgrid(2 * np.pi * np.arange(72) / 72, np.linspace(0, 10, 21))
    phi, t = phi.ravel(), t.ravel()
    half = np.radians(20)
    wave = h * np.cos(4 * phi)
    rho = 5 + t * np.tan(half) + wave * np.cos(half)
    z = t - wave * np.sin(half)
    points, q = turned(np.column_stack([rho * np.cos(phi), rho * np.sin(phi), z]))
    row = start("cone", q, 5 * np.cos(half), half + 0.01)
    found = associate("cone", row, points, "minimax")
    assert found is not None
    assert found.zone == pytest.approx(2 * h, abs=1e-6)
    assert np.degrees(found.surface[7]) == pytest.approx(20.0, abs=1e-3)

    theta = 2 * np.pi * np.arange(72) / 72
    phi, theta = (v.ravel() for v in np.meshgrid(theta, theta))
    r = 4 + h * np.cos(3 * theta) * np.cos(4 * phi)
    rho, z = 20 + r * np.cos(theta), r * np.sin(theta)
    points, q = turned(np.column_stack([rho * np.cos(phi), rho * np.sin(phi), z]))
    found = associate("torus", start("torus", q, 20.0, 4.0), points, "minimax")
    assert found is not None
    assert found.zone == pytest.approx(2 * h, abs=1e-6)


def test_too_few_points_give_nothing() -> None:
    assert associate("plane", np.r_[0, 0, 0, 0, 0, 1, 0, 0], np.eye(3), "minimax") is None
    assert roundness(np.eye(3), np.zeros(3), np.array([0.0, 0, 1])) is None
