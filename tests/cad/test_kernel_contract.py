# SPDX-License-Identifier: LGPL-2.1-or-later
"""What both kernels promise: run in FreeCAD's Python for its Part, in the other for OCP."""

from __future__ import annotations

from pathlib import Path

import kernel_parts
import numpy as np
import pytest
from kernel_parts import KNOWN
from mesh_checks import aspects, open_sides, volume

from gpswb.cad.density import Density
from gpswb.cad.read import read_solid
from gpswb.cad.solid import Solid

PARTS = list(KNOWN)
DENSITIES = ["stl", "deflection=0.05,20", "turn=16", "auto", "edge=1.5", "coarse"]


def read(path: Path, density: str, kernel: str) -> Solid:
    return read_solid(path, Density.parse(density), kernel)


@pytest.mark.parametrize("nurbs", [False, True])
@pytest.mark.parametrize("density", DENSITIES)
@pytest.mark.parametrize("name", PARTS)
def test_mesh_of_a_solid_is_closed_and_oriented(
    name: str, density: str, nurbs: bool, kernel: str, tmp_path: Path
) -> None:
    solid = read(kernel_parts.write(name, tmp_path, nurbs=nurbs), density, kernel)
    assert open_sides(solid.mesh) == 0
    # Chords lie inside a convex and outside a concave surface: within a few percent of the volume.
    assert volume(solid.mesh) == pytest.approx(KNOWN[name].volume, rel=0.2)
    # The kernel's own mesh of a B-spline cone has a facet of three corners in a line on either side
    # of its seam.
    assert (solid.mesh.areas == 0.0).sum() <= (2 if density == "stl" else 0)


@pytest.mark.parametrize("nurbs", [False, True])
@pytest.mark.parametrize("name", PARTS)
def test_truth_of_the_faces(name: str, nurbs: bool, kernel: str, tmp_path: Path) -> None:
    solid = read(kernel_parts.write(name, tmp_path, nurbs=nurbs), "stl", kernel)
    assert solid.facemap is not None
    faces = solid.facemap.faces
    assert [f.name for f in faces] == [f"Face{i + 1}" for i in range(len(faces))]
    found = sorted((f.truth.nominal, f.area) for f in faces if f.truth)
    for (cls, area), (known_cls, known_area) in zip(found, sorted(KNOWN[name].faces), strict=True):
        assert cls == known_cls
        # FreeCAD integrates a B-spline face with a fixed order: half a percent is what it keeps.
        assert area == pytest.approx(known_area, rel=5e-3 if nurbs else 1e-5)
    for face in faces:
        assert face.truth is not None
        assert face.truth.exact == face.truth.nominal
        assert not face.truth.ambiguous
        assert face.truth.surface == ("BSpline" if nurbs else face.truth.surface)


@pytest.mark.parametrize("density", ["turn=24", "auto"])
@pytest.mark.parametrize("name", PARTS)
def test_vertices_lie_on_their_surface_to_rounding(
    name: str, density: str, kernel: str, tmp_path: Path
) -> None:
    solid = read(kernel_parts.write(name, tmp_path), density, kernel)
    distance = {
        "cylinder": lambda p: np.hypot(p[:, 0], p[:, 1]) - 5,
        "cone": lambda p: (np.hypot(p[:, 0], p[:, 1]) - 6 * (1 - p[:, 2] / 8)) * 0.8,
        "sphere": lambda p: np.linalg.norm(p, axis=1) - 7,
        "torus": lambda p: np.hypot(np.hypot(p[:, 0], p[:, 1]) - 10, p[:, 2]) - 3,
        "drilled": lambda p: np.hypot(p[:, 0] - 9, p[:, 1] - 8) - 3,
    }[name]
    assert solid.facemap is not None
    for i, face in enumerate(solid.facemap.faces):
        assert face.truth is not None
        if face.truth.nominal == "planar":
            continue
        used = np.unique(solid.mesh.triangles[solid.facemap.face_of_triangle == i])
        assert np.abs(distance(solid.mesh.vertices[used])).max() < 1e-9


@pytest.mark.parametrize("name", ["cylinder", "cone", "sphere", "torus"])
def test_volume_converges_with_the_second_order(name: str, kernel: str, tmp_path: Path) -> None:
    path = kernel_parts.write(name, tmp_path)
    lengths = (1.2, 0.2)
    error = [
        abs(volume(read(path, f"edge={h}", kernel).mesh) / KNOWN[name].volume - 1) for h in lengths
    ]
    # A mesh with its vertices on the surface: the error falls with the square of the length. Where
    # sides are halved they lie anywhere between half the length and all of it.
    order = np.log(error[0] / error[1]) / np.log(lengths[0] / lengths[1])
    assert 1.5 < order < 2.5


@pytest.mark.parametrize("name", PARTS)
def test_auto_gives_every_curved_face_triangles_and_inner_vertices(
    name: str, kernel: str, tmp_path: Path
) -> None:
    solid = read(kernel_parts.write(name, tmp_path), "auto", kernel)
    assert solid.facemap is not None
    owner = solid.facemap.face_of_triangle
    for i, face in enumerate(solid.facemap.faces):
        assert face.truth is not None
        if face.truth.nominal == "planar":
            continue
        mine = np.unique(solid.mesh.triangles[owner == i])
        others = np.unique(solid.mesh.triangles[owner != i])
        assert (owner == i).sum() >= 60
        assert len(np.setdiff1d(mine, others)) >= 20


@pytest.mark.parametrize("density", ["turn=24", "auto"])
@pytest.mark.parametrize("name", PARTS)
def test_refined_triangles_are_no_slivers(
    name: str, density: str, kernel: str, tmp_path: Path
) -> None:
    solid = read(kernel_parts.write(name, tmp_path), density, kernel)
    assert np.quantile(aspects(solid.mesh), 0.98) < 8


@pytest.mark.parametrize("count", [2000, 12000])
@pytest.mark.parametrize("what", ["vertices", "triangles"])
def test_counts_are_met(what: str, count: int, kernel: str, tmp_path: Path) -> None:
    solid = read(kernel_parts.write("drilled", tmp_path), f"{what}={count}", kernel)
    assert len(getattr(solid.mesh, what)) == pytest.approx(count, rel=0.15)


@pytest.mark.parametrize("suffix", [".step", ".brep"])
def test_two_bodies_that_touch_stay_two(suffix: str, kernel: str, tmp_path: Path) -> None:
    solid = read(kernel_parts.write("two", tmp_path, suffix), "auto", kernel)
    assert solid.facemap is not None
    assert [f.solid for f in solid.facemap.faces] == [0] * 6 + [1] * 6
    assert open_sides(solid.mesh) == 0
    assert volume(solid.mesh) == pytest.approx(2000)


def test_progress_only_grows_within_a_stage(kernel: str, tmp_path: Path) -> None:
    seen: list[tuple[str, float]] = []
    path = kernel_parts.write("drilled", tmp_path)
    read_solid(
        path, Density.parse("auto"), kernel, lambda stage, share: seen.append((stage, share))
    )
    assert {stage for stage, _ in seen} >= {"read", "tessellate"}
    for stage in ("read", "tessellate"):
        shares = [share for s, share in seen if s == stage]
        assert shares == sorted(shares)
        assert 0 <= min(shares) <= max(shares) <= 1
