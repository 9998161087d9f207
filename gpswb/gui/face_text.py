# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is known of a face, as text for people."""

from __future__ import annotations

from typing import Any

import FreeCAD

from gpswb.core.partition import Region
from gpswb.errors import InputError
from gpswb.gui.compat import QT_TRANSLATE_NOOP, translate
from gpswb.io.stored_result import StoredResult
from gpswb.sentence import Sentence
from gpswb.validation.face_result import FaceResult

_NAMES = {
    "radius": QT_TRANSLATE_NOOP("GPS", "Radius"),
    "major_radius": QT_TRANSLATE_NOOP("GPS", "Radius of the centre circle"),
    "minor_radius": QT_TRANSLATE_NOOP("GPS", "Radius of the tube"),
    "half_angle_deg": QT_TRANSLATE_NOOP("GPS", "Half angle"),
    "lead": QT_TRANSLATE_NOOP("GPS", "Lead"),
    "point": QT_TRANSLATE_NOOP("GPS", "Point"),
    "direction": QT_TRANSLATE_NOOP("GPS", "Direction"),
    "normal": QT_TRANSLATE_NOOP("GPS", "Normal"),
}
_SITUATION = {
    "planar": QT_TRANSLATE_NOOP("GPS", "plane"),
    "cylindrical": QT_TRANSLATE_NOOP("GPS", "line"),
    "spherical": QT_TRANSLATE_NOOP("GPS", "point"),
    "revolute": QT_TRANSLATE_NOOP("GPS", "line and point"),
    "prismatic": QT_TRANSLATE_NOOP("GPS", "plane and line"),
    "helical": QT_TRANSLATE_NOOP("GPS", "helix"),
    "complex": QT_TRANSLATE_NOOP("GPS", "plane, line and point"),
}


def face_rows(stored: StoredResult, name: str) -> list[tuple[str, str]]:
    """Names and values of all that is known of a face.

    Raises:
        InputError: there is no such face.
    """
    face = next((face for face in stored.faces if face.name == name), None)
    if face is None:
        raise InputError(Sentence("no face {name!r}", name=name))
    rows = [(translate("GPS", "Class"), translate("GPS", face.invariance_class or "none"))]
    if face.undecided:
        classes = ", ".join(translate("GPS", each) for each in face.undecided)
        rows.append((translate("GPS", "Undecided"), classes))
    if stored.document["faces"]:  # what was measured has no CAD to compare with
        surface = f"{translate('GPS', face.surface)}, {translate('GPS', face.true_class or '–')}"
        rows.append((translate("GPS", "CAD surface"), surface))
        rows.append((translate("GPS", "Agreement"), _agreement(face)))
    rows.append((translate("GPS", "Area"), quantity(face.area, FreeCAD.Units.Area)))
    rows.append((translate("GPS", "Triangles"), str(face.triangles)))
    region = next((r for r in stored.partition.regions if r.id in face.regions[:1]), None)
    return rows + (_region_rows(region) if region is not None else [])


def ranking_rows(stored: StoredResult, name: str) -> list[tuple[str, float]]:
    """The seven classes with their log-likelihoods, best first, for the region of a face."""
    face = next((face for face in stored.faces if face.name == name), None)
    region = next(
        (r for r in stored.partition.regions if face is not None and r.id in face.regions[:1]), None
    )
    found = region.log_likelihood if region is not None else {}
    return sorted(found.items(), key=lambda item: -item[1])


def quantity(value: float, unit: Any) -> str:
    """A value (mm, mm², degrees) in the user's own units."""
    # What is zero to rounding is written without a sign.
    text = str(FreeCAD.Units.Quantity(round(value, 9) + 0.0, unit).UserString)
    return text.replace("^2", "²")


def _agreement(face: FaceResult) -> str:
    if face.true_class is None:
        return str(translate("GPS", "no CAD class"))
    text = translate("GPS", "agrees") if face.agrees else translate("GPS", "disagrees")
    share = translate("GPS", "{} % of its area").format(int(100 * face.share))
    disputed = ", " + translate("GPS", "the CAD class is disputed") if face.ambiguous else ""
    return f"{text}, {share}{disputed}"


def _region_rows(region: Region) -> list[tuple[str, str]]:
    length, angle = FreeCAD.Units.Length, FreeCAD.Units.Angle
    rows = [
        (translate("GPS", "Region"), f"{region.id}, {translate('GPS', region.surface)}"),
        (
            translate("GPS", "Situation feature"),
            translate("GPS", _SITUATION[region.invariance_class]),
        ),
    ]
    for key, values in region.situation.items():
        if key == "point":
            text = ", ".join(quantity(value, length) for value in values)
        else:
            text = ", ".join(f"{round(value, 4) + 0.0:.4f}" for value in values)
        rows.append((translate("GPS", _NAMES[key]), text))
    for key, value in region.intrinsic.items():
        unit = angle if key.endswith("_deg") else length
        rows.append((translate("GPS", _NAMES[key]), quantity(value, unit)))
    rows.append((translate("GPS", "Residual"), f"{round(region.residual, 9):.2g} mm"))
    return rows
