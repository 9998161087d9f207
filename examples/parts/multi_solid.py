# SPDX-License-Identifier: LGPL-2.1-or-later
"""Several solids in one file, two of them touching."""

from __future__ import annotations

import cadquery as cq

from parts.made import MadePart


def multi_solid() -> MadePart:
    """A drilled block (7 faces), a pin that stands on it (3) and a ball apart (1)."""
    block = cq.Workplane().box(40, 30, 20, centered=(True, True, False)).faces(">Z")
    drilled = block.workplane(origin=(10, 0, 20)).hole(12)
    pin = cq.Workplane(origin=(-10, 0, 20)).circle(5).extrude(15)
    ball = cq.Workplane(origin=(40, 0, 10)).sphere(9)
    shape = cq.Compound.makeCompound([drilled.val(), pin.val(), ball.val()])
    counts = {"planar": 8, "cylindrical": 2, "spherical": 1}
    return MadePart("multi_solid", shape, counts, features=11)
