# SPDX-License-Identifier: LGPL-2.1-or-later
"""A plate with rounds, holes and a pocket: planes and cylinders (after the paper's Fig. 14)."""

from __future__ import annotations

import cadquery as cq

from parts.made import MadePart


def simple_part() -> MadePart:
    """Nineteen faces: plate 6, corner rounds 4, through holes 2, pocket 5, blind hole 2."""
    plate = cq.Workplane().box(80, 50, 14).edges("|Z").fillet(9)
    top = plate.faces(">Z").workplane(origin=(0, 0, 7))
    part = (
        top.pushPoints([(-29, -14), (-29, 14)])
        .hole(10)
        .faces(">Z")
        .workplane(origin=(5, 0, 7))
        .slot2D(36, 16)
        .cutBlind(-6)
        .faces(">Z")
        .workplane(origin=(30, 0, 7))
        .circle(5)
        .cutBlind(-9)
    )
    return MadePart("simple_part", part.val(), {"planar": 10, "cylindrical": 9}, features=19)
