# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clouds become meshes: topology, area and volume of known surfaces; bad clouds get one line."""

import numpy as np
import pytest
from clouds import on_box, on_sphere
from made_parts import partition_of

from gpswb.core.mesh import Mesh
from gpswb.errors import InputError
from gpswb.scan.bridges import without_bridges
from gpswb.scan.cloud import mesh_cloud
from gpswb.scan.point_regions import region_of_points
from gpswb.scan.thinning import thin


def edges_of(mesh: Mesh) -> tuple[np.ndarray, np.ndarray]:
    """Edges, and the number of facets on each."""
    ends = np.sort(mesh.triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    edges, facets = np.unique(ends, axis=0, return_counts=True)
    return edges, facets


def euler(mesh: Mesh) -> int:
    edges, facets = edges_of(mesh)
    assert (facets == 2).all()  # closed, and no fork
    return len(np.unique(mesh.triangles)) - len(edges) + len(mesh.triangles)


def volume(mesh: Mesh) -> float:
    a, b, c = np.moveaxis(mesh.corners, 1, 0)
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


def test_sphere_is_closed_and_looks_outward() -> None:
    made = mesh_cloud(on_sphere(2000))
    assert euler(made.mesh) == 2
    assert made.notes == ()
    # An inscribed polyhedron: a little less than the ball, by about 2π/√3 / n of its volume · 1.5.
    assert 0.98 < volume(made.mesh) / (4 / 3 * np.pi * 20**3) < 1.0


def test_box_is_covered_over_its_sharp_edges() -> None:
    mesh = mesh_cloud(on_box(4000)).mesh
    _, facets = edges_of(mesh)
    assert facets.max() == 2
    assert (facets == 1).mean() < 0.002  # at an edge now and then a triangle doesn't fit
    # Edges are cut off by about half a spacing.
    assert 0.97 < volume(mesh) / 6000 < 1.0


def test_a_flat_grid_becomes_its_squares() -> None:
    g = np.stack(np.meshgrid(np.arange(30.0), np.arange(20.0), indexing="ij"), -1).reshape(-1, 2)
    made = mesh_cloud(np.column_stack([g, np.zeros(len(g))]))
    assert made.mesh.areas.sum() == pytest.approx(29 * 19)
    assert len(made.mesh.triangles) == 2 * 29 * 19
    assert np.abs(made.mesh.facet_normals[:, 2]).min() == pytest.approx(1.0)


def test_a_gap_stays_a_hole() -> None:
    x = on_sphere(3000)
    made = mesh_cloud(x[x[:, 2] < 15.0])
    edges, facets = edges_of(made.mesh)
    border = made.mesh.vertices[np.unique(edges[facets == 1])]
    assert len(border) > 20
    # The border runs along the gap's rim: nearer to it than two spacings of 1.3 mm.
    assert border[:, 2].min() > 15.0 - 2.6


def test_outliers_are_set_aside_and_counted() -> None:
    strays = np.random.default_rng(5).uniform(-60, 60, (40, 3))
    strays = strays[np.abs(np.linalg.norm(strays, axis=1) - 20) > 8]
    made = mesh_cloud(np.r_[on_sphere(3000), strays])
    assert (made.vertex_of_point[:3000] >= 0).all()
    assert (made.vertex_of_point[3000:] < 0).all()
    assert made.notes[0].startswith(f"{len(strays)} points set aside as outliers")
    assert euler(made.mesh) == 2


def test_every_point_finds_its_vertex_when_the_cloud_is_thinned() -> None:
    x = on_sphere(20_000)
    made = mesh_cloud(np.r_[x, x[:50]], most=2000)
    assert len(made.mesh.vertices) <= 2000
    assert made.notes[0] == "50 of 20050 points repeat others"
    assert "thinned from 20000 to" in made.notes[1]
    off = np.linalg.norm(made.mesh.vertices[made.vertex_of_point] - np.r_[x, x[:50]], axis=1)
    edge = float(made.notes[1].split("cube of ")[1].split(" mm")[0])
    assert off.max() <= np.sqrt(3) * edge
    assert (made.vertex_of_point[-50:] == made.vertex_of_point[:50]).all()
    # Vertices are measured points, not averages of them.
    assert np.linalg.norm(made.mesh.vertices, axis=1) == pytest.approx(20.0)


def test_thinning_keeps_near_the_number_asked() -> None:
    x = on_box(30_000)
    kept, stands, edge = thin(x, 5000)
    assert 0.9 * 5000 < len(kept) <= 5000
    assert (np.diff(kept) > 0).all()
    cube = np.floor((x - x.min(axis=0)) / edge)
    assert (cube[kept[stands]] == cube).all()  # a point stands for those of its own cube


def test_the_mesh_does_not_depend_on_the_order_of_the_points() -> None:
    x = on_sphere(500)
    turn = np.random.default_rng(3).permutation(len(x))
    one, two = mesh_cloud(x), mesh_cloud(x[turn])
    assert (one.mesh.vertices == two.mesh.vertices).all()
    assert (one.vertex_of_point[turn] == two.vertex_of_point).all()


@pytest.mark.parametrize(
    ("points", "text"),
    [
        (np.zeros((0, 3)), "0 different points among 0"),
        (np.eye(3)[:2], "2 different points among 2"),
        (np.zeros((1_000_000, 3)), "1 different points among 1000000"),
        (np.outer(np.arange(50.0), [1, 2, 3]), "no surface"),
    ],
    ids=["none", "two", "a million equal", "a line"],
)
def test_bad_clouds_give_one_line(points: np.ndarray, text: str) -> None:
    with pytest.raises(InputError, match=text):
        mesh_cloud(points)


def test_facets_that_bridge_edges_get_no_region_and_points_keep_theirs() -> None:
    mesh = mesh_cloud(on_box(1500)).mesh
    # Facets on a side of the box are its region; each of the others has one of its own.
    low, high = np.zeros(3), np.array([30, 20, 10])
    corner = mesh.corners
    side = np.full(len(corner), -1)
    for axis in range(3):
        for number, level in enumerate((low, high)):
            on = (np.abs(corner[:, :, axis] - level[axis]) < 1e-12).all(axis=1)
            side[on] = 2 * axis + number
    loose = np.flatnonzero(side < 0)
    assert len(loose) > 100
    region = side.copy()
    region[loose] = 6 + np.arange(len(loose))
    classes = ["planar"] * 6 + ["complex"] * len(loose)
    before = partition_of(mesh, region, classes)
    after = without_bridges(before)
    points = np.arange(len(mesh.vertices))
    # At a corner of the box a point may have no other facets than bridges.
    sure = np.isin(points, mesh.triangles[side >= 0])
    assert (~sure).sum() < 10
    assert 6 <= len(after.regions) <= 6 + (~sure).sum()
    assert sum(r.triangles for r in after.regions) == len(mesh.triangles)
    found = region_of_points(after, points)
    # Every other point is on the side of its region, those beside an edge included.
    on = found[sure]
    assert (on < 6).all()
    level = np.array([low, high])[on % 2, on // 2]
    assert mesh.vertices[points[sure], on // 2] == pytest.approx(level)
    assert (on == region_of_points(before, points)[sure]).all()
