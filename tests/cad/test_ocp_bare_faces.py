# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces that have no surface, only a triangulation: asking OCCT for their surface crashes it."""

from __future__ import annotations

from pathlib import Path

import pytest
from OCP.BRep import BRep_Builder
from OCP.BRepTools import BRepTools
from OCP.gp import gp_Pnt
from OCP.Poly import Poly_Triangle, Poly_Triangulation
from OCP.TopoDS import TopoDS_Compound, TopoDS_Face

from gpswb.cad.density import Density
from gpswb.cad.read import read_solid


def write_square(path: Path, with_box: bool) -> None:
    mesh = Poly_Triangulation(4, 2, False)
    for i, (x, y) in enumerate([(0, 0), (2, 0), (2, 2), (0, 2)], 1):
        mesh.SetNode(i, gp_Pnt(x, y, 50))
    mesh.SetTriangle(1, Poly_Triangle(1, 2, 3))
    mesh.SetTriangle(2, Poly_Triangle(1, 3, 4))
    builder, face, whole = BRep_Builder(), TopoDS_Face(), TopoDS_Compound()
    builder.MakeFace(face, mesh)
    builder.MakeCompound(whole)
    if with_box:
        import cadquery as cq

        builder.Add(whole, cq.Solid.makeBox(10, 10, 10).wrapped)
    builder.Add(whole, face)
    BRepTools.Write_s(whole, str(path))


@pytest.mark.parametrize("density", ["stl", "auto", "medium", "triangles=1000"])
@pytest.mark.parametrize("with_box", [False, True])
def test_triangulation_is_kept(density: str, with_box: bool, tmp_path: Path) -> None:
    write_square(tmp_path / "part.brep", with_box)
    solid = read_solid(tmp_path / "part.brep", Density.parse(density))
    assert solid.facemap is not None
    bare = solid.facemap.faces[-1]
    assert bare.truth is None
    assert bare.area == pytest.approx(4)
    assert (solid.facemap.face_of_triangle == len(solid.facemap.faces) - 1).sum() == 2
    assert any("1 faces have no surface" in note for note in solid.notes)
