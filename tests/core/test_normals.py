# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
from analytic_meshes import box, cylinder, sphere

from gpswb.core.mesh import Mesh
from gpswb.core.normals import wedge_normals
from gpswb.core.sharp_edges import feature_edges
from gpswb.core.wedges import find_wedges


def test_max_weights_are_exact_on_any_triangulation_of_a_sphere() -> None:
    mesh = sphere(7.0, 4)
    rng = np.random.default_rng(0)
    uneven = mesh.vertices + 0.4 * rng.normal(size=mesh.vertices.shape)
    uneven *= 7.0 / np.linalg.norm(uneven, axis=1, keepdims=True)
    mesh = Mesh(uneven, mesh.triangles)
    normals = wedge_normals(mesh, find_wedges(mesh))
    assert np.abs(normals - uneven / 7.0).max() < 1e-12


def test_a_corner_of_a_box_has_a_wedge_and_a_normal_for_each_side() -> None:
    mesh = box(n=2)
    wedges = find_wedges(mesh, feature_edges(mesh))
    fans = np.bincount(wedges.vertex)
    # 8 corners of 3 sides, 12 edge middles of 2, 6 side middles of 1.
    assert sorted(np.unique(fans, return_counts=True)[1].tolist()) == [6, 8, 12]
    assert wedges.count == 8 * 3 + 12 * 2 + 6
    normals = wedge_normals(mesh, wedges)
    assert np.abs(normals[wedges.of_corner] - mesh.facet_normals[:, None]).max() < 1e-12


def test_without_creases_a_vertex_is_one_wedge() -> None:
    mesh = box(n=2)
    wedges = find_wedges(mesh)
    assert np.array_equal(wedges.vertex, np.arange(len(mesh.vertices)))
    assert np.array_equal(wedges.of_corner, mesh.triangles)


def test_normals_of_a_cylinder_hold_to_its_open_rims() -> None:
    mesh = cylinder(nu=16)
    normals = wedge_normals(mesh, find_wedges(mesh))
    radial = mesh.vertices * [1.0, 1.0, 0.0] / 5.0
    # Even strips: by symmetry the two sides of each generator balance exactly inside; at the
    # rims one side has two facets and the other one, of the same total Max weight.
    assert np.abs(normals - radial).max() < 1e-12


def test_three_corners_in_a_line_have_no_area_wherever_the_mesh_is() -> None:
    rng = np.random.default_rng(0)
    for far in (0.0, 1e3, 1e6):
        start, end = rng.normal(size=(2, 3)) + far
        middle = start + rng.uniform(0.2, 0.8) * (end - start)
        beside = middle + 1e-6 * np.cross(end - start, [0.0, 0.0, 1.0])
        mesh = Mesh(np.array([start, end, middle, beside]), np.array([[0, 1, 2], [0, 1, 3]]))
        assert mesh.areas[0] == 0.0
        assert not mesh.facet_normals[0].any()
        assert mesh.areas[1] > 0.0


def test_degenerate_facets_weigh_nothing() -> None:
    mesh = box(n=1)
    extra = np.concatenate([mesh.triangles, [[0, 0, 1], [2, 2, 2]]])
    with_slivers = Mesh(mesh.vertices, extra)
    before = wedge_normals(mesh, find_wedges(mesh))
    after = wedge_normals(with_slivers, find_wedges(with_slivers))
    assert np.array_equal(before, after)
