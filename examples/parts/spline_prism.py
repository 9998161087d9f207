# SPDX-License-Identifier: LGPL-2.1-or-later
"""A prism on a spline: prismatic faces."""

from __future__ import annotations

import cadquery as cq

from parts.made import MadePart


def spline_prism() -> MadePart:
    """A bar whose section is a straight foot and two splines: two prismatic faces, planes else."""
    part = (
        cq.Workplane("XY")
        .moveTo(-25, 0)
        .lineTo(25, 0)
        .lineTo(25, 8)
        .spline([(16, 17), (6, 13), (0, 20)], includeCurrent=True)
        .spline([(-9, 11), (-18, 16), (-25, 8)], includeCurrent=True)
        .close()
        .extrude(60)
    )
    return MadePart("spline_prism", part.val(), {"prismatic": 2, "planar": 5}, features=7)
