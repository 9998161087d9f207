# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest
from analytic_meshes import TURN, Pose, poses, samples
from hypothesis import given
from hypothesis import strategies as st

from gpswb.core.invariance import CLASSES
from gpswb.core.quotient import largest_gap, quotient_coordinates
from gpswb.core.reference import Reference, axis_frame, estimate_references, screw, spread
from gpswb.core.refine_reference import refine_reference
from gpswb.core.thickness import thickness

Z = np.array([0.0, 0.0, 1.0])


def off_axis(reference: Reference, point: np.ndarray, direction: np.ndarray) -> tuple[float, float]:
    """Sine of the angle to an axis, and the distance of the reference point from it."""
    angle = float(np.linalg.norm(np.cross(reference.direction, direction)))
    return angle, float(np.linalg.norm(np.cross(reference.point - point, direction)))


@given(poses(), st.sampled_from(["cylindrical", "quarter cylinder", "revolute", "helical"]))
def test_axes_are_found_in_any_pose_and_unit(pose: Pose, name: str) -> None:
    p, n = samples(name, 600)
    label = "cylindrical" if name == "quarter cylinder" else name
    found = estimate_references(pose.point(p), pose.vector(n))[label]
    angle, distance = off_axis(found, pose.point(np.zeros((1, 3)))[0], pose.vector(Z))
    assert angle < 1e-7
    assert distance < 1e-5 * pose.scale
    if name == "helical":
        assert found.lead == pytest.approx(10.0 * pose.scale, rel=1e-6)


@given(poses())
def test_a_centre_a_plane_and_a_direction(pose: Pose) -> None:
    p, n = samples("spherical", 500)
    centre = estimate_references(pose.point(p), pose.vector(n))["spherical"].point
    assert np.linalg.norm(centre - pose.translation) < 1e-6 * pose.scale
    p, n = samples("planar", 500)
    normal = estimate_references(pose.point(p), pose.vector(n))["planar"].direction
    assert normal @ pose.vector(Z) == pytest.approx(1.0)  # signed: with the normals
    p, n = samples("prismatic", 500)
    along = estimate_references(pose.point(p), pose.vector(n))["prismatic"].direction
    assert abs(along @ pose.vector(Z)) == pytest.approx(1.0)


def test_a_mirrored_thread_has_the_opposite_lead() -> None:
    p, n = samples("helical", 600)
    mirror = np.array([-1.0, 1.0, 1.0])
    found = estimate_references(p * mirror, n * mirror)["helical"]
    assert found.lead == pytest.approx(-10.0, rel=1e-6)


def test_the_revolute_reference_of_a_thread_is_no_screw() -> None:
    # The best pure rotation is sought among twists with omega . t = 0, not cut from the screw.
    p, n = samples("helical", 600)
    found = estimate_references(p, n)
    assert found["revolute"].lead == 0.0

    def slip(axis: Reference) -> float:
        v = np.cross(axis.direction, p - axis.point)
        return float((np.einsum("ij,ij->i", v, n) ** 2).sum() / (v**2).sum())

    best = slip(found["revolute"])
    rng = np.random.default_rng(0)
    for _ in range(200):
        trial = Reference(
            found["revolute"].point + 0.3 * rng.normal(size=3),
            found["revolute"].direction + 0.03 * rng.normal(size=3),
        )
        assert slip(trial) >= best - 1e-12


def test_only_the_classes_wanted() -> None:
    p, n = samples("complex", 300)
    everything = estimate_references(p, n)
    assert tuple(everything) == CLASSES
    some = estimate_references(p, n, classes=("spherical", "revolute"))
    assert set(some) == {"spherical", "revolute"}
    assert np.array_equal(some["revolute"].direction, everything["revolute"].direction)


@pytest.mark.parametrize("shape", [(2, 3), (5, 2)])
def test_too_few_points_or_wrong_shapes_are_refused(shape: tuple[int, int]) -> None:
    with pytest.raises(ValueError, match="at least 3 points"):
        estimate_references(np.zeros(shape), np.zeros(shape))


@given(st.integers(0, 10**6))
def test_a_screw_is_read_from_its_twist(seed: int) -> None:
    rng = np.random.default_rng(seed)
    point, direction, lead = rng.normal(size=3), rng.normal(size=3), float(rng.normal())
    direction /= np.linalg.norm(direction)
    twist = np.concatenate([direction, np.cross(point, direction) + lead / TURN * direction])
    found = screw(2.5 * twist)
    assert found.direction @ direction == pytest.approx(1.0)
    assert np.linalg.norm(np.cross(found.point - point, direction)) < 1e-9
    assert found.lead == pytest.approx(lead, abs=1e-9)
    frame = axis_frame(direction)
    assert np.allclose(frame @ frame.T, np.eye(3))
    assert np.linalg.det(frame) == pytest.approx(1.0)


