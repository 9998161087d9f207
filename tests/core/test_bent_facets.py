# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
from analytic_meshes import Pose, box, capped_cylinder, moved, poses
from hypothesis import given

from gpswb.core.curvature import estimate_curvature
from gpswb.core.half_edges import interior_edges
from gpswb.core.mesh import Mesh
from gpswb.core.normals import wedge_normals
from gpswb.core.sharp_edges import feature_edges
from gpswb.core.wedges import find_wedges


@given(poses())
def test_inside_the_faces_of_a_box_nothing_is_bent(pose: Pose) -> None:
    mesh = box((30.0, 20.0, 10.0), 5)
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    on_edge = ((mesh.vertices == low) | (mesh.vertices == high)).sum(axis=1) >= 2
    touching = np.flatnonzero(on_edge[mesh.triangles].any(axis=1))
    assert 0 < len(touching) < len(mesh.triangles)
    assert moved(mesh, pose).bent_facets.tolist() == touching.tolist()


def test_caps_are_plane_and_the_side_between_them_curved() -> None:
    mesh = capped_cylinder(nu=48, nv=6, rings=4)
    wedges = find_wedges(mesh, feature_edges(mesh))
    curvature = estimate_curvature(mesh, wedges, wedge_normals(mesh, wedges))
    cap = np.abs(mesh.facet_normals[:, 2]) > 0.99
    assert len(mesh.bent_facets) < len(mesh.triangles)
    np.testing.assert_allclose(curvature.facet_mean[cap], 0.0, atol=1e-12)
    radius = np.hypot(*mesh.vertices[:, :2].T).max()
    np.testing.assert_allclose(curvature.facet_mean[~cap], 0.5 / radius, rtol=0.01)


def test_what_cannot_be_told_is_bent() -> None:
    # Three sheets along one side, which has no two facets of its own: each is plane in itself.
    fan = np.array([[0, 0, 0], [0, 0, 1], [1, 0, 0], [0, 1, 0], [-1, 0, 0]], dtype=float)
    assert len(Mesh(fan, np.array([[0, 1, 2], [0, 1, 3], [1, 0, 4]])).bent_facets) == 3
    # A triangle without area hides the crease between its neighbours.
    ridge = np.array([[0, 0, 0], [2, 0, 0], [1, 0, 0], [1, 1, 1], [1, -1, 1]], dtype=float)
    hidden = Mesh(ridge, np.array([[0, 2, 3], [2, 1, 3], [1, 2, 0], [0, 1, 4]]))
    assert hidden.areas[2] == 0.0
    assert hidden.bent_facets.tolist() == [0, 1, 2, 3]


def test_edges_are_the_same_where_numbers_are_too_large_to_pack() -> None:
    triangles = box((30.0, 20.0, 10.0), 3).triangles
    few, many = (interior_edges(triangles, count) for count in (1000, 2**31))
    for small, large in zip(few, many, strict=True):
        np.testing.assert_array_equal(small, large)
    assert len(few[0]) == 1.5 * len(triangles)
