# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of a mesh: connected, halved along the surface, sampled evenly; chains of coarse faces."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest
from analytic_meshes import box, sheet

from gpswb.core.mesh import FloatArray, Mesh
from gpswb.core.pipeline import partition
from gpswb.core.robust.parts import connected_parts, halves, spread_over
from gpswb.core.robust.topology import FacetGraph


def strip_cylinder(n: int) -> Mesh:
    """A quarter of a cylinder in n strips of two long triangles each."""
    return sheet(
        lambda u, v: np.column_stack(
            [5 * np.cos(u * np.pi / 2), 5 * np.sin(u * np.pi / 2), 100.0 * v]
        ),
        n,
        1,
    )


def stadium(n: int, radius: float = 5.0, length: float = 30.0, height: float = 20.0) -> Mesh:
    """A slot's wall: two half cylinders of n strips and two planes of two triangles, closed."""
    turn = np.linspace(-np.pi / 2, np.pi / 2, n + 1)
    right = np.column_stack([length / 2 + radius * np.cos(turn), radius * np.sin(turn)])
    ring: FloatArray = np.concatenate([right, -right])
    k = len(ring)
    vertices = np.concatenate([np.column_stack([ring, np.full(k, z)]) for z in (0.0, height)])
    a = np.arange(k)
    b = (a + 1) % k
    triangles = np.concatenate([np.column_stack([a, b, a + k]), np.column_stack([b, b + k, a + k])])
    return Mesh(vertices, triangles)


def test_groups_fall_apart_where_they_do_not_touch() -> None:
    mesh = box(n=2)
    graph = FacetGraph.of(mesh)
    group = np.where(np.abs(mesh.facet_normals[:, 2]) > 0.5, 0, -1)  # top and bottom
    part = connected_parts(group, graph.pairs)
    assert set(part[group < 0]) == {-1}
    assert Counter(part[group >= 0].tolist()) == {0: 8, 1: 8}


def test_halves_of_strips_are_connected_and_equal() -> None:
    mesh = strip_cylinder(20)
    graph = FacetGraph.of(mesh)
    half = halves(np.zeros(len(mesh.triangles), dtype=np.int64), graph.pairs)
    assert np.bincount(half).tolist() == [20, 20]
    assert connected_parts(half, graph.pairs).max() == 1


def test_facets_are_spread_evenly_over_each_part() -> None:
    part = np.array([1] * 10 + [-1] * 3 + [0] * 4)
    chosen, size = spread_over(part, 5)
    assert size.tolist() == [4, 10]
    assert chosen.tolist() == [[13, 14, 15, 16, -1], [0, 2, 4, 6, 8]]


@pytest.mark.parametrize("n", [12, 32, 64])
def test_a_slot_of_planes_and_half_cylinders_is_no_prism(n: int) -> None:
    """Planes of two triangles, tangent to strips: an export leaves no more of them."""
    found = partition(stadium(n))
    kinds = Counter((r.surface, r.triangles) for r in found.regions)
    assert kinds == {("plane", 2): 2, ("cylinder", 2 * n): 2}
    radii = [r.intrinsic["radius"] for r in found.regions if r.surface == "cylinder"]
    assert radii == pytest.approx([5.0, 5.0])
