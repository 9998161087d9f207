# SPDX-License-Identifier: LGPL-2.1-or-later
"""Maximal features: adjacent faces on one surface, and only those."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from kernel_parts import IN_FREECAD

from gpswb.cad.density import Density
from gpswb.cad.read import read_solid
from gpswb.cad.solid import FaceMap


def halves(name: str, offset: float) -> Any:
    """Two halves of a solid, fused; the second is moved by ``offset`` along z."""
    if IN_FREECAD:
        import FreeCAD
        import Part

        makers = {
            "cylinder": lambda: Part.makeCylinder(
                5, 12, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 180
            ),
            "cone": lambda: Part.makeCone(6, 2, 8, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 180),
            "sphere": lambda: Part.makeSphere(
                7, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), -90, 90, 180
            ),
        }
        one = makers[name]()
        other = one.copy()
        other.rotate(FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 180)
        other.translate(FreeCAD.Vector(0, 0, offset))
        return one.fuse(other)
    import cadquery as cq

    makers = {
        "cylinder": lambda: cq.Solid.makeCylinder(5, 12, angleDegrees=180),
        "cone": lambda: cq.Solid.makeCone(6, 2, 8, angleDegrees=180),
        "sphere": lambda: cq.Solid.makeSphere(7, angleDegrees1=-90, angleDegrees3=180),
    }
    one = makers[name]()
    other = one.rotate(cq.Vector(), cq.Vector(0, 0, 1), 180).translate(cq.Vector(0, 0, offset))
    return one.fuse(other)


def facemap(made: Any, folder: Path, kernel: str, nurbs: bool) -> FaceMap:
    path = folder / "part.brep"
    if IN_FREECAD:
        (made.toNurbs() if nurbs else made).exportBrep(str(path))
    else:
        import cadquery as cq
        from OCP.BRepBuilderAPI import BRepBuilderAPI_NurbsConvert

        if nurbs:
            made = cq.Shape.cast(BRepBuilderAPI_NurbsConvert(made.wrapped, True).Shape())
        made.exportBrep(str(path))
    found = read_solid(path, Density.parse("stl"), kernel).facemap
    assert found is not None
    return found


@pytest.mark.parametrize("nurbs", [False, True])
@pytest.mark.parametrize(
    ("name", "cls"), [("cylinder", "cylindrical"), ("cone", "revolute"), ("sphere", "spherical")]
)
def test_halves_of_a_surface_are_one_feature(
    name: str, cls: str, nurbs: bool, kernel: str, tmp_path: Path
) -> None:
    found = facemap(halves(name, 0.0), tmp_path, kernel, nurbs)
    mine = [i for i, f in enumerate(found.faces) if f.truth and f.truth.nominal == cls]
    assert len(mine) == 2
    assert len(set(found.feature_of_face[mine].tolist())) == 1
    # The half discs at the ends lie in one plane each; a sphere has none.
    planes = [i for i, f in enumerate(found.faces) if f.truth and f.truth.nominal == "planar"]
    assert len(set(found.feature_of_face[planes].tolist())) == (0 if name == "sphere" else 2)


@pytest.mark.parametrize("nurbs", [False, True])
def test_a_step_keeps_planes_apart(nurbs: bool, kernel: str, tmp_path: Path) -> None:
    """The same halves, one raised by 0.01 mm: four planes across the axis, one cylinder."""
    found = facemap(halves("cylinder", 0.01), tmp_path, kernel, nurbs)
    discs = [
        i
        for i, f in enumerate(found.faces)
        if f.truth and f.truth.nominal == "planar" and f.area > 30
    ]
    assert len(discs) == 4
    assert len(set(found.feature_of_face[discs].tolist())) == 4
    round_ = [i for i, f in enumerate(found.faces) if f.truth and f.truth.nominal == "cylindrical"]
    assert len(set(found.feature_of_face[round_].tolist())) == 1


def lemon() -> Any:
    """An arc turned round an axis that it is nearer to than to its centre, cut through the axis."""
    if IN_FREECAD:
        import FreeCAD
        import Part

        v = FreeCAD.Vector
        arc = Part.Arc(v(0, 0, -6), v(4, 0, 0), v(0, 0, 6)).toShape()
        face = Part.Face(Part.Wire([arc, Part.makeLine(v(0, 0, 6), v(0, 0, -6))]))
        parts = [face.revolve(v(), v(0, 0, 1), 180)]
        parts.append(parts[0].copy())
        parts[1].rotate(v(), v(0, 0, 1), 180)
        return parts[0].fuse(parts[1])
    import cadquery as cq

    half = (
        cq.Workplane("XZ")
        .moveTo(0, -6)
        .threePointArc((4, 0), (0, 6))
        .close()
        .revolve(180, (0, 0, 0), (0, 1, 0))
    )
    return half.val().fuse(half.rotate((0, 0, 0), (0, 0, 1), 180).val())


def test_halves_of_a_torus_wider_than_its_ring_are_one_feature(kernel: str, tmp_path: Path) -> None:
    found = facemap(lemon(), tmp_path, kernel, False)
    round_ = [i for i, f in enumerate(found.faces) if f.truth and f.truth.nominal == "revolute"]
    assert len(round_) == 2
    assert len(set(found.feature_of_face[round_].tolist())) == 1


def test_features_number_every_face(kernel: str, tmp_path: Path) -> None:
    found = facemap(halves("cone", 0.0), tmp_path, kernel, False)
    numbers = np.unique(found.feature_of_face)
    assert numbers.tolist() == list(range(len(numbers)))
    assert len(found.feature_of_face) == len(found.faces)
