# SPDX-License-Identifier: LGPL-2.1-or-later
"""Repair of meshes: what was spoilt comes back, and each thing done is told."""

import numpy as np
import pytest

from gpswb.core.mesh import Mesh
from gpswb.errors import InputError
from gpswb.scan.repair import repair


def cube(shift: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
    """A unit cube, two facets a side, looking outward."""
    points = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return points + shift, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


def volume(mesh: Mesh) -> float:
    a, b, c = np.moveaxis(mesh.corners, 1, 0)
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


def test_a_good_mesh_stays_and_nothing_is_told() -> None:
    mesh, notes = repair(Mesh(*cube()))
    assert (len(mesh.vertices), len(mesh.triangles), notes) == (8, 12, ())
    assert volume(mesh) == pytest.approx(1.0)


@pytest.mark.parametrize("turned", [[3], [0, 1, 5, 8, 11], list(range(12))], ids=str)
def test_orientation_comes_back(turned: list[int]) -> None:
    points, triangles = cube()
    triangles[turned] = triangles[turned][:, ::-1]
    mesh, notes = repair(Mesh(points, triangles))
    assert volume(mesh) == pytest.approx(1.0)
    assert notes == (f"{len(turned)} of 12 triangles turned round",)


def test_soup_is_welded_and_spoilt_triangles_go() -> None:
    points, triangles = cube()
    soup = points[triangles].reshape(-1, 3)
    facets = np.arange(36).reshape(-1, 3)
    # A facet twice (once the other way round), one with a double corner, one on a line.
    line = np.array([[0, 0, 0], [0.5, 0, 0], [1, 0, 0]])
    facets = np.r_[facets, facets[:1, ::-1], [[0, 0, 1]], [[36, 37, 38]]]
    mesh, notes = repair(Mesh(np.r_[soup, line], facets))
    assert (len(mesh.vertices), len(mesh.triangles)) == (8, 12)
    assert volume(mesh) == pytest.approx(1.0)
    assert notes == ("2 degenerate triangles dropped", "1 repeated triangles dropped")


def test_components_holes_and_forks_are_told() -> None:
    (a, t), (b, _) = cube(), cube(5.0)
    both = np.r_[t[1:], t + 8]
    _, notes = repair(Mesh(np.r_[a, b], both))
    assert notes == ("the mesh is open: 3 border edges", "2 components, partitioned together")
    # A fin on an edge: three facets meet there.
    fin = np.r_[t, [[t[0, 0], t[0, 1], 8]]]
    _, notes = repair(Mesh(np.r_[a, [[-1.0, -1.0, 0.5]]], fin))
    assert "1 edges of three or more triangles are borders" in notes


def test_each_component_looks_outward() -> None:
    (a, t), (b, u) = cube(), cube(5.0)
    mesh, _ = repair(Mesh(np.r_[a, b], np.r_[t, u[:, ::-1] + 8]))
    assert volume(mesh) == pytest.approx(2.0)


def test_a_strip_with_a_twist_is_survived_and_told() -> None:
    # A Möbius strip of ten quadrilaterals can't be oriented.
    n = 10
    angle = 2 * np.pi * np.arange(n) / n
    across = np.column_stack(
        [np.cos(angle / 2) * np.cos(angle), np.cos(angle / 2) * np.sin(angle), np.sin(angle / 2)]
    )
    ring = 3 * np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])
    points = np.r_[ring - across, ring + across]
    facets = []
    for i in range(n):
        a, b, c, d = i, (i + 1) % n, (i + 1) % n + n, i + n
        if i == n - 1:
            b, c = c, b
        facets += [(a, b, c), (a, c, d)]
    mesh, notes = repair(Mesh(points, np.array(facets)))
    assert len(mesh.triangles) == 2 * n
    assert any("run against each other" in note for note in notes)


def test_nothing_left_is_an_error() -> None:
    with pytest.raises(InputError, match="none of 1 triangles has an area"):
        repair(Mesh(np.array([[0.0, 0, 0], [1, 0, 0], [2, 0, 0]]), np.array([[0, 1, 2]])))
