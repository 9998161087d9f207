# SPDX-License-Identifier: LGPL-2.1-or-later
"""Features, datum systems and freedoms in plain words."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gpswb.core.mesh import FloatArray
from gpswb.gps.datum_system import DatumSystem, Freedom, Lock
from gpswb.gps.gps_feature import GpsFeature
from gpswb.gps.twists import rotations_of, translations_of

_NUMBERS = ("no", "one", "two", "three", "four", "five", "six")


def explain_datum_system(system: DatumSystem, needed: int) -> str:
    """A sentence for each letter, one for the system, and one on what it leaves free of the part.

    Args:
        needed: degrees of freedom that the part lets any datum system lock.
    """
    if not system.datums:
        return "Without a datum nothing is locked."
    lines = []
    for datum, lock in zip(system.datums, system.locks, strict=True):
        names = " with ".join(explain_feature(feature) for feature in datum.features)
        only = ", for orientation only," if datum.orientation_only else ""
        lines.append(f"{datum.name} ({names}){only} {explain_lock(lock)}.")
    if system.degrees >= needed:
        rest = "" if needed == 6 else f"; the other {_NUMBERS[6 - needed]} no datum of it can lock"
        lines.append(f"Together they lock {_NUMBERS[system.degrees]} of six: complete{rest}.")
    else:
        lines.append(
            f"Together they lock {_NUMBERS[system.degrees]} of the {_NUMBERS[needed]} degrees of "
            "freedom that this part's datums can lock: not complete."
        )
    if system.degrees < 6:
        free = Freedom(translations_of(system.free), rotations_of(system.free), False)
        lines.append(f"Of the part {explain_freedom(free)}.")
    return "\n".join(lines)


def explain_feature(feature: GpsFeature) -> str:
    """Name, size and faces: ``Hole 2, Ø10, Face5 Face6``."""
    parts = [feature.name]
    if feature.size is not None:
        sign = {"diameter": "Ø", "spherical diameter": "SØ", "width": "width "}
        count = f"{int(feature.intrinsic['count'])} × " if "count" in feature.intrinsic else ""
        degrees = "°" if feature.size.kind == "cone angle" else ""
        parts.append(
            f"{count}{sign.get(feature.size.kind, 'angle ')}{feature.size.value:.6g}{degrees}"
        )
    if feature.faces:
        parts.append(" ".join(feature.faces))
    return ", ".join(parts)


def explain_freedom(freedom: Freedom) -> str:
    """What stays free of a feature, as information."""
    if freedom.located:
        return "the datums locate it fully"
    moves = []
    if len(freedom.translations):
        moves.append(f"translation {_along(freedom.translations, 'along')}")
    if len(freedom.rotations):
        moves.append(f"rotation {_along(freedom.rotations, 'about')}")
    return f"{' and '.join(moves)} stays free"


def explain_lock(lock: Lock) -> str:
    """What a letter locks: ``locks one translation and two rotations``."""
    if lock.redundant:
        return "is redundant: it locks nothing that isn't locked already"
    parts = [
        f"{_NUMBERS[n]} {word}{'s' if n > 1 else ''}"
        for n, word in ((lock.translations, "translation"), (lock.rotations, "rotation"))
        if n
    ]
    return f"locks {' and '.join(parts)}"


def _along(directions: FloatArray, word: str) -> str:
    """One direction, all those in a plane, or any."""
    if len(directions) == 1:
        return f"{word} {direction_name(directions[0])}"
    if len(directions) == 2:
        return f"{word} any direction perpendicular to {direction_name(np.cross(*directions))}"
    return f"{word} any direction"


def direction_name(direction: Sequence[float] | FloatArray) -> str:
    """X, Y or Z where it is one of these, else its components; the sense doesn't matter."""
    for name, component in zip("XYZ", direction, strict=True):
        if abs(component) > 1 - 1e-6:
            return name
    components = np.round(direction, 3) + 0.0
    sense = np.sign(components[np.flatnonzero(components)[0]])
    return "(" + ", ".join(f"{component:g}" for component in sense * components + 0.0) + ")"