def test_a_translation_has_no_axis() -> None:
    found = screw(np.array([0.0, 0.0, 0.0, 0.0, 3.0, 0.0]))
    assert found.lead == np.inf
    assert found.direction.tolist() == [0.0, 1.0, 0.0]


def test_spread_covers_both_ends() -> None:
    assert spread(10, 4).tolist() == [0, 3, 6, 9]
    assert spread(3, 10).tolist() == [0, 1, 2]


MEMBERS = ["planar", "cylindrical", "spherical", "revolute", "prismatic", "helical"]


@pytest.mark.parametrize("name", MEMBERS)
def test_quotient_coordinates_are_constant_along_orbits(name: str) -> None:
    p, n = samples(name, 400)
    reference = estimate_references(p, n)[name]
    before = quotient_coordinates(p, name, reference)
    u, v, d = axis_frame(reference.direction)
    if name in ("planar", "prismatic"):
        step = 3.0 * (u + 2.0 * v) if name == "planar" else 3.0 * d
        after = quotient_coordinates(p + step, name, reference)
    else:
        angle = 0.7
        turn = (
            np.outer(d, d)
            + np.cos(angle) * (np.outer(u, u) + np.outer(v, v))
            + np.sin(angle) * (np.outer(v, u) - np.outer(u, v))
        )
        ride = reference.lead * angle / TURN * d
        if name == "cylindrical":
            ride = 4.0 * d
        moved = (p - reference.point) @ turn.T + reference.point + ride
        after = quotient_coordinates(moved, name, reference)
    if name == "helical":
        # h is cut at its largest gap, so only its order along the cut is free.
        assert np.allclose(before[:, 0], after[:, 0])
        shift = np.mod(after[:, 1] - before[:, 1] + 5.0, abs(reference.lead)) - 5.0
        assert np.ptp(shift) < 1e-6
    else:
        assert np.abs(after - before).max() < 1e-9


def test_the_largest_gap_wraps_around() -> None:
    gap, start = largest_gap(np.array([0.5, 1.0, 9.0]), 10.0)
    assert (gap, start) == (8.0, 9.0)
    gap, start = largest_gap(np.array([9.5, 1.0, 4.0]), 10.0)
    assert (gap, start) == (5.5, 9.5)


@pytest.mark.parametrize("name", MEMBERS)
def test_a_surface_of_the_class_is_thin_and_others_are_not(name: str) -> None:
    p, n = samples(name, 800)
    references = estimate_references(p, n)
    size = float(np.sqrt(p.var(axis=0).sum()))
    assert thickness(p, name, references[name]) < 1e-5 * size
    p, n = samples("complex", 800)
    references = estimate_references(p, n)
    assert thickness(p, name, references[name]) > 1e-3 * size
    assert thickness(p, "complex", references["complex"]) == 0.0


def test_thickness_of_noise_is_the_noise() -> None:
    p, n = samples("prismatic", 2000)
    noisy = p + 0.005 * np.random.default_rng(1).normal(size=(2000, 1)) * n
    found = thickness(noisy, "prismatic", Reference(np.zeros(3), Z))
    # A quadratic through 12 neighbours predicts with some noise of its own: at most a third more.
    assert 0.005 < found < 0.007
    flat = np.column_stack([noisy[:, :2], 0.005 * np.random.default_rng(2).normal(size=2000)])
    assert thickness(flat, "planar", Reference(np.zeros(3), Z)) == pytest.approx(0.005, rel=0.05)


@pytest.mark.parametrize("name", ["prismatic", "revolute", "helical"])
def test_positions_refine_a_reference_that_normals_missed(name: str) -> None:
    p, n = samples(name, 1500)
    exact = estimate_references(p, n)[name]
    rng = np.random.default_rng(4)
    start = Reference(
        exact.point + 0.01 * rng.normal(size=3) * (name != "prismatic"),
        exact.direction + 2e-3 * rng.normal(size=3),
        exact.lead * 1.002,
    )
    start = Reference(start.point, start.direction / np.linalg.norm(start.direction), start.lead)
    better, _ = refine_reference(p, name, start)
    before, _ = off_axis(start, np.zeros(3), Z)
    after, distance = off_axis(better, np.zeros(3), Z)
    assert before > 1e-3
    assert after < 1e-5
    if name != "prismatic":
        assert distance < 1e-4
    if name == "helical":
        assert better.lead == pytest.approx(10.0, rel=1e-5)
    assert thickness(p, name, better) < 0.01 * thickness(p, name, start)


def test_refinement_leaves_alone_what_it_can_not_improve() -> None:
    p, n = samples("revolute", 500)
    references = estimate_references(p, n)
    assert refine_reference(p, "planar", references["planar"])[0] is references["planar"]
    translation = Reference(np.zeros(3), Z, np.inf)
    assert refine_reference(p, "helical", translation)[0] is translation
    assert refine_reference(p[:8], "revolute", references["revolute"])[0] is references["revolute"]
