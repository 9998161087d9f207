# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes of tolerance zones (ISO 1101)."""

from __future__ import annotations

from gpswb.gps.characteristics import RULES, Characteristic, Family
from gpswb.sentence import Sentence

_PLANES = Sentence("between two parallel planes")
_FIXED: dict[Characteristic, Sentence] = {
    "flatness": _PLANES,
    "roundness": Sentence("between two concentric circles in each section"),
    "cylindricity": Sentence("between two coaxial cylinders"),
    "line profile": Sentence(
        "between two lines equidistant from the nominal line, in each section"
    ),
    "surface profile": Sentence("between two surfaces equidistant from the nominal surface"),
    "symmetry": _PLANES,
}


def zone_shape(characteristic: Characteristic, kind: Family) -> tuple[Sentence, str]:
    """Shape of the zone in words, and what stands before the value: nothing, Ø or SØ."""
    if characteristic in _FIXED:
        return _FIXED[characteristic], ""
    if characteristic == "straightness":
        lines = Sentence("between two parallel straight lines for each line element")
        if kind != "cylinder":
            return lines, ""
        return Sentence("{lines}, or a cylinder Ø for the median line", lines=lines), ""
    if characteristic == "circular run-out":
        if kind == "plane":
            return Sentence("between two equal circles on each cylinder about the datum axis"), ""
        return Sentence("between two concentric circles about the datum axis, in each section"), ""
    if characteristic == "total run-out":
        if kind == "plane":
            return Sentence("between two parallel planes perpendicular to the datum axis"), ""
        return Sentence("between two cylinders about the datum axis"), ""
    if characteristic == "concentricity" and kind != "sphere":
        return Sentence("circle about the datum's centre, in each section"), "Ø"
    if kind == "sphere":
        return Sentence("sphere"), "SØ"
    planar = kind in ("plane", "opposed planes", "prismatic")
    if planar and RULES[characteristic].group in ("orientation", "location"):
        return _PLANES, ""
    return Sentence("cylinder"), "Ø"
