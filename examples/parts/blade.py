# SPDX-License-Identifier: LGPL-2.1-or-later
"""A turbine blade: a twisted freeform aerofoil on a platform with a dovetail root."""

from __future__ import annotations

import math

import cadquery as cq

from parts.made import MadePart

SPAN = 90.0
SECTIONS = 7
OUTLINE = 24


def blade() -> MadePart:
    """Aerofoil, platform and root.

    Planes: tip 1; platform 5 (top, two beneath, two long sides); two ends that platform and root
    share; root 7 (two waists, two flanks up, two down, the bottom). Cylinders: six rounds of the
    root. Complex: the aerofoil.
    """
    wires = [_section(k / (SECTIONS - 1)) for k in range(SECTIONS)]
    aerofoil = cq.Solid.makeLoft(wires, ruled=False)
    platform = cq.Workplane().box(56, 34, 8, centered=(True, True, False)).translate((0, 0, -8))
    root = (
        cq.Workplane("YZ", origin=(-28, 0, 0))
        .moveTo(-7, -8)
        .lineTo(-7, -16)
        .lineTo(-13, -24)
        .lineTo(-9, -32)
        .lineTo(9, -32)
        .lineTo(13, -24)
        .lineTo(7, -16)
        .lineTo(7, -8)
        .close()
        .extrude(56)
    )
    below = cq.selectors.BoxSelector((-30, -20, -33), (30, 20, -10))
    root = root.edges("|X").edges(below).fillet(2.5)
    body = platform.union(root).union(cq.Workplane(aerofoil))
    counts = {"planar": 15, "cylindrical": 6, "complex": 1}
    return MadePart("blade", body.val(), counts, features=22)


def _section(t: float) -> cq.Wire:
    """The aerofoil's outline at the share ``t`` of its span: thinner, shorter, turned, leaning."""
    chord, thick, camber = 44 - 16 * t, 0.16 - 0.07 * t, 0.12 - 0.05 * t
    turn = math.radians(8 + 38 * t**1.2)
    lean = 7 * t**2
    points = []
    for i in range(OUTLINE):
        phi = 2 * math.pi * i / OUTLINE
        u = 0.5 * (1 + math.cos(phi))  # 1 at the trailing edge, 0 at the leading one
        # An ellipse drawn out towards the trailing edge: blunt in front, thin behind.
        half = thick * math.sin(phi) * (1.15 - 0.75 * u)
        x = chord * (u - 0.45)
        y = chord * (half + 4 * camber * u * (1 - u) - 0.5 * camber)
        points.append(
            cq.Vector(
                x * math.cos(turn) - y * math.sin(turn),
                x * math.sin(turn) + y * math.cos(turn) + lean,
                -2.0 + (SPAN + 2.0) * t,
            )
        )
    return cq.Wire.assembleEdges([cq.Edge.makeSpline(points, periodic=True)])
