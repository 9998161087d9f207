# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pieces without a corner of their own go back to what they were cut out of; small faces stay."""

from __future__ import annotations

import numpy as np
import pytest
from analytic_meshes import TURN, capped_cylinder, sheet, weld

from gpswb.core.mesh import FloatArray, IntArray, Mesh
from gpswb.core.robust.enclosed import SLIVER, take_enclosed
from gpswb.core.robust.topology import FacetGraph

FEW = 12


def taken(mesh: Mesh, label: IntArray) -> list[int]:
    out = take_enclosed(mesh, FacetGraph.of(mesh), label, FEW)
    assert len(out) == len(label)
    return np.unique(out).tolist()


@pytest.mark.parametrize("facets", [1, 2, 5])
def test_facets_cut_out_of_a_smooth_wall_go_back(facets: int) -> None:
    mesh = capped_cylinder(nu=24, nv=6)
    wall = np.flatnonzero(np.abs(mesh.facet_normals[:, 2]) < 0.5)
    label = np.where(np.abs(mesh.facet_normals[:, 2]) < 0.5, 0, 1)
    # A strip round the wall, between its second and its third ring of vertices.
    middle = wall[np.abs(mesh.centroids[wall, 2] - 5.0) < 1.0]
    label[middle[:facets]] = 7
    assert taken(mesh, label) == [0, 1]


def dented(depth: float) -> Mesh:
    """A sheet with a sliver across its middle that stands on edge, as high as ``depth``."""
    flat = sheet(lambda u, v: np.column_stack([10.0 * u, 10.0 * v, 0.05 * (10.0 * u) ** 2]), 10, 10)
    a, b = 5 * 11 + 5, 6 * 11 + 5  # an edge along x in the middle
    points = np.vstack([flat.vertices, 0.5 * (flat.vertices[a] + flat.vertices[b])])
    points[-1, 2] += depth
    facets = []
    for t in flat.triangles.tolist():
        if {a, b} <= set(t):
            (c,) = set(t) - {a, b}
            i = t.index(c)
            p, q = t[(i + 1) % 3], t[(i + 2) % 3]
            # One of both facets beside the edge gets the new vertex, the other keeps the edge.
            if flat.centroids[flat.triangles.tolist().index(t), 1] > 5.0:
                facets += [
                    [c, p, len(points) - 1],
                    [c, len(points) - 1, q],
                    [p, q, len(points) - 1],
                ]
                continue
        facets.append(t)
    return Mesh(points, np.array(facets))


@pytest.mark.parametrize("high", [False, True])
def test_beyond_a_crease_only_slivers_go_back(high: bool) -> None:
    mesh = dented((2.0 if high else 0.5) * SLIVER)
    lone = int(np.argmin(np.abs(mesh.facet_normals[:, 2])))
    label = np.zeros(len(mesh.triangles), dtype=np.int64)
    label[lone] = 1
    assert taken(mesh, label) == ([0, 1] if high else [0])


def test_a_flat_along_a_cylinder_stays() -> None:
    # A turn of 20 facets of 15 degrees; the flat closes the rest, four times as wide as they are.
    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        angle = TURN * u * 300.0 / 360.0
        return np.column_stack([5.0 * np.cos(angle), 5.0 * np.sin(angle), 30.0 * v])

    wall = sheet(surface, 20, 1)
    ends = wall.vertices[[40, 41, 1, 0]]  # the last ruling and the first
    mesh = weld(wall, Mesh(ends, np.array([[0, 2, 1], [0, 3, 2]])))
    label = np.zeros(len(mesh.triangles), dtype=np.int64)
    label[-2:] = 1
    assert taken(mesh, label) == [0, 1]


def test_a_chamfered_corner_of_three_planes_stays() -> None:
    corner = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1], [5, 0, 0], [0, 5, 0], [0, 0, 5]], float)
    triangles = [[0, 1, 2]]
    label = [0]
    for side, (i, j) in enumerate(((0, 1), (1, 2), (2, 0)), start=1):
        far = np.zeros(3)
        far[[i, j]] = 5.0
        corner = np.vstack([corner, far])
        n = len(corner) - 1
        triangles += [[j, i, 3 + i], [j, 3 + i, n], [j, n, 3 + j]]
        label += [side] * 3
    assert taken(Mesh(corner, np.array(triangles)), np.array(label)) == [0, 1, 2, 3]
