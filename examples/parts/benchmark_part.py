# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part that speed and accuracy are measured on: every kind of surface, 34 faces."""

from __future__ import annotations

import math

import cadquery as cq

from parts.made import MadePart


def benchmark_part() -> MadePart:
    """A block that carries one of each.

    Planes: block 6, spindle 1, cam 1, pad 4, pocket 3. Cylinders: corners 4, spindle 1, pocket 2,
    holes 3. Cones: spindle 1, countersinks 3. Tori: spindle 1, dome 1. One sphere, one extruded
    spline, one free-form face.
    """
    block = cq.Workplane().box(120, 80, 30, centered=(True, True, False))
    block = block.edges("|Z").fillet(8)
    # A spindle turned from a profile: cylinder, torus, cone, plane.
    s = math.sqrt(0.5)
    spindle = (
        cq.Workplane("XZ")
        .moveTo(0, 28)
        .lineTo(20, 28)
        .lineTo(20, 30)
        .threePointArc((20 - 5 * s, 35 - 5 * s), (15, 35))
        .lineTo(15, 45)
        .lineTo(9, 57)
        .lineTo(0, 57)
        .close()
        .revolve(360, (0, 0, 0), (0, 1, 0))
        .translate((-32, -10, 0))
    )
    dome = cq.Workplane(origin=(-42, 25, 30)).sphere(10)
    # A cam: an extruded spline.
    cam = (
        cq.Workplane(origin=(38, -16, 28))
        .spline([(14, 0), (5, 10), (-10, 8), (-14, -6), (0, -11)], periodic=True)
        .close()
        .extrude(16)
    )
    body = block.union(dome)
    foot = body.edges(cq.selectors.BoxSelector((-56, 12, 29), (-28, 38, 31), boundingbox=True))
    body = body.newObject(foot.vals()).fillet(2)
    body = body.union(spindle).union(cam)
    # A free-form top on a pad of its own.
    points = [
        [
            cq.Vector(x, y, 42 + 2.5 * math.sin(0.17 * x + 0.4) * math.cos(0.21 * y))
            for y in (12, 18, 24, 30, 36)
        ]
        for x in (0, 8, 16, 24, 32, 40)
    ]
    above = cq.Face.makeSplineApprox(points, tol=1e-6)
    pad = cq.Workplane(origin=(20, 24, 28)).rect(30, 16).extrude(30)
    lid = cq.Workplane(cq.Solid.extrudeLinear(above, cq.Vector(0, 0, 40)))
    body = body.union(pad.cut(lid))
    body = body.cut(cq.Workplane(origin=(4, -30, 30)).slot2D(34, 10).extrude(-8))
    for x, y in ((-50, -30), (50, -30), (50, 30)):
        body = body.cut(cq.Workplane(origin=(x, y, 30)).circle(3).extrude(-30))
        sink = cq.Solid.makeCone(3, 6, 3, pnt=cq.Vector(x, y, 27), dir=cq.Vector(0, 0, 1))
        body = body.cut(cq.Workplane(sink))
    counts = {
        "planar": 15,
        "cylindrical": 10,
        "revolute": 6,
        "spherical": 1,
        "prismatic": 1,
        "complex": 1,
    }
    return MadePart("benchmark_part", body.val(), counts, features=34)
