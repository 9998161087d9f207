# SPDX-License-Identifier: LGPL-2.1-or-later
"""A bearing bracket: the realistic example of the main job."""

from __future__ import annotations

import cadquery as cq

from parts.made import MadePart


def bracket() -> MadePart:
    """Base plate with counterbored holes and a slot, wall with a bearing boss, two ribs.

    Planes: base 6, wall back, sides and a front that the ribs and the boss divide 5, boss 1, ribs
    6, counterbores 4, slot 2. Cylinders: corners 4, wall top 1, boss 1, bore 1, counterbores 4,
    holes 4, slot 2. One torus (the boss's root), one cone (the bore's seat).
    """
    base = cq.Workplane().box(120, 80, 14, centered=(True, True, False))
    base = base.edges("|Z").fillet(10)
    wall = (
        cq.Workplane("XZ", origin=(0, 30, 0))
        .moveTo(-40, 14)
        .lineTo(-40, 60)
        .threePointArc((0, 100), (40, 60))
        .lineTo(40, 14)
        .close()
        .extrude(16)
    )
    body = base.union(wall)
    # The boss stands out of the wall's front; a torus leads into it.
    boss = cq.Workplane("XZ", origin=(0, 14, 60)).circle(24).extrude(10)
    body = body.union(boss)
    root = body.edges(cq.selectors.BoxSelector((-25, 13.9, 35), (25, 14.1, 85), boundingbox=True))
    body = body.newObject(root.vals()).fillet(4)
    rib = (
        cq.Workplane("YZ", origin=(-31, 0, 0))
        .moveTo(14, 14)
        .lineTo(-24, 14)
        .lineTo(14, 52)
        .close()
        .extrude(8)
    )
    body = body.union(rib).union(rib.translate((54, 0, 0)))
    body = body.cut(cq.Workplane("XZ", origin=(0, 40, 60)).circle(14).extrude(60))
    seat = cq.Solid.makeCone(18, 14, 4, pnt=cq.Vector(0, 4, 60), dir=cq.Vector(0, 1, 0))
    body = body.cut(cq.Workplane(seat))
    holes = [(-48, -28), (48, -28), (-48, 28), (48, 28)]
    top = cq.Workplane(origin=(0, 0, 14)).pushPoints(holes)
    body = body.cut(top.circle(8).extrude(-5)).cut(top.circle(4.5).extrude(-14))
    slot = cq.Workplane(origin=(0, -26, 14)).slot2D(40, 10).extrude(-14)
    body = body.cut(slot)
    counts = {"planar": 24, "cylindrical": 17, "revolute": 2}
    return MadePart("bracket", body.val(), counts, features=43)
