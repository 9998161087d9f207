# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest
from analytic_meshes import (
    TURN,
    Pose,
    box,
    capped_cylinder,
    edge_set,
    extrusion,
    moved,
    poses,
    sheet,
    sphere,
    torus,
    weld,
)
from hypothesis import given

from gpswb.core.curvature import curvedness
from gpswb.core.discrete_curvature import discrete_curvatures
from gpswb.core.mesh import BoolArray, FloatArray, Mesh
from gpswb.core.normals import wedge_normals
from gpswb.core.sharp_edges import feature_edges, sharp_vertices_by_curvedness
from gpswb.core.wedges import find_wedges


def on_box_edges(mesh: Mesh) -> BoolArray:
    """Interior edges of the mesh that lie on an edge of the box."""
    p = mesh.vertices[mesh.pair_edges]
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    flush = ((np.abs(p - low) < 1e-9) | (np.abs(p - high) < 1e-9)).all(axis=1)
    return np.asarray(flush.sum(axis=1) >= 2)


@given(poses())
def test_a_box_has_its_twelve_edges(pose: Pose) -> None:
    mesh = box((30.0, 20.0, 10.0), 5)
    exact = edge_set(mesh, on_box_edges(mesh))
    assert len(exact) == 12 * 5
    assert edge_set(mesh, feature_edges(moved(mesh, pose))) == exact


@pytest.mark.parametrize("nu", [16, 24, 72])
def test_a_cylinder_has_its_two_rims_at_any_density(nu: int) -> None:
    # 16 sides turn by 22.5 degrees an edge: less than a rim, more than many a real crease.
    mesh = capped_cylinder(nu=nu, nv=1, rings=1)
    z = mesh.vertices[mesh.pair_edges][:, :, 2]
    rho = np.linalg.norm(mesh.vertices[mesh.pair_edges][:, :, :2], axis=2)
    rims = (z[:, 0] == z[:, 1]) & (rho > 4.9).all(axis=1)
    assert rims.sum() == 2 * nu
    assert edge_set(mesh, feature_edges(mesh)) == edge_set(mesh, rims)


def test_smooth_surfaces_have_none() -> None:
    for mesh in (sphere(level=4), torus(14), extrusion(24, 6)):
        assert mesh.turning.max() > 0.1
        assert not feature_edges(mesh).any()


def test_a_shallow_crease_between_planes_is_found() -> None:
    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        x = 20.0 * u - 10.0
        return np.column_stack([x, 10.0 * v, -0.1 * np.maximum(x, 0.0)])

    mesh = sheet(surface, 12, 6)
    middle = np.abs(mesh.vertices[mesh.pair_edges][:, :, 0]).max(axis=1) < 1e-9
    assert middle.sum() == 6
    assert edge_set(mesh, feature_edges(mesh)) == edge_set(mesh, middle)


@pytest.mark.parametrize("strips", [1, 2, 5])
def test_a_rounding_between_planes_has_none(strips: int) -> None:
    # Two planes at 28 degrees, joined by a tangent cylinder of a few strips.
    bend = 28.0 / 360.0 * TURN

    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        t = bend * u
        return np.column_stack([10.0 * np.sin(t), 15.0 * v, 10.0 * np.cos(t) - 10.0])

    def flat(u: FloatArray, v: FloatArray) -> FloatArray:
        return np.column_stack([-12.0 * (1.0 - u), 15.0 * v, 0.0 * u])

    def tilted(u: FloatArray, v: FloatArray) -> FloatArray:
        end = np.array([10.0 * np.sin(bend), 0.0, 10.0 * np.cos(bend) - 10.0])
        along = np.array([np.cos(bend), 0.0, -np.sin(bend)])
        return end + 12.0 * u[:, None] * along + np.column_stack([0 * u, 15.0 * v, 0 * u])

    mesh = weld(sheet(surface, strips, 3), sheet(flat, 3, 3), sheet(tilted, 3, 3))
    assert mesh.turning.max() > 0.03
    assert not feature_edges(mesh).any()


def printed_sharp(mesh: Mesh) -> BoolArray:
    k_max, k_min = discrete_curvatures(mesh, wedge_normals(mesh, find_wedges(mesh)))
    return sharp_vertices_by_curvedness(curvedness(k_max, k_min))


def test_the_printed_threshold_finds_even_edges_and_misses_uneven_ones() -> None:
    even = box((10.0, 10.0, 10.0), 4)
    edge = np.unique(even.pair_edges[on_box_edges(even)])
    assert set(np.flatnonzero(printed_sharp(even)).tolist()) == set(edge.tolist())
    # Beside a finely meshed box, c_max is the fine one's: none of the coarse edges is found.
    fine = box((1.0, 1.0, 1.0), 4)
    both = Mesh(
        np.concatenate([even.vertices, fine.vertices + 20.0]),
        np.concatenate([even.triangles, fine.triangles + len(even.vertices)]),
    )
    found = printed_sharp(both)
    assert found[len(even.vertices) :].sum() == len(edge)
    assert not found[: len(even.vertices)].any()
    # The dihedral angle does not mind.
    assert feature_edges(both).sum() == 2 * on_box_edges(even).sum()


def test_the_coefficient_lowers_the_threshold() -> None:
    c = np.array([0.0, 1.0, 2.0, 4.0])
    assert sharp_vertices_by_curvedness(c, 1.0).tolist() == [False, False, False, True]
    assert sharp_vertices_by_curvedness(c, 0.4).tolist() == [False, True, True, True]
    assert not sharp_vertices_by_curvedness(np.zeros(0)).any()
