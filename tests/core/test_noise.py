# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest
from analytic_meshes import box, capped_cylinder, cylinder, plane, sphere, torus

from gpswb.core.mesh import Mesh
from gpswb.core.noise import estimate_noise
from gpswb.core.normals import wedge_normals
from gpswb.core.sharp_edges import feature_edges
from gpswb.core.wedges import find_wedges


def estimate(mesh: Mesh) -> float:
    wedges = find_wedges(mesh, feature_edges(mesh))
    return estimate_noise(mesh, wedges, wedge_normals(mesh, wedges))


def noisy(mesh: Mesh, sigma: float) -> Mesh:
    shift = sigma * np.random.default_rng(0).normal(size=mesh.vertices.shape)
    return Mesh(mesh.vertices + shift, mesh.triangles)


@pytest.mark.parametrize("sigma", [1e-4, 3e-3, 0.02])
def test_the_noise_of_a_plane_is_found(sigma: float) -> None:
    # The lower quartile of 9-degree variances lies a little below their mean.
    found = estimate(noisy(plane(nu=40, nv=30), sigma))
    assert 0.65 * sigma < found < 1.05 * sigma


@pytest.mark.parametrize("scale", [1e-3, 1.0, 1e3])
def test_the_noise_of_a_box_scales_with_it(scale: float) -> None:
    mesh = noisy(box(n=16), 0.005)
    found = estimate(Mesh(scale * mesh.vertices, mesh.triangles))
    assert found == pytest.approx(scale * estimate(mesh), rel=1e-6)
    assert 0.6 * 0.005 < found / scale < 1.1 * 0.005


def test_curvature_is_no_noise() -> None:
    for mesh in (capped_cylinder(), box(n=8), torus(24), sphere(level=10), cylinder(nu=40)):
        assert estimate(mesh) < 1e-9


def test_a_mesh_too_small_for_a_fit_has_none() -> None:
    assert estimate(box(n=1)) == 0.0
