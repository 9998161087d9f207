# SPDX-License-Identifier: LGPL-2.1-or-later
"""What must not matter to the class of a face: pose, unit, order and orientation of the mesh."""

from __future__ import annotations

from dataclasses import replace

import pytest
from analytic_meshes import Pose, flipped, moved, relabelled
from example_parts import expect_all_right, read, step_file

from gpswb.cad.solid import FaceMap
from gpswb.core.mesh import Mesh

NAMES = ["simple_part", "revolution_part", "bracket"]
UNITS = {"metre": 1e-3, "inch": 1.0 / 25.4, "micrometre": 1e3}


@pytest.fixture(scope="module")
def meshes(tmp_path_factory: pytest.TempPathFactory) -> dict[str, tuple[Mesh, FaceMap]]:
    folder = tmp_path_factory.mktemp("examples")
    read_parts = [read(step_file(name, folder), "coarse") for name in NAMES]
    return {n: (s.mesh, facemap) for n, (s, facemap) in zip(NAMES, read_parts, strict=True)}


@pytest.mark.parametrize(
    ("name", "unit"),
    [*(("simple_part", u) for u in UNITS), ("revolution_part", "inch"), ("bracket", "metre")],
)
def test_pose_and_unit(name: str, unit: str, meshes: dict[str, tuple[Mesh, FaceMap]]) -> None:
    mesh, facemap = meshes[name]
    # Turned at random, and as far from the origin as half a part, in the unit.
    pose = Pose(len(unit), UNITS[unit], 50.0)
    expect_all_right(name, moved(mesh, pose), facemap)


@pytest.mark.parametrize(("name", "seed"), [("simple_part", 1), ("simple_part", 2), ("bracket", 3)])
def test_order_of_vertices_and_triangles(
    name: str, seed: int, meshes: dict[str, tuple[Mesh, FaceMap]]
) -> None:
    mesh, facemap = meshes[name]
    other, order = relabelled(mesh, seed)
    ordered = replace(facemap, face_of_triangle=facemap.face_of_triangle[order])
    expect_all_right(name, other, ordered)


@pytest.mark.parametrize("name", ["simple_part", "revolution_part"])
def test_orientation(name: str, meshes: dict[str, tuple[Mesh, FaceMap]]) -> None:
    mesh, facemap = meshes[name]
    expect_all_right(name, flipped(mesh), facemap)
