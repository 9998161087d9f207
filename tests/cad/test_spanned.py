# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces that the mesher has left out, spanned by their border: the mesh is closed again."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from kernel_parts import write
from mesh_checks import open_sides, volume

from gpswb.cad import mesher, read
from gpswb.cad.density import Density
from gpswb.cad.kernel import Patch
from gpswb.cad.spanned import least_area_triangles

NOTHING = Patch(np.empty((0, 3)), np.empty((0, 2)), np.empty((0, 3), np.int64), ())


@pytest.fixture
def without(monkeypatch: pytest.MonkeyPatch) -> Any:
    """Leaves the faces of one kind out of every tessellation, as BRepMesh leaves some out."""
    # Here even large faces are small enough: they show whether the spanned face is the right one.
    monkeypatch.setattr(mesher, "_NEGLIGIBLE", 1e3)
    load = read._load

    def leave_out(chosen: Any) -> None:
        class Holed:
            def __init__(self, shape: Any) -> None:
                self._shape = shape

            def __getattr__(self, name: str) -> Any:
                return getattr(self._shape, name)

            def tessellate(self, linear: float, angular: float) -> list[Patch]:
                patches = self._shape.tessellate(linear, angular)
                faces = self._shape.faces
                return [NOTHING if chosen(f) else p for p, f in zip(patches, faces, strict=True)]

        monkeypatch.setattr(read, "_load", lambda *words: Holed(load(*words)))

    return leave_out


@pytest.mark.parametrize("density", ["stl", "auto"])
def test_a_face_within_one_border_is_spanned(
    density: str, without: Any, kernel: str, tmp_path: Path
) -> None:
    without(lambda face: face.area == pytest.approx(200))
    solid = read.read_solid(write("drilled", tmp_path), Density.parse(density), kernel=kernel)
    assert solid.facemap is not None
    assert open_sides(solid.mesh) == 0
    assert volume(solid.mesh) == pytest.approx(3200 - 90 * np.pi, rel=2e-3)
    for i, face in enumerate(solid.facemap.faces):
        if face.area == pytest.approx(200):
            mine = solid.facemap.face_of_triangle == i
            assert solid.mesh.areas[mine].sum() == pytest.approx(200)
    assert not any("no triangles" in note for note in solid.notes)


@pytest.mark.parametrize(
    ("what", "chosen"),
    [
        ("a hole in it", lambda face: face.area == pytest.approx(320 - 9 * np.pi)),
        ("a border of two loops", lambda face: face.kind == "Cylinder"),
        ("neighbours that are left out, too", lambda face: face.kind == "Plane"),
    ],
)
def test_any_other_face_stays_out(
    what: str, chosen: Any, without: Any, kernel: str, tmp_path: Path
) -> None:
    without(chosen)
    solid = read.read_solid(write("drilled", tmp_path), Density.parse("stl"), kernel=kernel)
    assert open_sides(solid.mesh) > 0, what
    assert any("no triangles" in note for note in solid.notes)


def test_large_faces_are_not_guessed(
    without: Any, monkeypatch: pytest.MonkeyPatch, kernel: str, tmp_path: Path
) -> None:
    without(lambda face: face.area == pytest.approx(200))
    monkeypatch.setattr(mesher, "_NEGLIGIBLE", 1e-7)
    solid = read.read_solid(write("drilled", tmp_path), Density.parse("stl"), kernel=kernel)
    assert any("2 of 7 faces have no triangles" in note for note in solid.notes)


@pytest.mark.parametrize("height", [1.0, 1e-7])
def test_a_polygon_is_covered_once(height: float) -> None:
    # A concave corner: a fan from the first corner would cover more than the polygon.
    corners = np.array([[0, 0, 0], [2, 1, 0], [4, 0, 0], [4, 3, 0], [0, 3, 0.0]])
    corners[:, 1] *= height
    t = least_area_triangles(np.roll(corners, -2, axis=0))
    c = np.roll(corners, -2, axis=0)[t]
    areas = np.cross(c[:, 1] - c[:, 0], c[:, 2] - c[:, 0])[:, 2] / 2
    assert areas.min() > 0
    assert areas.sum() == pytest.approx(10 * height)
