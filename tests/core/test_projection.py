# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
from analytic_meshes import box, plane

from gpswb.core.mesh import Mesh
from gpswb.core.projection import (
    facets_from_vertices,
    fill_facets,
    number_facet_regions,
    vertices_from_facets,
)


def test_facets_take_the_majority_and_sharp_vertices_give_way() -> None:
    labels = np.array([1, 1, 2, 6, 6])
    sharp = labels == 6
    triangles = np.array([[0, 1, 2], [2, 0, 1], [3, 2, 4], [3, 0, 2], [2, 3, 0], [3, 4, 3]])
    found = facets_from_vertices(labels, triangles, sharp)
    assert found.tolist() == [1, 1, 2, 1, 2, 6]


def test_vertices_take_the_largest_area() -> None:
    mesh = Mesh(
        np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [-3, 0, 0], [9, 9, 9]]),
        np.array([[0, 1, 2], [0, 2, 3]]),
    )
    found = vertices_from_facets(np.array([4, 7]), mesh)
    assert found.tolist() == [7, 4, 7, 7, 4]
    assert vertices_from_facets(np.array([4, 7]), mesh, np.array([5.0, 1.0]))[0] == 4


def test_labels_survive_the_way_there_and_back_on_a_box() -> None:
    mesh = box(n=4)
    side = np.argmax(np.abs(mesh.facet_normals), axis=1) + 3 * (
        mesh.facet_normals.max(axis=1) > 0.5
    )
    vertex = vertices_from_facets(side, mesh)
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    faces = (np.abs(mesh.vertices - low) < 1e-9) | (np.abs(mesh.vertices - high) < 1e-9)
    back = facets_from_vertices(vertex, mesh.triangles, faces.sum(axis=1) > 1)
    inner = (faces.sum(axis=1)[mesh.triangles] == 1).any(axis=1)
    assert np.array_equal(back[inner], side[inner])


def test_holes_are_filled_along_the_surface() -> None:
    mesh = box(n=4)
    side = np.argmax(np.abs(mesh.facet_normals), axis=1) + 3 * (
        mesh.facet_normals.max(axis=1) > 0.5
    )
    holed = side.copy()
    holed[np.random.default_rng(0).random(len(side)) < 0.6] = -1
    assert set(holed[holed >= 0].tolist()) == set(range(6))
    assert np.array_equal(fill_facets(holed, mesh), side)


def test_what_no_label_reaches_gets_labels_of_its_own() -> None:
    one = plane(nu=2, nv=2)
    both = Mesh(
        np.concatenate([one.vertices, one.vertices + np.array([0.0, 0.0, 9.0])]),
        np.concatenate([one.triangles, one.triangles + len(one.vertices)]),
    )
    label = np.full(16, -1)
    label[3] = 5
    filled = fill_facets(label, both)
    assert (filled[:8] == 5).all()
    assert len(set(filled[8:].tolist())) == 1
    assert filled[8] > 5


def test_degenerate_facets_are_in_no_region() -> None:
    mesh = Mesh(
        np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [2, 0, 0]]),
        np.array([[0, 1, 3], [0, 1, 2]]),
    )
    region, count = number_facet_regions(np.array([7, 9]), mesh)
    assert region.tolist() == [-1, 0]
    assert count == 1
