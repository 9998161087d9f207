# SPDX-License-Identifier: LGPL-2.1-or-later
"""A turned part with a round and a fillet (after the paper's Fig. 15)."""

from __future__ import annotations

import math

import cadquery as cq

from parts.made import MadePart


def revolution_part() -> MadePart:
    """Ten surfaces: three planes, three cylinders, two cones, two tori.

    Four of its ten edges are tangent (the tori), six are sharp, as in the paper's figure.
    """
    s = math.sqrt(0.5)
    profile = (
        cq.Workplane("XZ")
        .moveTo(11, 0)
        .lineTo(30, 0)
        .lineTo(30, 14)
        .threePointArc((26 + 4 * s, 14 + 4 * s), (26, 18))
        .lineTo(21, 18)
        .threePointArc((21 - 6 * s, 24 - 6 * s), (15, 24))
        .lineTo(15, 36)
        .lineTo(11, 46)
        .lineTo(7, 46)
        .lineTo(7, 6)
        .close()
    )
    part = profile.revolve(360, (0, 0, 0), (0, 1, 0))
    counts = {"planar": 3, "cylindrical": 3, "revolute": 4}
    return MadePart("revolution_part", part.val(), counts, features=10)
