# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motions in coordinates at a region, and references refined in them."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray
from gpswb.core.motion_chart import MotionChart
from gpswb.core.reference import Reference
from gpswb.core.refine_reference import refine_reference
from gpswb.core.thickness import thickness


def velocity(reference: Reference, points: FloatArray) -> FloatArray:
    """(n, 3) velocities of a screw's motion, of unit RMS."""
    pitch = reference.lead / (2.0 * np.pi)
    v = np.cross(reference.direction, points - reference.point) + pitch * reference.direction
    return v / np.sqrt((v**2).sum(axis=1).mean())


@settings(max_examples=30)
@given(st.integers(0, 10**6))
def test_no_step_changes_nothing_and_small_steps_change_little(seed: int) -> None:
    """However far the axis is, a step of 1e-3 turns velocities by about 1e-3."""
    rng = np.random.default_rng(seed)
    points = rng.normal(size=(50, 3))
    axis = rng.normal(size=3)
    reference = Reference(
        10.0 ** rng.uniform(0, 3) * rng.normal(size=3), axis / np.linalg.norm(axis), rng.normal()
    )
    chart = MotionChart("helical", reference, points.mean(axis=0), 1.5)
    before = velocity(reference, points)
    for step, least, most in ((np.zeros(6), 0.0, 1e-9), (1e-3 * rng.normal(size=6), 0.0, 2e-2)):
        after = velocity(chart.moved(step), points)
        sign = np.sign(float((before * after).sum()))
        change = float(np.abs(sign * after - before).max())
        assert least <= change <= most


def test_a_revolute_motion_stays_without_lead() -> None:
    chart = MotionChart(
        "revolute",
        Reference(np.zeros(3), np.array([0.0, 0.0, 1.0])),
        np.array([4.0, 0.0, 1.0]),
        1.0,
    )
    moved = chart.moved(0.1 * np.random.default_rng(0).normal(size=6))
    assert moved.lead == 0.0
    assert np.linalg.norm(moved.direction) == pytest.approx(1.0)


@pytest.mark.parametrize("name", ["revolute", "helical"])
def test_a_short_strip_far_from_its_axis_gives_the_axis(name: InvarianceClass) -> None:
    """A blade's edge: 0.5 mm wide, 12 mm long, 20 mm off the axis, start off by a degree."""
    rng = np.random.default_rng(1)
    t, s = rng.uniform(0.0, 0.6, 700), rng.uniform(-1.0, 1.0, 700)
    lead = -78.0 if name == "helical" else 0.0
    rho, z = 20.0 + 0.2 * s + 0.05 * s**3, 0.25 * s**2
    points = np.column_stack([rho * np.cos(t), rho * np.sin(t), z + lead * t / (2.0 * np.pi)])
    axis = np.array([0.01, -0.014, 1.0])
    start = Reference(np.array([0.3, -0.2, 0.0]), axis / np.linalg.norm(axis), 1.03 * lead)
    found, _ = refine_reference(points, name, start)
    assert thickness(points, name, found) < 5e-3 * thickness(points, name, start)
    assert abs(found.direction[2]) == pytest.approx(1.0, abs=1e-6)
    if name == "helical":
        assert found.lead == pytest.approx(lead, rel=1e-3)
