# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curved faces of a few facets that turn by more than a crease, and polyhedra that look like it."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from scipy.spatial import ConvexHull
from scipy.spatial.transform import Rotation

from gpswb.core.mesh import FloatArray, Mesh
from gpswb.core.pipeline import partition

GOLDEN = (1.0 + np.sqrt(5.0)) / 2.0


def hull(points: FloatArray) -> Mesh:
    """The convex polyhedron of (n, 3) corners, turned out of the axes."""
    turned = Rotation.from_euler("xyz", [0.3, 0.5, 0.7]).apply(points)
    found = ConvexHull(turned)
    triangles = found.simplices.astype(np.int64)
    corners = turned[triangles]
    inward = np.einsum(
        "ij,ij->i",
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]),
        corners.mean(axis=1) - turned.mean(axis=0),
    )
    triangles[inward < 0.0] = triangles[inward < 0.0][:, ::-1]
    return Mesh(turned, triangles)


def rings(sides: int, shift: float, height: float) -> FloatArray:
    """Two rings of so many corners about z, of radius 10, the upper one turned by a share of a
    step."""
    angle = 2.0 * np.pi * np.arange(sides) / sides
    upper = angle + 2.0 * np.pi * shift / sides
    return np.concatenate(
        [
            np.column_stack([10.0 * np.cos(a), 10.0 * np.sin(a), np.full(sides, z)])
            for a, z in ((angle, 0.0), (upper, height))
        ]
    )


@pytest.mark.parametrize(("sides", "height"), [(6, 3.0), (8, 1.5)])
def test_staggered_rings_are_a_cylinder(sides: int, height: float) -> None:
    mesh = hull(rings(sides, 0.5, height))
    assert np.sort(mesh.turning)[2 * sides] > np.deg2rad(40.0)
    result = partition(mesh)
    count = {r.invariance_class: r.triangles for r in result.regions}
    assert count == {"planar": sides - 2, "cylindrical": 2 * sides}
    (round_,) = (r for r in result.regions if r.invariance_class == "cylindrical")
    assert round_.intrinsic["radius"] == pytest.approx(10.0, abs=1e-9)


@pytest.mark.parametrize("sides", [6, 8])
def test_rings_above_each_other_are_a_prism(sides: int) -> None:
    result = partition(hull(rings(sides, 0.0, 3.0)))
    assert [r.invariance_class for r in result.regions] == ["planar"] * (sides + 2)


def test_a_die_of_twenty_faces_stays_one() -> None:
    # Each belt of ten triangles lies on a cylinder, all of them on a sphere.
    one = np.array(list(product([0.0], [-1.0, 1.0], [-GOLDEN, GOLDEN])))
    mesh = hull(np.concatenate([np.roll(one, k, axis=1) for k in range(3)]))
    # Said to be exact: twelve vertices are too few to tell.
    result = partition(mesh, noise=0.0)
    assert [r.invariance_class for r in result.regions] == ["planar"] * 20


def test_a_pyramid_stays_one() -> None:
    apex = np.array([[0.0, 0.0, 12.0]])
    result = partition(hull(np.concatenate([rings(7, 0.0, 3.0)[:7], apex])))
    assert [r.invariance_class for r in result.regions] == ["planar"] * 8
