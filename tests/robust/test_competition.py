# SPDX-License-Identifier: LGPL-2.1-or-later
"""Claims on the same facets: the surface with more behind it wins."""

from __future__ import annotations

import numpy as np
import pytest
from analytic_meshes import capped_cylinder, sheet
from known_surfaces import Frame, full_torus, surface_of

from gpswb.core.mesh import FloatArray, IntArray, Mesh
from gpswb.core.robust.competition import CREASED, compete
from gpswb.core.robust.growth import Grown, fit_facets, residual
from gpswb.core.robust.polygons import certain_planes, coplanar_polygons
from gpswb.core.robust.surfaces import Kind
from gpswb.core.robust.topology import FacetGraph

Z_AXIS = Frame(0)
Z_AXIS.rotation, Z_AXIS.origin = np.eye(3), np.zeros(3)


def compared(mesh: Mesh, found: list[Grown]) -> list[Grown]:
    graph, floor = FacetGraph.of(mesh), 1e-7 * mesh.diagonal
    polygon = coplanar_polygons(mesh, graph, floor)
    certain = certain_planes(mesh, graph, polygon, floor)
    return compete(mesh, graph, found, polygon, certain, floor, 10.0 * floor)


def claim(kind: Kind, facets: IntArray) -> Grown:
    return Grown(kind, surface_of(kind, Z_AXIS), facets)


def test_a_piece_of_a_torus_taken_for_a_cylinder_is_swallowed() -> None:
    mesh = full_torus(16)
    outer = np.linalg.norm(mesh.centroids[:, :2], axis=1) > 12.0
    patch = np.flatnonzero(
        outer & (np.abs(mesh.centroids[:, 1]) < 2.0) & (mesh.centroids[:, 0] > 0)
    )
    cylinder = Grown("cylinder", fit_facets(mesh, "cylinder", patch), patch)
    rest = np.setdiff1d(np.arange(len(mesh.triangles)), patch)
    (left,) = compared(mesh, [cylinder, claim("torus", rest)])
    assert left.kind == "torus"
    assert sorted(left.facets.tolist()) == list(range(len(mesh.triangles)))


@pytest.mark.parametrize("rings", [10, 14, 18])
def test_a_flat_ring_of_a_torus_is_taken_whole_unless_it_is_creased(rings: int) -> None:
    mesh = full_torus(rings)
    flat = np.abs(mesh.facet_normals[:, 2]) > 1.0 - 1e-9
    assert flat.sum() == 80
    (left,) = compared(mesh, [claim("torus", np.flatnonzero(~flat))])
    creased = 2.0 * np.pi / rings > CREASED
    assert len(left.facets) == len(mesh.triangles) - 80 * creased


def test_the_caps_of_a_cylinder_stay_planes() -> None:
    # Their outer facets have an edge and, coarse as they are, two vertices on the cylinder.
    mesh = capped_cylinder(nu=12, nv=3, rings=1)
    wall = np.flatnonzero(np.abs(mesh.facet_normals[:, 2]) < 0.5)
    (left,) = compared(mesh, [claim("cylinder", wall)])
    assert sorted(left.facets.tolist()) == wall.tolist()


@pytest.mark.parametrize("seed", range(4))
def test_regions_end_without_common_facets(seed: int) -> None:
    mesh = full_torus(16)
    rng = np.random.default_rng(seed)
    owner = rng.integers(0, 5, len(mesh.triangles))
    found = [claim("torus", np.flatnonzero(owner == k)) for k in range(5)]
    left = compared(mesh, found)
    facets = np.concatenate([g.facets for g in left])
    assert len(np.unique(facets)) == len(facets) == len(mesh.triangles)
    sizes = [len(g.facets) for g in left]
    assert sizes == sorted(sizes, reverse=True)


def test_a_region_grows_no_further_than_the_ceiling() -> None:
    # A barrel: the larger the piece of it, the farther it stands off a cylinder.
    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        angle, z = 2.0 * np.pi * u, 10.0 * v - 5.0
        rho = 5.0 - 1e-4 * z * z
        return np.column_stack([rho * np.cos(angle), rho * np.sin(angle), z])

    mesh = sheet(surface, 24, 40, closed=True)
    waist = np.flatnonzero(np.abs(mesh.centroids[:, 2]) < 2.0)
    found = [Grown("cylinder", fit_facets(mesh, "cylinder", waist), waist)]
    graph = FacetGraph.of(mesh)
    polygon = coplanar_polygons(mesh, graph, 1e-7 * mesh.diagonal)
    certain = np.zeros(int(polygon.max()) + 1, dtype=bool)
    ceiling = 1e-3
    (left,) = compete(mesh, graph, found, polygon, certain, 0.0, ceiling)
    # Without it, six times the stand-off of the waist reaches to both ends.
    (unbounded,) = compete(mesh, graph, found, polygon, certain, 0.0, np.inf)
    assert residual(mesh, left) <= ceiling
    assert len(waist) <= len(left.facets) < len(unbounded.facets)
