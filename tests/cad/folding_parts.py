# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts on which a mesh folds over itself easily, made by whichever kernel this Python has.

- spindle: a B-spline arc turned about the line through its ends: a pole at both;
- ring: a plane ring 0.01 mm wide about a shaft of 6 mm: narrower than the bend of its chords;
- blade: an extruded B-spline profile, 40 mm long and 1 mm thick, with a leading edge of 0.1 mm;
- ball, cone: poles and an apex;
- lune: a slice of 28 degrees of a ball, whose face has both poles as corners;
- moon: an extruded crescent between two arcs that are 0.02 mm apart in their middles, less than
  the bend of their chords.
"""

from __future__ import annotations

import importlib.util
import math
from pathlib import Path
from typing import Any

IN_FREECAD = importlib.util.find_spec("FreeCAD") is not None
NAMES = ("spindle", "ring", "blade", "ball", "cone", "lune", "moon")

ARC = [(0.0, 0.0), (1.0, 2.5), (6.0, 4.5), (20.0, 5.0), (38.0, 3.0), (40.0, 0.0)]
PROFILE = [
    (0.0, 0.0), (0.04, 0.08), (0.2, 0.16), (6.0, 0.6), (20.0, 0.7), (40.0, 0.1),
    (40.0, -0.1), (20.0, -0.3), (6.0, -0.2), (0.2, -0.1), (0.04, -0.06), (0.0, 0.0),
]  # fmt: skip
_RADIUS, _ANGLE, _GAP = 30.0, 1.2, 0.02
MOON_END = _RADIUS * math.sin(_ANGLE), _RADIUS * (1 - math.cos(_ANGLE))
MOON_MIDDLE = _RADIUS * math.sin(_ANGLE / 2), _RADIUS * (1 - math.cos(_ANGLE / 2))
MOON_BACK = MOON_MIDDLE[0] - _GAP * math.sin(_ANGLE / 2), MOON_MIDDLE[1] + _GAP


def _freecad(name: str) -> Any:
    import FreeCAD  # Part crashes where FreeCAD is not loaded yet
    import Part

    Vector = FreeCAD.Vector

    def spline(points: list[tuple[float, float]]) -> Any:
        curve = Part.BSplineCurve()
        curve.interpolate([Vector(x, y, 0) for x, y in points])
        return curve.toShape()

    if name == "ring":
        return Part.makeCylinder(6, 10).fuse(Part.makeCylinder(6.01, 4))
    if name == "ball":
        return Part.makeSphere(7)
    if name == "lune":
        return Part.makeSphere(7, Vector(0, 0, 0), Vector(0, 0, 1), -90, 90, 28)
    if name == "cone":
        return Part.makeCone(6, 0, 8)
    if name == "spindle":
        axis = Part.makeLine(Vector(40, 0, 0), Vector(0, 0, 0))
        face = Part.Face(Part.Wire([spline(ARC), axis]))
        return face.revolve(Vector(0, 0, 0), Vector(1, 0, 0), 360)
    if name == "blade":
        rear = Part.makeLine(Vector(*PROFILE[5], 0), Vector(*PROFILE[6], 0))
        wire = Part.Wire([spline(PROFILE[:6]), rear, spline(PROFILE[6:])])
    else:
        start, end = Vector(0, 0, 0), Vector(*MOON_END, 0)
        arcs = [Part.Arc(start, Vector(*m, 0), end).toShape() for m in (MOON_MIDDLE, MOON_BACK)]
        wire = Part.Wire(arcs)
    return Part.Face(wire).extrude(Vector(0, 0, 20))


def _ocp(name: str) -> Any:
    import cadquery as cq

    if name == "ring":
        return cq.Workplane().circle(6).extrude(10).union(cq.Workplane().circle(6.01).extrude(4))
    if name == "ball":
        return cq.Workplane(obj=cq.Solid.makeSphere(7, angleDegrees1=-90))
    if name == "lune":
        return cq.Workplane(
            obj=cq.Solid.makeSphere(7, angleDegrees1=-90, angleDegrees2=90, angleDegrees3=28)
        )
    if name == "cone":
        return cq.Workplane(obj=cq.Solid.makeCone(6, 0, 8))
    if name == "spindle":
        arc = cq.Workplane().spline(ARC[1:], includeCurrent=True)
        return arc.close().revolve(360, (0, 0, 0), (1, 0, 0))
    if name == "blade":
        front = cq.Workplane().spline(PROFILE[1:6], includeCurrent=True).lineTo(*PROFILE[6])
        return front.spline(PROFILE[7:], includeCurrent=True).close().extrude(20)
    front = cq.Workplane().threePointArc(MOON_MIDDLE, MOON_END)
    return front.threePointArc(MOON_BACK, (0, 0)).close().extrude(20)


def write(name: str, folder: Path) -> Path:
    """Write the part as BREP: both kernels then see the same shape."""
    path = folder / f"{name}.brep"
    if IN_FREECAD:
        _freecad(name).exportBrep(str(path))
    else:
        _ocp(name).val().exportBrep(str(path))
    return path
