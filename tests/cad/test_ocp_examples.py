# SPDX-License-Identifier: LGPL-2.1-or-later
"""The example parts: their classes by construction, in native and in B-spline encoding."""

from __future__ import annotations

import subprocess
import sys
from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from mesh_checks import open_sides
from parts import PARTS
from parts.step_units import write_step

from gpswb.cad.density import Density
from gpswb.cad.read import read_solid

ROOT = Path(__file__).parents[2]


@pytest.mark.parametrize("nurbs", [False, True])
@pytest.mark.parametrize("name", list(PARTS))
def test_classes_and_features_by_construction(name: str, nurbs: bool, tmp_path: Path) -> None:
    part = PARTS[name]()
    part = part.nurbs_twin() if nurbs else part
    write_step(part.shape, tmp_path / "part.step")
    solid = read_solid(tmp_path / "part.step", Density.parse("stl"))
    assert solid.facemap is not None
    found = Counter(f.truth.nominal for f in solid.facemap.faces if f.truth)
    assert dict(found) == part.class_counts
    assert sum(found.values()) == len(part.classes)
    assert len(np.unique(solid.facemap.feature_of_face)) == part.features


@pytest.mark.parametrize("density", ["auto", "medium", "stl"])
@pytest.mark.parametrize("name", list(PARTS))
def test_meshes_are_closed_and_cover_their_faces(name: str, density: str, tmp_path: Path) -> None:
    part = PARTS[name]()
    write_step(part.shape, tmp_path / "part.step")
    solid = read_solid(tmp_path / "part.step", Density.parse(density))
    assert open_sides(solid.mesh) == 0
    assert solid.facemap is not None
    owner = solid.facemap.face_of_triangle
    area = np.bincount(owner, solid.mesh.areas, minlength=len(solid.facemap.faces))
    exact = np.array([f.area for f in solid.facemap.faces])
    assert area == pytest.approx(exact, rel=0.05)
    if density == "auto":
        for i, face in enumerate(solid.facemap.faces):
            if face.truth and face.truth.nominal != "planar":
                assert (owner == i).sum() >= 60


@pytest.mark.parametrize(("unit", "name"), [("MM", "mm"), ("M", "m"), ("INCH", "inch")])
def test_the_same_cube_in_three_units(unit: str, name: str, tmp_path: Path) -> None:
    import cadquery as cq

    write_step(cq.Solid.makeBox(254, 254, 254), tmp_path / "cube.step", unit)
    solid = read_solid(tmp_path / "cube.step", Density.parse("stl"))
    assert solid.unit == name
    assert np.ptp(solid.mesh.vertices, axis=0) == pytest.approx([254] * 3)


def test_the_script_builds_what_it_is_asked_for(tmp_path: Path) -> None:
    run = subprocess.run(
        [sys.executable, "examples/build.py", "--out", str(tmp_path / "new"), "sphere_cube"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0
    assert run.stdout.split() == [str(tmp_path / "new" / "sphere_cube.step")]
    wrong = subprocess.run(
        [sys.executable, "examples/build.py", "--out", str(tmp_path), "cube_sphere"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert wrong.returncode == 2
    assert "sphere_cube" in wrong.stderr
