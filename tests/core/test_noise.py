# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest
from analytic_meshes import box, capped_cylinder, cone, cylinder, plane, sphere, torus, weld

from gpswb.core.mesh import Mesh
from gpswb.core.noise import estimate_noise


def noisy(mesh: Mesh, sigma: float) -> Mesh:
    shift = sigma * np.random.default_rng(0).normal(size=mesh.vertices.shape)
    return Mesh(mesh.vertices + shift, mesh.triangles)


@pytest.mark.parametrize("share", [2e-4, 1e-3, 5e-3])
@pytest.mark.parametrize(
    "mesh",
    [plane(nu=40, nv=30), box(n=16), capped_cylinder(), sphere(level=10), torus(n=40)],
    ids=["plane", "box", "capped cylinder", "sphere", "torus"],
)
def test_the_noise_is_found(mesh: Mesh, share: float) -> None:
    # A thousand variances of thirteen degrees of freedom: within one percent, were they apart; they
    # overlap, and the largest are taken for creases.
    sigma = share * mesh.diagonal
    assert estimate_noise(noisy(mesh, sigma)) == pytest.approx(sigma, rel=0.1)


@pytest.mark.parametrize("scale", [1e-3, 1.0, 1e3])
def test_the_noise_scales_with_the_mesh(scale: float) -> None:
    mesh = noisy(box(n=16), 0.005)
    found = estimate_noise(Mesh(scale * mesh.vertices, mesh.triangles))
    assert found == pytest.approx(scale * estimate_noise(mesh), rel=1e-6)


def test_curvature_is_no_noise() -> None:
    for mesh in (capped_cylinder(), box(n=8), torus(24), sphere(level=10), cylinder(nu=40), cone()):
        assert estimate_noise(mesh) < 1e-9


@pytest.mark.parametrize("n", [1, 2])
def test_a_block_of_few_triangles_has_none(n: int) -> None:
    """Every vertex is at an edge, so that every fit bends; but facets lie in one plane."""
    assert estimate_noise(box(n=n)) == 0.0


def rough_wall() -> Mesh:
    """A cylinder with exact caps whose wall is off by 1e-4 of the diagonal."""
    mesh = capped_cylinder(nu=72, nv=24)
    x, y, z = mesh.vertices.T
    inner = (z > 0.0) & (z < z.max())
    roughness = 1e-4 * mesh.diagonal * np.random.default_rng(0).normal(size=len(x))
    radial = 1.0 + np.where(inner, roughness / np.maximum(np.hypot(x, y), 1e-9), 0.0)
    return Mesh(np.column_stack([x * radial, y * radial, z]), mesh.triangles)


def test_exact_planes_do_not_hide_a_rough_wall() -> None:
    mesh = rough_wall()
    assert estimate_noise(mesh) == pytest.approx(1e-4 * mesh.diagonal, rel=0.1)


def test_where_a_coarse_cylinder_is_exact_nothing_is_noise() -> None:
    # Three facets a quarter turn: no polynomial fits it. What looks rough beside it is coarse, too.
    mesh = rough_wall()
    exact = cylinder(nu=12, nv=8)
    apart = Mesh(exact.vertices + mesh.diagonal, exact.triangles)
    assert estimate_noise(weld(mesh, apart)) == 0.0


def test_a_few_facets_that_bend_are_no_sample() -> None:
    mesh = rough_wall()
    apart = box(n=70)
    assert len(mesh.triangles) < 0.1 * len(apart.triangles)
    assert estimate_noise(weld(mesh, Mesh(apart.vertices + 10.0, apart.triangles))) == 0.0


def test_a_mesh_too_small_for_a_fit_has_none() -> None:
    assert estimate_noise(box(n=1)) == 0.0
