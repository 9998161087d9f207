# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the facets on a surface prove, and what they don't."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from analytic_meshes import TURN, cylinder, sheet, weld
from known_surfaces import Frame, full_torus, patch_mesh, point_on, surface_of
from scipy.spatial import Delaunay

from gpswb.core.mesh import FloatArray, Mesh
from gpswb.core.robust.evidence import (
    EXACT,
    LINES,
    SURE_LINES,
    distinct_rulings,
    drifts,
    enough_evidence,
    is_exact,
    sagitta,
)
from gpswb.core.robust.growth import Grown, residual
from gpswb.core.robust.one_profile import PROFILE, places_on_tube
from gpswb.core.robust.surfaces import Kind
from gpswb.core.robust.topology import FacetGraph

Z_AXIS = Frame(0)
Z_AXIS.rotation, Z_AXIS.origin = np.eye(3), np.zeros(3)


def whole(mesh: Mesh, kind: Kind, frame: Frame = Z_AXIS) -> Grown:
    return Grown(kind, surface_of(kind, frame), np.arange(len(mesh.triangles)))


@pytest.mark.parametrize("count", [1, 2, 5, 40])
def test_rulings_and_places_are_counted(count: int) -> None:
    rng = np.random.default_rng(count)
    frame = Frame(count)
    # Over the half turn where angles jump, each angle many times.
    angle = np.tile(np.pi + np.linspace(-0.4, 0.5, count), 6)
    other = rng.uniform(-1.0, 1.0, len(angle))
    points = frame.point(point_on("cylinder", angle, other))
    assert distinct_rulings(points, surface_of("cylinder", frame)) == count
    points = frame.point(point_on("torus", other, angle))
    place = places_on_tube(points, surface_of("torus", frame))
    assert place.tolist() in ([*range(count)] * 6, [*range(count)][::-1] * 6)


def test_rulings_of_a_full_turn() -> None:
    mesh = cylinder(nu=17, nv=3)
    assert distinct_rulings(mesh.vertices, surface_of("cylinder", Z_AXIS)) == 17


@pytest.mark.parametrize("half_angle", [0.05, 0.3, 0.7])
def test_sagitta_of_an_arc(half_angle: float) -> None:
    frame = Frame(1)
    mesh = sheet(
        lambda u, v: frame.point(point_on("cylinder", half_angle * (2 * u - 1), 20.0 * v)), 8, 4
    )
    expected = 5.0 * (1.0 - np.cos(half_angle))
    assert sagitta(mesh, whole(mesh, "cylinder", frame)) == pytest.approx(expected)


@pytest.mark.parametrize("strips", range(1, 7))
def test_a_cylinder_needs_four_rulings_and_five_to_be_sure(strips: int) -> None:
    mesh = cylinder(nu=strips, nv=3, arc=strips / 20)
    grown = whole(mesh, "cylinder")
    assert enough_evidence(mesh, FacetGraph.of(mesh), grown, 1e-6) == (strips + 1 >= LINES)
    assert is_exact(mesh, grown) == (strips + 1 >= SURE_LINES)


@pytest.mark.parametrize("rings", range(2, 8))
def test_a_torus_needs_five_places_on_its_tube(rings: int) -> None:
    mesh = sheet(lambda u, v: point_on("torus", 2.0 * u, 1.5 * v), 12, rings - 1)
    grown = whole(mesh, "torus")
    assert enough_evidence(mesh, FacetGraph.of(mesh), grown, 1e-6) == (rings >= PROFILE)


def test_three_places_prove_a_torus_where_facets_reach_across_the_middle_one() -> None:
    turn = np.linspace(-0.6, 0.6, 9)
    start, middle, end = (
        point_on("torus", turn, np.full(len(turn), tube)) for tube in (0.1, 0.7, 1.5)
    )
    # Two of the middle ring's vertices are left out.
    middle = np.delete(middle, [4, 5], axis=0)
    points = np.concatenate([start, middle, end])
    strip = np.c_[points @ [0.0, 1.0, 0.0], np.repeat([0.0, 1.0, 2.0], [9, 7, 9])]
    mesh = Mesh(points, Delaunay(strip).simplices)
    grown = whole(mesh, "torus")
    assert enough_evidence(mesh, FacetGraph.of(mesh), grown, 1e-6)


def test_a_sphere_needs_eight_vertices() -> None:
    for n, expected in ((1, False), (2, True)):
        mesh = patch_mesh("sphere", Frame(3), n)
        found = enough_evidence(mesh, FacetGraph.of(mesh), whole(mesh, "sphere", Frame(3)), 1e-6)
        assert found == expected  # 4 vertices in two facets; 9 in eight


