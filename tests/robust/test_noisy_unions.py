# SPDX-License-Identifier: LGPL-2.1-or-later
"""Swept and freeform faces under noise: one region each, as exact as the noise allows, and the
simple faces beside them stay what they are."""

from __future__ import annotations

import numpy as np
import pytest
from analytic_meshes import TURN, extrusion, freeform, helicoid, sheet

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray, Mesh
from gpswb.core.noisy.freeform import fit_freeform
from gpswb.core.noisy.noisy_mesh import NoisyMesh
from gpswb.core.noisy.swept_fit import fit_swept, shown_motions
from gpswb.core.pipeline import partition

SHARE = 1e-3
"""Sigma over the diagonal."""


def vase(nu: int = 60, nv: int = 20) -> Mesh:
    """A wave turned about z, three quarters of a turn."""

    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        rho, phi = 6.0 + 1.5 * np.sin(TURN * v), 0.75 * TURN * u
        return np.column_stack([rho * np.cos(phi), rho * np.sin(phi), 12.0 * v])

    return sheet(surface, nu, nv)


def rounded_edge(radius: float, nu: int = 120, nv: int = 20) -> Mesh:
    """Two planes of 20 by 15 and the quarter cylinder that rounds their edge."""
    arc = 0.25 * TURN * radius

    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        s = u * (40.0 + arc) - 20.0
        t = np.clip(s, 0.0, arc) / radius
        x = np.minimum(s, 0.0) + radius * np.sin(t)
        y = radius * (np.cos(t) - 1.0) - np.maximum(s - arc, 0.0)
        return np.column_stack([x, y, 15.0 * v])

    return sheet(surface, nu, nv)


def noisy(mesh: Mesh, seed: int) -> tuple[Mesh, float]:
    sigma = SHARE * mesh.diagonal
    random = np.random.default_rng(seed)
    moved = mesh.vertices + random.normal(0.0, sigma, mesh.vertices.shape)
    return Mesh(moved, mesh.triangles), sigma


def expect_noise(chi: float, count: int, unknowns: float) -> None:
    """Chi-square is that of noise: within five of its standard deviations."""
    freedom = count - unknowns
    assert abs(chi - freedom) < 5.0 * np.sqrt(2.0 * freedom)


@pytest.mark.parametrize(
    ("name", "mesh"),
    [("prismatic", extrusion(60, 20)), ("revolute", vase()), ("helical", helicoid(10.0, 120, 20))],
)
def test_a_motion_is_known_to_its_standard_error(name: InvarianceClass, mesh: Mesh) -> None:
    disturbed, sigma = noisy(mesh, 1)
    facets, known = np.arange(len(mesh.triangles)), NoisyMesh.of(disturbed, sigma)
    shown, slip = shown_motions(known, facets)[name]
    assert slip < 1e-3
    found = fit_swept(known, facets, name, [shown])
    assert found is not None
    expect_noise(found.chi, found.count, len(found.curve.c))
    # A tilt lifts the ends of the axis, of which half of the vertices know at least.
    tilt = sigma * np.sqrt(12.0 / (0.5 * found.count)) / float(np.ptp(mesh.vertices[:, 2]))
    assert np.hypot(*found.reference.direction[:2]) < 4.0 * tilt
    if name == "helical":
        assert abs(found.reference.lead) == pytest.approx(10.0, abs=0.05)
    d, normal = found.distance(mesh.vertices)
    # The profile averages the noise of the vertices it was fitted to.
    assert np.sqrt(np.mean(d**2)) < 0.3 * sigma
    off = mesh.centroids - 0.01 * mesh.facet_normals
    gap = found.side * (found.distance(mesh.centroids)[0] - found.distance(off)[0])
    assert np.abs(gap - 0.01).max() < 2e-3
    np.testing.assert_allclose(np.linalg.norm(normal, axis=1), 1.0, atol=1e-9)


def test_a_freeform_surface_is_smooth_within_the_noise() -> None:
    mesh = freeform(40)
    disturbed, sigma = noisy(mesh, 2)
    found = fit_freeform(NoisyMesh.of(disturbed, sigma), np.arange(len(mesh.triangles)))
    assert found is not None
    expect_noise(found.chi, found.count, found.freedom)
    # A cubic patch has ten coefficients; quadrics need several cells for it.
    assert 6.0 <= found.freedom < 0.1 * found.count
    d, normal = found.distance(mesh.centroids)
    # A third of sigma everywhere is what chi-square can't see of 1681 vertices; the rest is the
    # scatter of fifty coefficients and the height of the chords. How cells lie on a square sheet is
    # chance, and differs between versions of LAPACK.
    assert np.sqrt(np.mean(d**2)) < 0.65 * sigma
    assert np.einsum("nk,nk->n", normal, mesh.facet_normals).min() > np.cos(0.1)


@pytest.mark.parametrize(
    ("name", "mesh"),
    [
        ("prismatic", extrusion(60, 20)),
        ("revolute", vase()),
        ("complex", freeform(40)),
        # Two surfaces describe it for less, unless the border between them is charged for.
        ("complex", freeform(60)),
    ],
)
@pytest.mark.parametrize("seed", [1, 2])
def test_a_face_without_simple_surface_is_one_region(name: str, mesh: Mesh, seed: int) -> None:
    found = partition(noisy(mesh, seed)[0])
    (largest, *rest) = sorted(found.regions, key=lambda region: -region.area)
    assert largest.invariance_class == name
    assert largest.area > 0.97 * (largest.area + sum(region.area for region in rest))


@pytest.mark.parametrize("radius", [3.0, 10.0])
def test_a_rounded_edge_stays_three_faces(radius: float) -> None:
    found = partition(noisy(rounded_edge(radius), 1)[0])
    names = sorted(region.invariance_class for region in found.regions)
    assert names == ["cylindrical", "planar", "planar"]
