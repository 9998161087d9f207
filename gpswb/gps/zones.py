# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes of tolerance zones (ISO 1101)."""

from __future__ import annotations

from gpswb.gps.characteristics import RULES, Characteristic, Family

_PLANES = "between two parallel planes"
_FIXED: dict[Characteristic, str] = {
    "flatness": _PLANES,
    "roundness": "between two concentric circles in each section",
    "cylindricity": "between two coaxial cylinders",
    "line profile": "between two lines equidistant from the nominal line, in each section",
    "surface profile": "between two surfaces equidistant from the nominal surface",
    "symmetry": _PLANES,
}


def zone_shape(characteristic: Characteristic, kind: Family) -> tuple[str, str]:
    """Shape of the zone in words, and what stands before the value: nothing, Ø or SØ."""
    if characteristic in _FIXED:
        return _FIXED[characteristic], ""
    if characteristic == "straightness":
        median = ", or a cylinder Ø for the median line" if kind == "cylinder" else ""
        return f"between two parallel straight lines for each line element{median}", ""
    if characteristic == "circular run-out":
        if kind == "plane":
            return "between two equal circles on each cylinder about the datum axis", ""
        return "between two concentric circles about the datum axis, in each section", ""
    if characteristic == "total run-out":
        if kind == "plane":
            return "between two parallel planes perpendicular to the datum axis", ""
        return "between two cylinders about the datum axis", ""
    if characteristic == "concentricity" and kind != "sphere":
        return "circle about the datum's centre, in each section", "Ø"
    if kind == "sphere":
        return "sphere", "SØ"
    planar = kind in ("plane", "opposed planes", "prismatic")
    if planar and RULES[characteristic].group in ("orientation", "location"):
        return _PLANES, ""
    return "cylinder", "Ø"
