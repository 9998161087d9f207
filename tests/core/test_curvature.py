# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest
from analytic_meshes import (
    Pose,
    capped_cylinder,
    cylinder,
    flipped,
    moved,
    plane,
    poses,
    relabelled,
    sphere,
    torus,
)
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from gpswb.core.curvature import Curvature, curvedness, estimate_curvature, shape_index
from gpswb.core.mesh import FloatArray, Mesh
from gpswb.core.normals import wedge_normals
from gpswb.core.sharp_edges import feature_edges
from gpswb.core.tangent_frames import tangent_frame, turned_direction
from gpswb.core.wedges import Wedges, find_wedges


def curvature_of(mesh: Mesh, sweeps: int = 0) -> tuple[Curvature, Wedges]:
    wedges = find_wedges(mesh, feature_edges(mesh))
    return estimate_curvature(mesh, wedges, wedge_normals(mesh, wedges), sweeps), wedges


def test_cylinder_and_sphere_are_exact() -> None:
    found, _ = curvature_of(cylinder(radius=5.0))
    assert np.abs(found.k_max - 0.2).max() < 1e-12
    assert np.abs(found.k_min).max() < 1e-12
    # Across the axis: the principal direction of the greatest curvature is horizontal.
    assert np.abs(found.direction[:, 2]).max() < 1e-9
    found, _ = curvature_of(sphere(radius=7.0))
    assert np.abs(found.k_max - 1.0 / 7.0).max() < 1e-12
    assert np.abs(found.k_min - 1.0 / 7.0).max() < 1e-12


def test_creases_keep_curvature_out_of_planes() -> None:
    mesh = capped_cylinder(radius=5.0)
    found, wedges = curvature_of(mesh)
    wall = np.abs(found.normals[:, 2]) < 0.5
    assert np.abs(found.k_max[~wall]).max() < 1e-12
    assert np.abs(found.k_max[wall] - 0.2).max() < 1e-12
    assert wedges.count == len(mesh.vertices) + 2 * 36


def torus_error(n: int) -> float:
    mesh = torus(n, 10.0, 3.0)
    found, wedges = curvature_of(mesh)
    rho = np.linalg.norm(mesh.vertices[wedges.vertex][:, :2], axis=1)
    k_tube, k_axis = 1.0 / 3.0, (rho - 10.0) / 3.0 / rho
    return float(max(np.abs(found.k_max - k_tube).max(), np.abs(found.k_min - k_axis).max()))


def test_curvature_of_a_torus_converges_with_order_two() -> None:
    errors = np.array([torus_error(n) for n in (16, 32, 64)])
    orders = np.log2(errors[:-1] / errors[1:])
    assert (orders > 1.8).all()


def test_shape_index_by_sign() -> None:
    one, zero = np.ones(1), np.zeros(1)
    assert shape_index(one, one) == 1.0  # outward-convex cap
    assert shape_index(-one, -one) == -1.0
    assert shape_index(one, zero) == pytest.approx(0.5)  # ridge
    assert shape_index(zero, -one) == pytest.approx(-0.5)
    assert shape_index(one, -one) == 0.0  # saddle
    assert shape_index(zero, zero) == 0.0  # plane: defined, where (4) divides by zero
    assert curvedness(3.0 * one, -4.0 * one) == pytest.approx(np.sqrt(12.5))


@given(poses())
def test_curvature_moves_with_the_mesh_and_scales_inversely(pose: Pose) -> None:
    mesh = torus(12)
    before, _ = curvature_of(mesh)
    after, _ = curvature_of(moved(mesh, pose))
    scale = np.abs(before.k_max).max()
    assert np.abs(after.k_max * pose.scale - before.k_max).max() < 1e-8 * scale
    assert np.abs(after.k_min * pose.scale - before.k_min).max() < 1e-8 * scale
    assert np.abs(after.shape_index - before.shape_index).max() < 1e-7