def test_what_is_flat_to_the_tolerance_proves_no_curvature() -> None:
    mesh = cylinder(nu=8, nv=3, arc=0.1)
    grown = whole(mesh, "cylinder")
    height = sagitta(mesh, grown)
    graph = FacetGraph.of(mesh)
    assert enough_evidence(mesh, graph, grown, height / 21.0)
    assert not enough_evidence(mesh, graph, grown, height / 19.0)


@pytest.mark.parametrize("share", [0.5, 2.0])
def test_exact_means_that_it_bends_far_more_than_it_stands_off(share: float) -> None:
    mesh = patch_mesh("sphere", Z_AXIS, 8)
    height = sagitta(mesh, whole(mesh, "sphere"))
    off = share * height / EXACT
    # All vertices by as much, half of them inwards: the sphere stays in the middle.
    sign = np.where(np.arange(len(mesh.vertices)) % 2, 1.0, -1.0)
    moved = Mesh(mesh.vertices * (1.0 + 0.6745 * off * sign / 7.0)[:, None], mesh.triangles)
    assert is_exact(moved, whole(mesh, "sphere")) == (share < 1.0)


def test_a_border_vertex_out_of_place_makes_a_region_no_less_exact() -> None:
    mesh = patch_mesh("sphere", Z_AXIS, 8)
    vertices = mesh.vertices.copy()
    vertices[0] *= 1.01
    moved = Mesh(vertices, mesh.triangles)
    assert residual(moved, whole(mesh, "sphere")) == pytest.approx(0.07, rel=1e-6)
    assert is_exact(moved, whole(mesh, "sphere"))


def bent_strip(curvature_beyond: Callable[[FloatArray], FloatArray]) -> tuple[Mesh, Grown]:
    """A sheet that is a cylinder R5 for 12 facets of 7.5 degrees, then bends as it is told.

    Args:
        curvature_beyond: (n,) 1/mm at (n,) mm of arc length behind the cylinder's end.
    """
    step, fine = TURN / 48 * 5.0, 50
    # Integrate the heading, then the position, along the profile beyond the end at (5, 0).
    s = np.arange(12 * fine + 1) * step / fine
    half = 0.5 * (s[1:] + s[:-1])
    heading = np.r_[0.0, np.cumsum(curvature_beyond(half) * np.diff(s))]
    middle = 0.5 * (heading[1:] + heading[:-1])
    x = 5.0 - np.r_[0.0, np.cumsum(np.sin(middle) * np.diff(s))]
    y = np.r_[0.0, np.cumsum(np.cos(middle) * np.diff(s))]
    angle = (np.arange(12) - 12) * step / 5.0
    profile = np.concatenate(
        [5.0 * np.column_stack([np.cos(angle), np.sin(angle)]), np.column_stack([x, y])[::fine]]
    )

    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        return np.column_stack([profile[np.rint(24 * u).astype(int)], 10.0 * v])

    mesh = sheet(surface, 24, 4)
    facets = np.flatnonzero((mesh.corners[:, :, 1] <= 1e-9).all(axis=1))
    return mesh, Grown("cylinder", surface_of("cylinder", Z_AXIS), facets)


def test_a_tangent_plane_leaves_a_cylinder_at_once() -> None:
    mesh, grown = bent_strip(np.zeros_like)
    assert not drifts(mesh, FacetGraph.of(mesh), grown, 1e-6)


def test_a_surface_whose_curvature_changes_gradually_drifts() -> None:
    mesh, grown = bent_strip(lambda s: 0.2 - 0.01 * s)
    assert drifts(mesh, FacetGraph.of(mesh), grown, 1e-6)


def test_what_ends_at_a_border_or_a_crease_does_not_drift() -> None:
    mesh = cylinder(nu=12, nv=4, arc=0.5)
    assert not drifts(mesh, FacetGraph.of(mesh), whole(mesh, "cylinder"), 1e-6)
    floor = sheet(lambda u, v: np.column_stack([10 * u - 5, 10 * v - 5, 0 * u]), 1, 1)
    both = weld(mesh, floor)
    grown = Grown("cylinder", surface_of("cylinder", Z_AXIS), np.arange(len(mesh.triangles)))
    assert not drifts(both, FacetGraph.of(both), grown, 1e-6)


def test_a_whole_torus_is_exact() -> None:
    mesh = full_torus(12)
    assert residual(mesh, whole(mesh, "torus")) < 1e-13
    assert is_exact(mesh, whole(mesh, "torus"))
