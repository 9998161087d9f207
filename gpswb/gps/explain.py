# SPDX-License-Identifier: LGPL-2.1-or-later
"""Features, datum systems and freedoms in plain words."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gpswb.core.mesh import FloatArray
from gpswb.gps.datum_system import DatumSystem, Freedom, Lock
from gpswb.gps.gps_feature import GpsFeature, Size
from gpswb.gps.twists import rotations_of, translations_of
from gpswb.sentence import Sentence, joined

_NUMBERS = (
    Sentence("no"),
    Sentence("one"),
    Sentence("two"),
    Sentence("three"),
    Sentence("four"),
    Sentence("five"),
    Sentence("six"),
)
_TRANSLATIONS = (
    Sentence("one translation"),
    Sentence("two translations"),
    Sentence("three translations"),
)
_ROTATIONS = (
    Sentence("one rotation"),
    Sentence("two rotations"),
    Sentence("three rotations"),
)


def explain_datum_system(system: DatumSystem, needed: int) -> Sentence:
    """A sentence for each letter, one for the system, and one on what it leaves free of the part.

    Args:
        needed: degrees of freedom that the part lets any datum system lock.
    """
    if not system.datums:
        return Sentence("Without a datum nothing is locked.")
    lines = []
    for datum, lock in zip(system.datums, system.locks, strict=True):
        names: str = explain_feature(datum.features[0])
        for feature in datum.features[1:]:
            names = Sentence("{one} with {other}", one=names, other=explain_feature(feature))
        only = Sentence(", for orientation only,") if datum.orientation_only else ""
        what = explain_lock(lock)
        lines.append(
            Sentence(
                "{datum} ({names}){only} {what}.",
                datum=datum.name,
                names=names,
                only=only,
                what=what,
            )
        )
    return joined("\n", [*lines, explain_whole(system, needed)])


def explain_whole(system: DatumSystem, needed: int) -> Sentence:
    """Of that the sentences on the system and on the part, without those on each letter."""
    lines = []
    if system.degrees >= needed:
        rest = Sentence("; the other {n} no datum of it can lock", n=_NUMBERS[6 - needed])
        lines.append(
            Sentence(
                "Together they lock {n} of six: complete{rest}.",
                n=_NUMBERS[system.degrees],
                rest="" if needed == 6 else rest,
            )
        )
    else:
        lines.append(
            Sentence(
                "Together they lock {n} of the {needed} degrees of freedom that this part's datums "
                "can lock: not complete.",
                n=_NUMBERS[system.degrees],
                needed=_NUMBERS[needed],
            )
        )
    if system.degrees < 6:
        free = Freedom(translations_of(system.free), rotations_of(system.free), False)
        lines.append(Sentence("Of the part {free}.", free=explain_freedom(free)))
    return joined("\n", lines)


def explain_feature(feature: GpsFeature) -> Sentence:
    """Name, size and faces: ``Hole 2, Ø10, Face5 Face6``."""
    parts = [feature.name]
    if feature.size is not None:
        count = f"{int(feature.intrinsic['count'])} × " if "count" in feature.intrinsic else ""
        parts.append(joined("", [count, _size(feature.size)]))
    if feature.faces:
        parts.append(" ".join(feature.faces))
    return joined(", ", parts)


def _size(size: Size) -> Sentence:
    if size.kind == "diameter":
        return Sentence("Ø{value:.6g}", value=size.value)
    if size.kind == "spherical diameter":
        return Sentence("SØ{value:.6g}", value=size.value)
    if size.kind == "width":
        return Sentence("width {value:.6g}", value=size.value)
    return Sentence("angle {value:.6g}°", value=size.value)


def explain_freedom(freedom: Freedom) -> Sentence:
    """What stays free of a feature, as information."""
    if freedom.located:
        return Sentence("the datums locate it fully")
    along, about = _directions(freedom.translations), _directions(freedom.rotations)
    if not len(freedom.rotations):
        return Sentence("translation along {along} stays free", along=along)
    if not len(freedom.translations):
        return Sentence("rotation about {about} stays free", about=about)
    return Sentence(
        "translation along {along} and rotation about {about} stays free", along=along, about=about
    )


def explain_lock(lock: Lock) -> Sentence:
    """What a letter locks: ``locks one translation and two rotations``."""
    if lock.redundant:
        return Sentence("is redundant: it locks nothing that isn't locked already")
    translations = _TRANSLATIONS[lock.translations - 1]
    rotations = _ROTATIONS[lock.rotations - 1]
    if not lock.rotations:
        return Sentence("locks {what}", what=translations)
    if not lock.translations:
        return Sentence("locks {what}", what=rotations)
    return Sentence("locks {what} and {also}", what=translations, also=rotations)


def _directions(directions: FloatArray) -> Sentence | str:
    """One direction, all those in a plane, or any."""
    if len(directions) == 1:
        return direction_name(directions[0])
    if len(directions) == 2:
        normal = direction_name(np.cross(*directions))
        return Sentence("any direction perpendicular to {normal}", normal=normal)
    return Sentence("any direction")


def direction_name(direction: Sequence[float] | FloatArray) -> str:
    """X, Y or Z where it is one of these, else its components; the sense doesn't matter."""
    for name, component in zip("XYZ", direction, strict=True):
        if abs(component) > 1 - 1e-6:
            return name
    components = np.round(direction, 3) + 0.0
    sense = np.sign(components[np.flatnonzero(components)[0]])
    return "(" + ", ".join(f"{component:g}" for component in sense * components + 0.0) + ")"