@given(st.integers(0, 100))
def test_curvature_does_not_see_the_numbering(seed: int) -> None:
    mesh = torus(12)
    other, _ = relabelled(mesh, seed)
    before, after = (curvature_of(m) for m in (mesh, other))

    def by_place(found: tuple[Curvature, Wedges], m: Mesh) -> FloatArray:
        points = m.vertices[found[1].vertex]
        order = np.lexsort(np.round(points, 6).T)
        return found[0].k_min[order]

    assert np.abs(by_place(before, mesh) - by_place(after, other)).max() < 1e-10


def test_flipping_the_mesh_swaps_and_negates() -> None:
    mesh = torus(12)
    before, wedges = curvature_of(mesh)
    after, turned = curvature_of(flipped(mesh))
    a, b = np.argsort(wedges.vertex), np.argsort(turned.vertex)
    assert np.abs(after.k_max[b] + before.k_min[a]).max() < 1e-12
    assert np.abs(after.shape_index[b] + before.shape_index[a]).max() < 1e-10


def test_averaging_under_noise_brings_the_curvature_nearer() -> None:
    mesh = cylinder(radius=5.0, nu=90, nv=60)
    noise = 0.01 * np.random.default_rng(3).normal(size=mesh.vertices.shape)
    noisy = Mesh(mesh.vertices + noise, mesh.triangles)
    errors = []
    for sweeps in (0, 2, 6):
        found, _ = curvature_of(noisy, sweeps)
        errors.append(float(np.median(np.abs(found.k_max - 0.2))))
    assert errors[0] > 2.0 * errors[1] > 2.0 * errors[2]


def test_averaging_stops_at_creases() -> None:
    found, _ = curvature_of(capped_cylinder(radius=5.0), sweeps=5)
    flat = np.abs(found.normals[:, 2]) > 0.5
    assert np.abs(found.k_max[flat]).max() < 1e-12
    assert np.abs(found.k_max[~flat] - 0.2).max() < 1e-12


@given(st.integers(0, 10**6))
def test_closed_form_eigenvalues(seed: int) -> None:
    rng = np.random.default_rng(seed)
    n = rng.normal(size=(20, 3))
    n /= np.linalg.norm(n, axis=1, keepdims=True)
    u, v = tangent_frame(n)
    frame = np.stack([u, v, n], axis=1)
    assert np.abs(frame @ np.swapaxes(frame, 1, 2) - np.eye(3)).max() < 1e-12
    mean, even, odd = rng.normal(size=(3, 20))
    found = Curvature(n, mean, even + 1j * odd, np.zeros(0), np.zeros(0))
    local = np.array([[mean + even, odd], [odd, mean - even]]).transpose(2, 0, 1)
    exact = np.linalg.eigvalsh(local)
    assert np.abs(np.column_stack([found.k_min, found.k_max]) - exact).max() < 1e-12
    tensor = np.swapaxes(frame[:, :2], 1, 2) @ local @ frame[:, :2]
    pulled = np.einsum("nij,nj->ni", tensor, found.direction)
    assert np.abs(pulled - found.k_max[:, None] * found.direction).max() < 1e-11


@given(st.integers(0, 10**6))
def test_a_direction_turns_by_the_least_rotation_between_normals(seed: int) -> None:
    rng = np.random.default_rng(seed)
    start, end = rng.normal(size=(2, 20, 3))
    start, end = (n / np.linalg.norm(n, axis=1, keepdims=True) for n in (start, end))
    apart = np.einsum("ni,ni->n", start, end) > -0.9
    start, end = start[apart], end[apart]
    vector = tangent_frame(start)[1]
    axis = np.cross(start, end)
    axis /= np.linalg.norm(axis, axis=1, keepdims=True)
    angle = np.arctan2(
        np.linalg.norm(np.cross(start, end), axis=1), np.einsum("ni,ni->n", start, end)
    )
    turned = Rotation.from_rotvec(angle[:, None] * axis).apply(vector)
    cos, sin = turned_direction(vector.T, start.T, end.T)
    u, v = tangent_frame(end)
    assert np.abs(cos[:, None] * u + sin[:, None] * v - turned).max() < 1e-12


def test_a_plane_has_none() -> None:
    found, _ = curvature_of(plane())
    assert np.abs(found.k_max).max() < 1e-15
    assert np.abs(found.k_min).max() < 1e-15
