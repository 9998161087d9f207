# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small parts with closed forms, made by whichever kernel this Python has."""

from __future__ import annotations

import importlib.util
import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

IN_FREECAD = importlib.util.find_spec("FreeCAD") is not None


@dataclass(frozen=True)
class Known:
    """Volume (mm³), and the faces as (class, area in mm²) in any order."""

    volume: float
    faces: tuple[tuple[str, float], ...]


def _cone_side(r: float, h: float) -> float:
    return math.pi * r * math.hypot(r, h)


KNOWN = {
    "cylinder": Known(
        math.pi * 25 * 12,
        (("cylindrical", 120 * math.pi), ("planar", 25 * math.pi), ("planar", 25 * math.pi)),
    ),
    "cone": Known(math.pi * 36 * 8 / 3, (("revolute", _cone_side(6, 8)), ("planar", 36 * math.pi))),
    "sphere": Known(4 / 3 * math.pi * 343, (("spherical", 4 * math.pi * 49),)),
    "torus": Known(2 * math.pi**2 * 10 * 9, (("revolute", 4 * math.pi**2 * 30),)),
    "drilled": Known(
        20 * 16 * 10 - math.pi * 9 * 10,
        (
            *(("planar", a) for a in (160.0, 160.0, 200.0, 200.0)),
            *(("planar", 320 - 9 * math.pi) for _ in range(2)),
            ("cylindrical", 60 * math.pi),
        ),
    ),
}
"""Sizes in mm: cylinder R5 H12; cone R6 H8 with its apex; sphere R7; torus 10/3; block 20x16x10
with a hole of R3."""


def _freecad(name: str) -> Any:
    import FreeCAD  # Part crashes where FreeCAD is not loaded yet
    import Part

    Vector = FreeCAD.Vector

    makers: dict[str, Callable[[], Any]] = {
        "cylinder": lambda: Part.makeCylinder(5, 12),
        "cone": lambda: Part.makeCone(6, 0, 8),
        "sphere": lambda: Part.makeSphere(7),
        "torus": lambda: Part.makeTorus(10, 3),
        "drilled": lambda: Part.makeBox(20, 16, 10).cut(Part.makeCylinder(3, 10, Vector(9, 8, 0))),
        "wire": lambda: Part.makePolygon([Vector(0, 0, 0), Vector(1, 0, 0), Vector(1, 1, 0)]),
        "two": lambda: Part.makeCompound(
            [Part.makeBox(10, 10, 10), Part.makeBox(10, 10, 10, Vector(10, 0, 0))]
        ),
    }
    return makers[name]()


def _ocp(name: str) -> Any:
    import cadquery as cq

    solid = cq.Solid
    makers: dict[str, Callable[[], Any]] = {
        "cylinder": lambda: solid.makeCylinder(5, 12),
        "cone": lambda: solid.makeCone(6, 0, 8),
        "sphere": lambda: solid.makeSphere(7, angleDegrees1=-90),
        "torus": lambda: solid.makeTorus(10, 3),
        "drilled": lambda: solid.makeBox(20, 16, 10).cut(
            solid.makeCylinder(3, 10, cq.Vector(9, 8, 0))
        ),
        "wire": lambda: cq.Wire.makePolygon([(0, 0, 0), (1, 0, 0), (1, 1, 0)]),
        "two": lambda: cq.Compound.makeCompound(
            [solid.makeBox(10, 10, 10), solid.makeBox(10, 10, 10, cq.Vector(10, 0, 0))]
        ),
    }
    return makers[name]()


def shape(name: str, nurbs: bool = False) -> Any:
    """The part as this Python's kernel has it; ``nurbs`` turns every surface into a B-spline."""
    if IN_FREECAD:
        made = _freecad(name)
        return made.toNurbs() if nurbs else made
    made = _ocp(name)
    if nurbs:
        import cadquery as cq
        from OCP.BRepBuilderAPI import BRepBuilderAPI_NurbsConvert

        made = cq.Shape.cast(BRepBuilderAPI_NurbsConvert(made.wrapped, True).Shape())
    return made


def write(name: str, folder: Path, suffix: str = ".step", nurbs: bool = False) -> Path:
    """Write the part as STEP or BREP."""
    path, made = folder / f"{name}{suffix}", shape(name, nurbs)
    if IN_FREECAD:
        (made.exportStep if suffix == ".step" else made.exportBrep)(str(path))
    elif suffix == ".step":
        from parts.step_units import write_step

        write_step(made, path)
    else:
        made.exportBrep(str(path))
    return path
