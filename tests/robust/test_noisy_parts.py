# SPDX-License-Identifier: LGPL-2.1-or-later
"""Noise of a known sigma, not told: classes hold, parameters are as exact as they can be."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from analytic_meshes import Pose, capped_cylinder, moved
from example_parts import expect_all_right, read, step_file

from gpswb.cad.solid import FaceMap
from gpswb.core.mesh import Mesh
from gpswb.core.noisy.noisy_mesh import NoisyMesh
from gpswb.core.pipeline import partition
from gpswb.validation.validate import validate

SHARE = 1e-3
"""Sigma over the diagonal."""


def noisy(mesh: Mesh, seed: int) -> Mesh:
    random = np.random.default_rng(seed)
    return Mesh(
        mesh.vertices + random.normal(0.0, SHARE * mesh.diagonal, mesh.vertices.shape),
        mesh.triangles,
    )


@pytest.fixture(scope="module")
def simple_part(tmp_path_factory: pytest.TempPathFactory) -> tuple[Mesh, FaceMap]:
    solid, facemap = read(step_file("simple_part", tmp_path_factory.mktemp("step")), "auto")
    return solid.mesh, facemap


@pytest.mark.parametrize("seed", [1, 2])
def test_the_faces_of_a_noisy_part(seed: int, simple_part: tuple[Mesh, FaceMap]) -> None:
    mesh, facemap = simple_part
    judged = validate(partition(noisy(mesh, seed)), facemap)
    # One of its 19 faces may be too small for this noise.
    assert judged.right_faces >= 18
    assert judged.found >= 18
    assert judged.regions <= 20


def test_pose_and_unit_do_not_matter(simple_part: tuple[Mesh, FaceMap]) -> None:
    mesh, facemap = simple_part
    expect_all_right("simple_part", moved(noisy(mesh, 1), Pose(5, 1e-3, 50.0)), facemap)


def test_a_sphere_that_meets_planes(tmp_path: Path) -> None:
    solid, facemap = read(step_file("sphere_cube", tmp_path), "auto")
    expect_all_right("sphere_cube", noisy(solid.mesh, 1), facemap)


def test_the_radius_is_known_to_its_standard_error() -> None:
    radius = 5.0
    mesh = noisy(capped_cylinder(radius=radius), 3)
    (found,) = [r for r in partition(mesh).regions if r.surface == "cylinder"]
    # Radius, axis and noise are nearly independent on a full turn: sigma over the root of n.
    error = SHARE * mesh.diagonal / np.sqrt(found.triangles / 2)
    assert found.intrinsic["radius"] == pytest.approx(radius, abs=4.0 * error)
    assert abs(found.situation["direction"][2]) > np.cos(0.01)


def test_a_facet_as_small_as_the_noise_may_face_anywhere() -> None:
    # An equilateral triangle of altitude h: each corner tilts it by sigma / h.
    corner = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.5, 0.75**0.5, 0.0]])
    mesh = Mesh(corner, np.array([[0, 1, 2]]))
    for sigma, error in ((0.1, 0.2), (0.5, 1.0), (5.0, 0.5 * np.pi)):
        assert NoisyMesh.of(mesh, sigma).normal_error == pytest.approx([error])
