# SPDX-License-Identifier: LGPL-2.1-or-later
"""Residuals against the invariance classes: closed-form surfaces, in any pose and unit."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from gpswb.cad.invariance_residuals import FITTED, fit_classes

Sampled = tuple[np.ndarray, np.ndarray, np.ndarray]
LEAD = 3.0


def sampled(point: Callable[[np.ndarray, np.ndarray], np.ndarray], u1: float, v1: float) -> Sampled:
    """Points, normals and areas of a parametric surface over [0, u1] x [0.1, v1]."""
    u, v = (x.ravel() for x in np.meshgrid(np.linspace(0, u1, 23), np.linspace(0.1, v1, 21)))
    h = 1e-5
    du = (point(u + h, v) - point(u - h, v)) / (2 * h)
    dv = (point(u, v + h) - point(u, v - h)) / (2 * h)
    cross = np.cross(du, dv)
    size = np.linalg.norm(cross, axis=1)
    return point(u, v), cross / size[:, None], size


def columns(*c: np.ndarray) -> np.ndarray:
    return np.column_stack(np.broadcast_arrays(*c))


SURFACES: dict[str, Sampled] = {
    "planar": sampled(lambda u, v: columns(u, v, 0 * u), 2, 1.5),
    "spherical": sampled(
        lambda u, v: 4 * columns(np.cos(u) * np.cos(v), np.sin(u) * np.cos(v), np.sin(v)), 2, 1.2
    ),
    "cylindrical": sampled(lambda u, v: columns(3 * np.cos(u), 3 * np.sin(u), v), 2, 4),
    "prismatic": sampled(lambda u, v: columns(u, np.sin(1.3 * u) + 0.2 * u**2, v), 3, 2),
    "revolute": sampled(
        lambda u, v: columns((3 + v**2 / 4) * np.cos(u), (3 + v**2 / 4) * np.sin(u), v), 2, 2
    ),
    "helical": sampled(
        lambda u, v: columns(
            (3 + v) * np.cos(u), (3 + v) * np.sin(u), LEAD * u / (2 * np.pi) + 0.5 * v + 0.3 * v**2
        ),
        9,
        1,
    ),
    "complex": sampled(lambda u, v: columns(u, v, 0.4 * np.sin(2 * u) * np.cos(1.7 * v)), 3, 3),
}
INSIDE = {
    "planar": {"planar", "cylindrical", "prismatic", "revolute", "helical"},
    "spherical": {"spherical", "revolute", "helical"},
    "cylindrical": {"cylindrical", "prismatic", "revolute", "helical"},
    "prismatic": {"prismatic", "revolute", "helical"},
    "revolute": {"revolute", "helical"},
    "helical": {"helical"},
    "complex": set(),
}
"""Classes whose motions leave the surface in place: a translation counts as a turn about an axis at
infinity, so prismatic surfaces may score as revolute and helical too."""


@pytest.mark.parametrize("name", list(SURFACES))
def test_only_classes_that_hold_the_surface_fit_it(name: str) -> None:
    fits = fit_classes(*SURFACES[name])
    # Normals come from finite differences: good to 1e-10, their squares far below.
    assert fits[name].residual < 1e-14 if name != "complex" else True
    for other in set(FITTED) - INSIDE[name]:
        assert fits[other].residual > 1e-4, other


@pytest.mark.parametrize("name", [n for n in SURFACES if n != "complex"])
def test_most_symmetric_fit_comes_first(name: str) -> None:
    fits = fit_classes(*SURFACES[name])
    assert next(c for c in FITTED if fits[c].residual < 1e-12) == name


@given(
    st.sampled_from(list(SURFACES)),
    st.tuples(*[st.floats(-1, 1)] * 3),
    st.tuples(*[st.floats(-50, 50)] * 3),
    st.floats(1e-3, 1e3),
)
@settings(max_examples=30)
def test_residuals_know_neither_pose_nor_unit(
    name: str, turn: tuple[float, ...], shift: tuple[float, ...], scale: float
) -> None:
    p, n, w = SURFACES[name]
    r = Rotation.from_rotvec(np.array(turn) * 3).as_matrix()
    before = fit_classes(p, n, w)
    after = fit_classes(scale * (p @ r.T + np.array(shift)), n @ r.T, w * scale**2)
    # Where several motions leave the surface in place, no single axis or screw stands out.
    single = name in ("revolute", "helical", "complex")
    for cls in FITTED if single else FITTED[:4]:
        zero = before[cls].residual < 1e-12
        assert (after[cls].residual < 1e-10) == zero, cls
        if not zero and cls in ("planar", "prismatic"):
            assert after[cls].residual == pytest.approx(before[cls].residual, rel=1e-3)


def test_parameters_of_the_fits() -> None:
    assert fit_classes(*SURFACES["cylindrical"])["cylindrical"].radius == pytest.approx(3)
    sphere = fit_classes(*SURFACES["spherical"])["spherical"]
    assert sphere.radius == pytest.approx(4)
    assert sphere.point == pytest.approx([0, 0, 0], abs=1e-6)
    helix = fit_classes(*SURFACES["helical"])["helical"]
    assert abs(helix.lead) == pytest.approx(LEAD)
    assert np.cross(helix.direction, [0, 0, 1]) == pytest.approx([0, 0, 0], abs=1e-6)
    assert helix.deviation < 1e-3
