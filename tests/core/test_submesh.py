# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
from analytic_meshes import box, capped_cylinder

from gpswb.core.mesh import Mesh
from gpswb.core.normals import wedge_normals
from gpswb.core.refine import refine_regions
from gpswb.core.region_samples import confined_normals
from gpswb.core.sharp_edges import feature_edges
from gpswb.core.submesh import submesh
from gpswb.core.tolerances import Tolerances
from gpswb.core.wedges import find_wedges


def test_creases_stay_at_their_edges() -> None:
    mesh = capped_cylinder(nu=24, nv=6)
    crease = feature_edges(mesh)
    kept = np.flatnonzero(mesh.centroids[:, 0] > 1.0)
    part, inner = submesh(mesh, kept, crease)
    assert np.array_equal(part.corners, mesh.corners[kept])

    def middles(m: Mesh, chosen: np.ndarray) -> set[tuple[float, ...]]:
        middle = m.vertices[m.pair_edges[chosen]].mean(axis=1)
        return {tuple(row) for row in middle.round(9).tolist()}

    both = np.isin(mesh.facet_pairs, kept).all(axis=1)
    assert middles(part, inner) == middles(mesh, crease & both)
    assert middles(part, ~inner) == middles(mesh, ~crease & both)
    assert inner.any()
    assert not inner.all()


def test_an_edge_that_loses_its_third_facet_is_a_crease() -> None:
    vertices = np.array([[0.0, 0, 0], [1, 0, 0], [0.5, 1, 0], [0.5, -1, 0], [0.5, 0, 1]])
    mesh = Mesh(vertices, np.array([[0, 1, 2], [1, 0, 3], [0, 1, 4]]))
    assert len(mesh.facet_pairs) == 0
    part, crease = submesh(mesh, np.array([0, 1]), np.zeros(0, dtype=bool))
    assert part.facet_pairs.tolist() == [[0, 1]]
    assert crease.tolist() == [True]


def test_normals_of_a_few_facets_are_those_of_the_whole() -> None:
    mesh = capped_cylinder(nu=36, nv=8)
    crease = feature_edges(mesh)
    wall = np.abs(mesh.facet_normals[:, 2]) < 0.5
    region = np.where(wall & (mesh.centroids[:, 0] > 2.0), 0, -1)
    assert 0 < (region == 0).sum() < 0.5 * len(region)
    found = confined_normals(mesh, region, crease).at(np.flatnonzero(region == 0))
    border = crease | (region[mesh.facet_pairs[:, 0]] != region[mesh.facet_pairs[:, 1]])
    wedges = find_wedges(mesh, border)
    whole = wedge_normals(mesh, wedges)[wedges.of_corner][region == 0]
    assert np.abs(found - whole).max() < 1e-12


def test_facets_left_out_of_merging_stay_out_and_change_nothing() -> None:
    mesh = box((30.0, 20.0, 10.0), 4)
    crease = feature_edges(mesh)
    top = mesh.facet_normals[:, 2] > 0.5
    # The top in strips, nothing else: they lie in one plane.
    strips = np.where(top, (mesh.centroids[:, 0] // 8.0).astype(np.int64) + 2, -1)
    refined = refine_regions(mesh, strips, crease, 0.0, Tolerances())
    assert (refined[~top] == -1).all()
    assert len(np.unique(refined[top])) == 1
