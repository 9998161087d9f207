# SPDX-License-Identifier: LGPL-2.1-or-later
from copy import deepcopy
from functools import partial

import numpy as np
import pytest
from analytic_meshes import TURN, samples
from hypothesis import given
from hypothesis import strategies as st

from gpswb.core.invariance import CLASSES
from gpswb.core.kernel_density import leave_one_out_at, leave_one_out_log_density
from gpswb.core.likelihood import LogLikelihoods, covered_angle, log_likelihoods, solid_angle
from gpswb.core.mesh import FloatArray
from gpswb.core.reference import References, estimate_references


def direct(points: FloatArray, bandwidth: FloatArray) -> FloatArray:
    """The definition: mean of the kernels of all other points, O(n^2)."""
    n, d = points.shape
    unit = (points[:, None] - points[None]) / bandwidth
    kernel = np.exp(-0.5 * (unit**2).sum(axis=2))
    np.fill_diagonal(kernel, 0.0)
    norm = (n - 1) * (2.0 * np.pi) ** (d / 2) * np.prod(bandwidth)
    with np.errstate(divide="ignore"):
        return np.asarray(np.log(kernel.sum(axis=1) / norm))


@pytest.mark.parametrize("d", [1, 2, 3])
@pytest.mark.parametrize("width", [0.02, 0.1, 0.5])
def test_density_against_the_direct_sum(d: int, width: float) -> None:
    # The wide kernels go by the grid, the narrow ones of 2-D and 3-D pair by pair.
    points = np.random.default_rng(d).random((1200, d))
    bandwidth = width * np.linspace(1.0, 1.5, d)
    exact = direct(points, bandwidth)
    found = leave_one_out_at(points, bandwidth)
    dense = exact > exact.max() - 7.0
    assert dense.mean() > 0.3
    assert np.abs(found - exact)[dense].max() < 0.02
    assert np.abs(found - exact)[dense].mean() < 2e-3


def test_the_definition_by_hand() -> None:
    # Two points: each sees the other's kernel alone.
    found = leave_one_out_at(np.array([[0.0], [0.3]]), np.array([0.2]))
    value = -0.5 * 1.5**2 - np.log(0.2 * np.sqrt(2.0 * np.pi))
    assert found == pytest.approx([value, value], abs=2e-3)


def test_coincident_points_of_a_structured_mesh() -> None:
    rings = np.repeat(np.linspace(0.0, 1.0, 11), 40)[:, None] * [1.0, 2.0]
    bandwidth = np.array([1e-3, 1e-3])
    assert np.abs(leave_one_out_at(rings, bandwidth) - direct(rings, bandwidth)).max() < 1e-6


@given(st.floats(1e-3, 1e3), st.integers(1, 3))
def test_a_density_scales_with_the_unit(scale: float, d: int) -> None:
    points = np.random.default_rng(7).normal(size=(300, d))
    before = leave_one_out_log_density(points, 1e-3)
    after = leave_one_out_log_density(scale * points, scale * 1e-3)
    assert np.abs(after - before + d * np.log(scale)).max() < 1e-6


def test_the_chosen_bandwidth_beats_silverman_on_a_curve() -> None:
    t = TURN * np.random.default_rng(0).random(800)
    circle = np.column_stack([np.cos(t), np.sin(t)])
    silverman = 1.06 * circle.std(axis=0) * 800 ** (-1.0 / 6.0)
    chosen = leave_one_out_log_density(circle, 1e-3).sum()
    assert chosen > direct(circle, silverman).sum() + 300.0


def test_the_floor_keeps_exact_data_finite() -> None:
    exact = np.full((50, 1), 3.0)
    found = leave_one_out_log_density(exact, 1e-3)
    assert found == pytest.approx(np.full(50, -np.log(1e-3 * np.sqrt(2.0 * np.pi))), abs=2e-3)


@pytest.mark.parametrize(("n", "floor"), [(1, 1.0), (5, 0.0), (5, -1.0)])
def test_bad_input_is_refused(n: int, floor: float) -> None:
    with pytest.raises(ValueError, match="2 points and a floor"):
        leave_one_out_log_density(np.zeros((n, 1)), floor)


SURFACES = [
    "planar", "cylindrical", "quarter cylinder", "spherical", "sphere", "revolute",
    "prismatic", "helical",
]  # fmt: skip
CLASS_OF = {"quarter cylinder": "cylindrical", "sphere": "spherical"}
# Classes that hold the surface too, as a special case: they tie by construction.
NESTED = {
    "planar": {"planar", "prismatic", "complex", "revolute", "helical"},
    "cylindrical": {"cylindrical", "revolute", "helical", "prismatic"},
    "spherical": {"spherical", "revolute"},
    "revolute": {"revolute", "helical"},
    "prismatic": {"prismatic", "helical"},
    "helical": {"helical"},
}


