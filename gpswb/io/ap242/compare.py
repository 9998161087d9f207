# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is to be written as PMI, and how far what was read back agrees with it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence

from gpswb.cad.pmi import Pmi, PmiDatum, PmiSize, PmiTolerance, in_order
from gpswb.gps.specified import GeometricalTolerance, Letters, Specified
from gpswb.io.ap242.match import FaceEntity

_SIZE_WORDS = {"width": "thickness", "cone angle": "angle"}


def pmi_of(
    letters: Letters, specified: Sequence[Specified], entities: Mapping[str, FaceEntity]
) -> Pmi:
    """Datums and tolerances as a reader should find them; what is still open isn't among them.

    Args:
        entities: of the faces by name: PMI on a part is on all its occurrences in an assembly.
    """
    names: dict[int, set[str]] = {}
    for name, entity in entities.items():
        names.setdefault(int(entity.number), set()).add(name)

    def everywhere(faces: Iterable[str]) -> tuple[str, ...]:
        return in_order({name for face in faces for name in names[int(entities[face].number)]})

    datums = [
        PmiDatum(letter, everywhere(face for feature in features for face in feature.faces))
        for letter, features in letters.items()
    ]
    tolerances, sizes = [], []
    for each in specified:
        if each.open:
            continue
        faces = everywhere(each.feature.faces)
        if isinstance(each, GeometricalTolerance):
            section = "|".join(datum.notation for datum in each.datums)
            tolerances.append(
                PmiTolerance(
                    each.characteristic, each.characteristic, each.value, each.prefix,
                    each.modifiers, section, faces,
                )
            )  # fmt: skip
        else:
            size = each.feature.size
            assert size is not None
            kind = _SIZE_WORDS.get(size.kind, size.kind)
            sizes.append(PmiSize(kind, size.value, each.lower, each.upper, each.fit, faces))
    return Pmi(tuple(datums), tuple(tolerances), tuple(sizes))


def differences(wanted: Pmi, read: Pmi, *, occt: bool = False) -> list[str]:
    """What of ``wanted`` was not read back: one line each, none if all of it was.

    Args:
        occt: ``read`` is from OCCT's reader. It reads a datum only where a tolerance refers to it,
            drops the sign of a lower deviation, takes two negative deviations for limits, and
            doesn't tell which tolerance class a size has: so much isn't compared.
    """
    used = {letter for each in wanted.tolerances for letter in re.findall("[A-Z]+", each.datums)}
    lines = [
        f"datum {datum.letter} on {' '.join(datum.faces)}"
        for datum in wanted.datums
        if (datum.letter in used or not occt)
        and not any(datum.letter == r.letter and datum.faces == r.faces for r in read.datums)
    ]
    left = list(read.tolerances)
    for tolerance in wanted.tolerances:
        same = next((r for r in left if _same_tolerance(tolerance, r)), None)
        if same is None:
            lines.append(f"{tolerance.characteristic} {tolerance.value:g} on {tolerance.faces}")
        else:
            left.remove(same)
    rest = list(read.sizes)
    for size in wanted.sizes:
        found = next((r for r in rest if _same_size(size, r, occt=occt)), None)
        if found is None:
            lines.append(f"{size.kind} {size.nominal:g} on {size.faces}")
        else:
            rest.remove(found)
    return lines


def _same_tolerance(wanted: PmiTolerance, read: PmiTolerance) -> bool:
    return (
        wanted.characteristic == read.characteristic
        and _near(wanted.value, read.value)
        and wanted.prefix == read.prefix
        and set(wanted.modifiers) == set(read.modifiers)
        and wanted.datums == read.datums
        and wanted.faces == read.faces
    )


def _same_size(wanted: PmiSize, read: PmiSize, *, occt: bool) -> bool:
    if wanted.kind != read.kind or wanted.faces != read.faces:
        return False
    if not occt:
        return (
            _near(wanted.nominal, read.nominal)
            and _near(wanted.lower, read.lower)
            and _near(wanted.upper, read.upper)
            and wanted.fit == read.fit
        )
    if wanted.lower is None or wanted.upper is None:
        return bool(wanted.fit) == bool(read.fit) and _near(wanted.nominal, read.nominal)
    if wanted.upper < 0.0:
        return True
    return (
        _near(wanted.nominal, read.nominal)
        and _near(-abs(wanted.lower), read.lower)
        and _near(wanted.upper, read.upper)
    )


def _near(a: float | None, b: float | None) -> bool:
    if a is None or b is None:
        return a is b
    return abs(a - b) <= 1e-9 * max(abs(a), abs(b), 1e-3)
