# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
from analytic_meshes import box, capped_cylinder, sphere, torus

from gpswb.core.mesh import Mesh
from gpswb.core.partition import Partition
from gpswb.core.pipeline import partition
from gpswb.core.shape_types import PLANE, SHARP_EDGE


def paper(mesh: Mesh) -> Partition:
    return partition(mesh, mode="paper", noise=0.0)


def area_by_class(p: Partition) -> dict[str, float]:
    area: dict[str, float] = {}
    for region in p.regions:
        area[region.invariance_class] = area.get(region.invariance_class, 0.0) + region.area
    return area


def test_a_cube_has_six_planes_and_one_net_of_sharp_edges() -> None:
    found = paper(box((10.0, 10.0, 10.0), 8))
    assert found.initial_region_count == 6
    assert found.sharp_edge_regions == 1
    assert len(found.regions) == 6
    assert {r.invariance_class for r in found.regions} == {"planar"}
    # Facets along the edges have sharp vertices; each still joins its own side.
    assert [r.triangles for r in found.regions] == [2 * 8 * 8] * 6
    assert all(r.area == np.float64(r.area) and abs(r.area - 100.0) < 1e-9 for r in found.regions)


def test_vertices_carry_the_labels() -> None:
    mesh = box((10.0, 10.0, 10.0), 4)
    found = paper(mesh)
    on_side = np.isclose(mesh.vertices, 0.0) | np.isclose(mesh.vertices, 10.0)
    edge = on_side.sum(axis=1) >= 2
    assert (found.vertex_shape_type[edge] == SHARP_EDGE).all()
    assert (found.vertex_shape_type[~edge] == PLANE).all()


def test_an_export_without_inner_vertices_defeats_vertex_labels() -> None:
    # Every vertex of such a mesh lies on an edge: nothing is left to grow a region from.
    found = paper(capped_cylinder(nu=24, nv=1, rings=1))
    assert found.initial_region_count <= 2
    assert set(area_by_class(found)) != {"planar", "cylindrical"}


def test_the_result_depends_on_the_unit() -> None:
    # p_c = 1e-5 per mm calls a sphere of 150 m radius plane; the same sphere in metres is none.
    large = sphere(radius=150_000.0, level=8)
    assert (paper(large).vertex_shape_type == PLANE).mean() > 0.95
    in_metres = paper(Mesh(large.vertices / 1000.0, large.triangles))
    assert not (in_metres.vertex_shape_type == PLANE).any()


def test_a_torus_falls_into_bands_by_shape_index() -> None:
    # Outside dome or ridge, inside saddle: Table 5 cuts one face into bands round the axis.
    found = paper(torus(32))
    assert found.initial_region_count >= 3
    types = set(found.vertex_shape_type.tolist()) - {SHARP_EDGE}
    assert {1, 2, 3} <= types


def test_likelihoods_decide_and_are_reported() -> None:
    found = paper(sphere(radius=7.0, level=10))
    assert len(found.regions) == 1
    values = found.regions[0].log_likelihood
    ranked = {c: v for c, v in values.items() if c != "helical"}
    assert max(ranked, key=lambda c: ranked[c]) == found.regions[0].invariance_class == "spherical"
    assert len(values) == 7
