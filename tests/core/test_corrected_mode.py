# SPDX-License-Identifier: LGPL-2.1-or-later
from collections.abc import Callable

import numpy as np
import pytest
from analytic_meshes import (
    TURN,
    Pose,
    box,
    capped_cylinder,
    cone,
    cylinder,
    extrusion,
    flipped,
    freeform,
    helicoid,
    moved,
    plane,
    poses,
    relabelled,
    sheet,
    sphere,
    torus,
    weld,
)
from hypothesis import given, settings
from hypothesis import strategies as st

from gpswb.core.invariance import CLASSES
from gpswb.core.mesh import FloatArray, IntArray, Mesh
from gpswb.core.partition import Partition
from gpswb.core.pipeline import partition


def corrected(mesh: Mesh, noise: float | None = 0.0) -> Partition:
    return partition(mesh, mode="corrected", noise=noise)


def facet_classes(found: Partition) -> IntArray:
    of_region = np.array([CLASSES.index(r.invariance_class) for r in found.regions] + [-1])
    return np.asarray(of_region[found.region])


def same_partition(a: IntArray, b: IntArray) -> bool:
    return len(np.unique(a)) == len(np.unique(b)) == len(np.unique(np.column_stack([a, b]), axis=0))


WHOLE: list[tuple[Callable[[], Mesh], str, str, dict[str, float]]] = [
    (plane, "planar", "plane", {}),
    (cylinder, "cylindrical", "cylinder", {"radius": 5.0}),
    (lambda: cylinder(arc=0.25, nu=10), "cylindrical", "cylinder", {"radius": 5.0}),
    (sphere, "spherical", "sphere", {"radius": 7.0}),
    (cone, "revolute", "cone", {"half_angle_deg": 30.0}),
    (torus, "revolute", "torus", {"major_radius": 10.0, "minor_radius": 3.0}),
    (extrusion, "prismatic", "extrusion", {}),
    (helicoid, "helical", "helicoid", {"lead": 10.0}),
]


@pytest.mark.parametrize(("make", "name", "surface", "intrinsic"), WHOLE)
def test_one_surface_is_one_region_of_its_class(
    make: Callable[[], Mesh], name: str, surface: str, intrinsic: dict[str, float]
) -> None:
    found = corrected(make())
    assert len(found.regions) == 1
    region = found.regions[0]
    assert (region.invariance_class, region.surface) == (name, surface)
    assert dict(region.intrinsic) == pytest.approx(intrinsic, rel=1e-4)
    assert region.undecided == ()
    assert set(region.log_likelihood) == set(CLASSES)


def test_a_freeform_patch_is_complex_but_for_pieces() -> None:
    # Its shape types cut it up; pieces that look revolute by themselves may stay apart.
    found = corrected(freeform())
    area = sum(r.area for r in found.regions if r.invariance_class == "complex")
    assert area > 0.75 * found.mesh.areas.sum()
    assert len(found.regions) < found.initial_region_count


@pytest.mark.parametrize("nu", [16, 40])
@pytest.mark.parametrize("rows", [1, 6])
def test_a_solid_cylinder_as_exported_and_as_meshed(nu: int, rows: int) -> None:
    found = corrected(capped_cylinder(nu=nu, nv=rows, rings=rows))
    assert sorted(r.invariance_class for r in found.regions) == ["cylindrical", "planar", "planar"]
    wall = next(r for r in found.regions if r.invariance_class == "cylindrical")
    assert wall.triangles == 2 * nu * rows
    assert wall.intrinsic["radius"] == pytest.approx(5.0)
    assert abs(wall.situation["direction"][2]) == pytest.approx(1.0)
    assert found.sharp_edge_regions == 2


def rounded_strip(n: int) -> Mesh:
    """Plane, quarter cylinder of radius 4, plane: tangent throughout, 20 mm deep."""

    def surface(t: FloatArray, v: FloatArray) -> FloatArray:
        s = t * (20.0 + TURN)
        arc = np.clip(s - 10.0, 0.0, TURN) / 4.0
        x = np.minimum(s, 10.0) + 4.0 * np.sin(arc)
        z = 4.0 * np.cos(arc) - 4.0 - np.maximum(s - 10.0 - TURN, 0.0)
        return np.column_stack([x, 20.0 * v, z])

    parts = [(0.0, 10.0, n), (10.0, 10.0 + TURN, n), (10.0 + TURN, 20.0 + TURN, n)]
    length = 20.0 + TURN
    return weld(
        *(
            sheet(lambda u, v, a=a, b=b: surface((a + (b - a) * u) / length, v), k, 2 * n)
            for a, b, k in parts
        )
    )


@pytest.mark.parametrize("n", [4, 8, 14])
def test_a_tangent_chain_is_not_swallowed(n: int) -> None:
    # All three slip along y: merging down to one common motion would make one prismatic region.
    found = corrected(rounded_strip(n))
    assert sorted(r.invariance_class for r in found.regions) == ["cylindrical", "planar", "planar"]
    # Every facet is with its own surface, the rows along the tangent lines too.
    assert [r.triangles for r in found.regions] == [4 * n * n] * 3


