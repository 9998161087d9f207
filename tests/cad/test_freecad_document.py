# SPDX-License-Identifier: LGPL-2.1-or-later
"""A document that FreeCAD itself has saved, and the densities of its own exports."""

from __future__ import annotations

import hashlib
from pathlib import Path

import FreeCAD
import Mesh
import Part
import pytest

from gpswb.cad.density import Density
from gpswb.cad.read import read_solid


def test_saved_document(tmp_path: Path) -> None:
    document = FreeCAD.newDocument("saved")
    try:
        box = document.addObject("Part::Box", "Box")
        hole = document.addObject("Part::Cylinder", "Hole")
        hole.Placement.Base = FreeCAD.Vector(5, 5, 0)
        cut = document.addObject("Part::Cut", "Cut")
        cut.Base, cut.Tool = box, hole
        part = document.addObject("App::Part", "Part")
        part.addObject(cut)
        part.Placement.Base = FreeCAD.Vector(0, 0, 30)
        document.recompute()
        path = tmp_path / "saved.FCStd"
        document.saveAs(str(path))
    finally:
        FreeCAD.closeDocument("saved")
    solid = read_solid(path, Density.parse("auto"), "freecad")
    assert solid.sha256 == hashlib.sha256(path.read_bytes()).hexdigest()
    assert solid.facemap is not None
    classes = [f.truth.nominal for f in solid.facemap.faces if f.truth]
    assert sorted(classes) == ["cylindrical"] + ["planar"] * 6
    assert solid.mesh.vertices[:, 2].min() == pytest.approx(30)


@pytest.mark.parametrize("radius", [2.0, 15.0, 80.0])
def test_stl_density_is_what_freecad_exports(radius: float, tmp_path: Path) -> None:
    shape = Part.makeCylinder(radius, 10)
    shape.exportStep(str(tmp_path / "part.step"))
    document = FreeCAD.newDocument("export")
    try:
        item = document.addObject("Part::Feature", "Item")
        item.Shape = shape
        Mesh.export([item], str(tmp_path / "part.stl"))
    finally:
        FreeCAD.closeDocument("export")
    exported = Mesh.Mesh(str(tmp_path / "part.stl"))
    solid = read_solid(tmp_path / "part.step", Density.parse("stl"), "freecad")
    assert len(solid.mesh.triangles) == exported.CountFacets
    assert len(solid.mesh.vertices) == exported.CountPoints
