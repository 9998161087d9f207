# SPDX-License-Identifier: LGPL-2.1-or-later
"""A coarse torus is a stack of cones; some stacks of cones are no torus."""

from __future__ import annotations

import numpy as np
import pytest
from analytic_meshes import TURN, sheet
from known_surfaces import Frame

from gpswb.core.mesh import FloatArray, Mesh
from gpswb.core.robust.growth import Grown, fit_facets
from gpswb.core.robust.stacked_bands import stacked_bands
from gpswb.core.robust.topology import FacetGraph


def turned(profile: FloatArray, frame: Frame) -> tuple[Mesh, list[Grown]]:
    """The surface of revolution of (k, 2) places (radius, height), and the cone of each band."""

    def point(u: FloatArray, v: FloatArray) -> FloatArray:
        rho, z = profile[np.rint(v * (len(profile) - 1)).astype(int)].T
        return frame.point(np.column_stack([rho * np.cos(TURN * u), rho * np.sin(TURN * u), z]))

    mesh = sheet(point, 24, len(profile) - 1)
    along = (mesh.centroids - frame.origin) @ frame.axis
    bands = []
    for low, high in zip(profile[:-1, 1], profile[1:, 1], strict=True):
        facets = np.flatnonzero((along - low) * (along - high) < 0.0)
        assert len(facets) == 48
        bands.append(Grown("cone", fit_facets(mesh, "cone", facets), facets))
    return mesh, bands


def arc(angles: FloatArray, major: float, minor: float) -> FloatArray:
    return np.column_stack([major + minor * np.cos(angles), minor * np.sin(angles)])


def found(profile: FloatArray, seed: int = 3) -> tuple[Mesh, list[Grown]]:
    mesh, bands = turned(profile, Frame(seed))
    graph, everything = FacetGraph.of(mesh), np.ones(len(mesh.triangles), dtype=bool)
    return mesh, stacked_bands(mesh, graph, bands, everything, 1e-7 * mesh.diagonal)


@pytest.mark.parametrize(
    ("angles", "major", "minor"),
    [
        ([0.1, 0.45, 0.7, 1.2, 1.5], 10.0, 3.0),  # five rings at any steps
        ([0.2, 0.5, 0.8, 1.1], 10.0, 3.0),  # four at equal steps
        ([0.9, 1.0, 1.08, 1.2, 1.31], -8.0, 50.0),  # a dome whose tube's centre is beyond the axis
    ],
)
def test_rings_of_a_torus_are_one_torus(angles: list[float], major: float, minor: float) -> None:
    mesh, (torus,) = found(arc(np.array(angles), major, minor))
    assert torus.kind == "torus"
    assert sorted(torus.facets.tolist()) == list(range(len(mesh.triangles)))
    np.testing.assert_allclose(torus.surface[6:8], [major, minor], rtol=1e-6)


def test_rings_of_a_sphere_are_one_sphere() -> None:
    _, (sphere,) = found(arc(np.array([0.1, 0.4, 0.8, 1.0, 1.3]), 0.0, 7.0))
    assert sphere.kind == "sphere"
    assert sphere.surface[6] == pytest.approx(7.0, rel=1e-6)


@pytest.mark.parametrize(
    "profile",
    [
        [[8.0, 0.0], [10.0, 1.0], [10.5, 6.0], [9.0, 7.5]],  # four rings on no circle
        [[9.0, 0.0], [10.0, 1.0], [10.0, 6.0], [9.0, 7.0]],  # two chamfers: on one by symmetry
        [[9.0, 0.0], [10.0, 2.0], [10.5, 5.0]],  # any three are
        [[9.0, 0.0], [9.5, 1.0], [10.0, 2.0], [10.5, 3.0], [11.0, 4.0]],  # one cone
    ],
)
def test_other_stacks_stay_what_they_are(profile: list[list[float]]) -> None:
    assert found(np.array(profile))[1] == []