def part() -> Mesh:
    """A solid cylinder and, beside it, a torus: planes, a cylinder and a revolute surface."""
    ring = torus(14, 10.0, 3.0)
    return weld(
        capped_cylinder(nu=20, nv=4, rings=2),
        Mesh(ring.vertices + np.array([0.0, 0.0, 30.0]), ring.triangles),
    )


PART = part()
EXPECTED = corrected(PART)


def test_the_part_of_the_invariance_tests_is_right() -> None:
    names = sorted(r.invariance_class for r in EXPECTED.regions)
    assert names == ["cylindrical", "planar", "planar", "revolute"]


@settings(max_examples=15)
@given(poses((1e-3, 1.0, 25.4)))
def test_neither_pose_nor_unit_matters(pose: Pose) -> None:
    found = corrected(moved(PART, pose))
    assert same_partition(found.region, EXPECTED.region)
    assert np.array_equal(facet_classes(found), facet_classes(EXPECTED))


@settings(max_examples=10)
@given(st.integers(0, 1000))
def test_numbering_does_not_matter(seed: int) -> None:
    mesh, order = relabelled(PART, seed)
    found = corrected(mesh)
    assert same_partition(found.region, EXPECTED.region[order])
    assert np.array_equal(facet_classes(found), facet_classes(EXPECTED)[order])


def test_orientation_does_not_matter() -> None:
    found = corrected(flipped(PART))
    assert same_partition(found.region, EXPECTED.region)
    assert np.array_equal(facet_classes(found), facet_classes(EXPECTED))


@pytest.mark.parametrize("sigma", [1e-4, 3e-3])
def test_noise_is_estimated_and_survived(sigma: float) -> None:
    mesh = box((30.0, 20.0, 10.0), 10)
    shift = sigma * np.random.default_rng(1).normal(size=mesh.vertices.shape)
    found = corrected(Mesh(mesh.vertices + shift, mesh.triangles), noise=None)
    assert 0.5 * sigma < found.sigma < 1.5 * sigma
    planar = sum(r.area for r in found.regions if r.invariance_class == "planar")
    assert planar > 0.97 * mesh.areas.sum()


def test_a_sphere_on_a_box_as_in_the_papers_first_part() -> None:
    # A half ball stands on a plate: a curved sharp edge between sphere and plane.
    n, radius = 24, 6.0

    def cap(u: FloatArray, v: FloatArray) -> FloatArray:
        t, f = TURN * u, TURN / 4.0 * v
        return radius * np.column_stack([np.cos(f) * np.cos(t), np.cos(f) * np.sin(t), np.sin(f)])

    def plate(u: FloatArray, v: FloatArray) -> FloatArray:
        t = -TURN * u
        rho = radius + 8.0 * v
        return np.column_stack([rho * np.cos(t), rho * np.sin(t), 0.0 * u])

    found = corrected(weld(sheet(cap, n, 8), flipped(sheet(plate, n, 5))))
    assert sorted(r.invariance_class for r in found.regions) == ["planar", "spherical"]
    ball = next(r for r in found.regions if r.invariance_class == "spherical")
    assert ball.intrinsic["radius"] == pytest.approx(6.0)
    assert np.abs(ball.situation["point"]).max() < 1e-6


def test_every_solid_facet_has_a_region_and_the_counts_agree() -> None:
    assert (EXPECTED.region >= 0).all()
    assert sum(r.triangles for r in EXPECTED.regions) == len(PART.triangles)
    assert sum(r.area for r in EXPECTED.regions) == pytest.approx(PART.areas.sum())
    assert sum(r.initial_regions for r in EXPECTED.regions) >= EXPECTED.initial_region_count
    assert EXPECTED.initial_region_count == len(np.unique(EXPECTED.initial_region))
    for number, region in enumerate(EXPECTED.regions):
        assert region.id == number
        assert region.triangles == (EXPECTED.region == number).sum()


@pytest.mark.parametrize("slope", [0.25, 1.0, 1.7])
@pytest.mark.parametrize("rows", [1, 6])
def test_a_cone_with_its_apex_is_revolute(slope: float, rows: int) -> None:
    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        t, z = TURN * u, 10.0 * v
        rho = slope * (10.0 - z)
        return np.column_stack([rho * np.cos(t), rho * np.sin(t), z])

    found = corrected(weld(sheet(surface, 24, rows)))
    assert [(r.invariance_class, r.surface) for r in found.regions] == [("revolute", "cone")]
    half_angle = np.degrees(np.arctan(slope))
    assert found.regions[0].intrinsic["half_angle_deg"] == pytest.approx(half_angle, rel=1e-3)
    assert found.regions[0].situation["point"] == pytest.approx([0.0, 0.0, 10.0], abs=1e-3)