@pytest.mark.parametrize("name", SURFACES)
@pytest.mark.parametrize("unit", [1.0, 0.001, 25.4])
def test_no_class_beats_the_right_one_but_those_that_contain_it(name: str, unit: float) -> None:
    p, n = samples(name, 1500)
    p = unit * p
    right = CLASS_OF.get(name, name)
    found = log_likelihoods(p, estimate_references(p, n), 2e-3 * unit)
    assert tuple(found) == CLASSES
    rivals = {c: v for c, v in found.items() if c not in NESTED[right]}
    # A nat a point: e^1500 times likelier.
    assert all(found[right] > v + 1500.0 for v in rivals.values())
    assert found[right] > max(found.values()) - 0.1 * 1500


@given(st.sampled_from(SURFACES), st.floats(1e-3, 1e3))
def test_corrected_likelihoods_shift_by_the_unit_alone(name: str, unit: float) -> None:
    p, n = samples(name, 400)
    references = estimate_references(p, n)
    before = log_likelihoods(p, references, 2e-3)
    scaled = {c: type(r)(unit * r.point, r.direction, unit * r.lead) for c, r in references.items()}
    after = log_likelihoods(unit * p, scaled, 2e-3 * unit)
    for c in CLASSES:
        assert after[c] == pytest.approx(before[c] - 3 * 400 * np.log(unit), abs=1.0)


def test_the_printed_ranking_depends_on_the_unit() -> None:
    p, n = samples("spherical", 800)
    best = []
    for unit in (1.0, 1e-6):
        references = estimate_references(unit * p, n)
        found = log_likelihoods(unit * p, references, 2e-3 * unit, densities="printed")
        del found["helical"]
        best.append(max(found, key=lambda c: found[c]))
    assert best[0] == "spherical"
    # Densities per length and per length^3 don't compare: small numbers favour the more powers.
    assert best[1] != "spherical"


def test_the_printed_spherical_density_is_the_print() -> None:
    p, n = samples("sphere", 300)
    found = log_likelihoods(p, estimate_references(p, n), 1e-2, densities="printed")["spherical"]
    rho = np.full((300, 1), 7.0)
    cosine = np.hypot(p[:, 0], p[:, 1]) / 7.0
    exact = leave_one_out_log_density(rho, 1e-2) + np.log(cosine / (4.0 * np.pi))
    assert found == pytest.approx(exact.sum(), abs=0.5)


def test_a_partial_orbit_pays_nothing() -> None:
    # The density of points on a quarter cylinder is 4 times that on the whole one.
    values = {}
    for name in ("cylindrical", "quarter cylinder"):
        p, n = samples(name, 2000)
        values[name] = log_likelihoods(p, estimate_references(p, n), 1e-2)["cylindrical"] / 2000
    gain = values["quarter cylinder"] - values["cylindrical"]
    assert gain == pytest.approx(np.log(4.0), abs=0.02)


def test_the_exact_density_of_a_cylinder() -> None:
    # Uniform on the wall: p = g(0) / (2 pi R h), g the kernel across, flat but for its two ends.
    p, n = samples("cylindrical", 4000)
    floor = 0.01
    found = log_likelihoods(p, estimate_references(p, n), floor)["cylindrical"] / 4000
    exact = -np.log(TURN * 5.0 * 20.0) - np.log(floor * np.sqrt(TURN))
    assert found == pytest.approx(exact, abs=0.03)


def test_covered_angle_and_solid_angle() -> None:
    rng = np.random.default_rng(5)
    assert covered_angle(TURN * rng.random(500)) == TURN
    for share in (0.1, 0.25, 0.6):
        assert covered_angle(1.0 + share * TURN * rng.random(2000)) == pytest.approx(
            share * TURN, rel=0.02
        )
    for name, exact in (("sphere", 4.0 * np.pi), ("spherical", 2.0 * np.pi)):
        directions = samples(name, 4000)[0] / 7.0
        assert solid_angle(directions) == pytest.approx(exact, rel=0.06)
    octant = np.abs(samples("sphere", 4000)[0]) / 7.0
    assert solid_angle(octant) == pytest.approx(np.pi / 2.0, rel=0.12)


def test_classes_without_reference_get_no_value() -> None:
    p, n = samples("planar", 100)
    some = estimate_references(p, n, classes=("planar", "complex"))
    assert set(log_likelihoods(p, some, 1e-3)) == {"planar", "complex"}


def test_likelihoods_of_a_region_wait_until_they_are_read_and_can_be_copied_before_that() -> None:
    p, n = samples("cylindrical", 600)
    asked = []

    def references() -> References:
        asked.append(1)
        return estimate_references(p, n)

    waiting = LogLikelihoods(p, references, 1e-3)
    assert not asked
    assert dict(waiting) == log_likelihoods(p, estimate_references(p, n), 1e-3)
    assert waiting["planar"] == waiting["planar"]
    assert len(asked) == 1
    sent = LogLikelihoods(p, partial(estimate_references, p, n), 1e-3)
    assert dict(deepcopy(sent)) == dict(waiting)


def test_large_regions_are_thinned_and_scaled_up() -> None:
    p, n = samples("planar", 12000)
    references = estimate_references(p, n)
    found = LogLikelihoods(p, partial(dict, references), 1e-3)
    thin = log_likelihoods(p[np.linspace(0, 11999, 4000).round().astype(int)], references, 1e-3)
    assert found["complex"] == pytest.approx(3.0 * thin["complex"])
