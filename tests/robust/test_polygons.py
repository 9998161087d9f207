# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coplanar facets, and which of them can only be planes."""

from __future__ import annotations

import numpy as np
import pytest
from analytic_meshes import (
    Pose,
    box,
    capped_cylinder,
    cylinder,
    moved,
    poses,
    relabelled,
    sheet,
    sphere,
)
from hypothesis import given, settings
from known_surfaces import full_torus

from gpswb.core.mesh import FloatArray, IntArray, Mesh
from gpswb.core.robust.consensus import CREASE
from gpswb.core.robust.polygons import certain_planes, coplanar_polygons
from gpswb.core.robust.strips import STRIPS, few_polygons
from gpswb.core.robust.topology import FacetGraph


def polygons(mesh: Mesh) -> tuple[IntArray, np.ndarray]:
    tolerance = 1e-7 * mesh.diagonal
    graph = FacetGraph.of(mesh)
    polygon = coplanar_polygons(mesh, graph, tolerance)
    return polygon, certain_planes(mesh, graph, polygon, tolerance)


@pytest.mark.parametrize("n", [1, 2, 5])
def test_a_box_has_six_polygons(n: int) -> None:
    polygon, certain = polygons(box(n=n))
    assert np.bincount(polygon).tolist() == [2 * n * n] * 6
    # Four corners could be a strip of a cylinder; five vertices off two lines can't.
    assert certain.tolist() == [n > 1] * 6


@pytest.mark.parametrize("rows", [1, 4])
def test_strips_between_two_rulings_prove_nothing(rows: int) -> None:
    polygon, certain = polygons(cylinder(nu=12, nv=rows))
    assert np.bincount(polygon).tolist() == [2 * rows] * 12
    assert not certain.any()


def test_the_caps_of_a_cylinder_are_certain() -> None:
    polygon, certain = polygons(capped_cylinder(nu=20, nv=3))
    # 20 strips and two discs.
    assert len(certain) == 22
    assert sorted(np.bincount(polygon)[certain].tolist()) == [140, 140]


def test_two_rings_about_the_top_of_a_torus_lie_in_a_plane() -> None:
    polygon, certain = polygons(full_torus(10))
    # Elsewhere every quad is a flat trapezoid of its own; the flat rings hold 20 of them each.
    assert np.sort(np.bincount(polygon)).tolist() == [2] * 160 + [40, 40]
    assert np.flatnonzero(np.bincount(polygon) == 40).tolist() == np.flatnonzero(certain).tolist()


def test_a_fine_mesh_of_a_large_sphere_is_no_plane() -> None:
    # Neighbours are within 1e-7 of the diagonal of each other's planes, yet the mesh curves.
    _, certain = polygons(sphere(radius=1e3, level=20))
    assert not certain.any()


@settings(max_examples=10)
@given(pose=poses())
def test_polygons_depend_on_neither_pose_nor_unit_nor_order(pose: Pose) -> None:
    mesh = capped_cylinder(nu=20, nv=3)
    polygon, certain = polygons(mesh)
    other, order = relabelled(moved(mesh, pose), 4)
    found, sure = polygons(other)
    assert len(sure) == len(certain)
    # Equal as partitions: the pairs of labels are as many as the labels.
    assert len(np.unique(np.column_stack([polygon[order], found]), axis=0)) == len(certain)
    assert (sure[found] == certain[polygon][order]).all()


@pytest.mark.parametrize("count", [2, STRIPS - 1, STRIPS, 2 * STRIPS - 2, 2 * STRIPS - 1])
def test_few_strips_in_a_row_are_planes(count: int) -> None:
    # Each strip turns by 20 degrees: smooth.
    mesh = cylinder(nu=count, nv=2, arc=count / 18)
    graph = FacetGraph.of(mesh)
    polygon, _ = polygons(mesh)
    everything = np.ones(len(mesh.triangles), dtype=bool)
    few = few_polygons(graph, polygon, everything)
    assert few.tolist() == [count < STRIPS] * len(few)
    # A feature edge, or a part that isn't looked at, breaks the row.
    halves = (2 * polygon[graph.pairs] < count).sum(axis=1) == 1
    assert few_polygons(graph, polygon, everything, halves).all() == (count < 2 * STRIPS - 1)
    rest = polygon > 1
    assert few_polygons(graph, polygon, rest).tolist() == (rest & (count - 2 < STRIPS)).tolist()


def test_sides_that_meet_at_creases_are_planes() -> None:
    # A hexagon turns by 60 degrees, a decagon by 36.
    for sides, expected in ((6, True), (10, False)):
        assert (2 * np.pi / sides > CREASE) == expected
        mesh = cylinder(nu=sides, nv=2)
        few = few_polygons(
            FacetGraph.of(mesh), polygons(mesh)[0], np.ones(len(mesh.triangles), dtype=bool)
        )
        assert few.tolist() == [expected] * len(few)


def test_a_plane_that_ends_at_a_tiny_bend_stays_one() -> None:
    # The bend turns so little from facet to facet that it is joined to the plane at first.
    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        x = 10.0 * u
        beyond = np.maximum(x - 5.0, 0.0)
        return np.column_stack([x, 10.0 * v, 1.5e-5 * beyond**2])

    mesh = sheet(surface, 50, 3)
    polygon, certain = polygons(mesh)
    flat = (mesh.vertices[mesh.triangles][:, :, 0] < 5.0 + 1e-9).all(axis=1)
    (number,) = np.unique(polygon[flat])
    assert certain[number]
    assert (polygon == number).sum() == flat.sum()
