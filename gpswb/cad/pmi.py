# SPDX-License-Identifier: LGPL-2.1-or-later
"""Product and manufacturing information that a file holds: datums, tolerances, sizes."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class PmiDatum:
    """A datum letter and the faces of its datum features (empty where it has none that resolve).

    ``target``: it is established from datum targets.
    """

    letter: str
    faces: tuple[str, ...]
    target: bool = False


@dataclass(frozen=True)
class PmiTolerance:
    """A geometrical tolerance.

    Args:
        name: as the file calls it.
        characteristic: name in ISO 1101, empty for none of them.
        value: width or diameter of its zone, mm; None if it can't be read.
        prefix: Ø, SØ or nothing.
        modifiers: CZ Ⓜ Ⓛ Ⓡ; what the file says beyond these in its own words.
        datums: as ``A|B-C``.
        faces: of the toleranced feature; empty where it isn't made of faces.
    """

    name: str
    characteristic: str
    value: float | None
    prefix: str
    modifiers: tuple[str, ...]
    datums: str
    faces: tuple[str, ...]


@dataclass(frozen=True)
class PmiSize:
    """A size with its tolerance.

    Args:
        kind: diameter, radius, thickness, angle ... as the file calls it.
        nominal: mm or degrees; None if it isn't given.
        lower, upper: signed deviations, mm or degrees; None without.
        fit: tolerance class as ``H7``, empty without.
        faces: of the feature of size.
    """

    kind: str
    nominal: float | None
    lower: float | None
    upper: float | None
    fit: str
    faces: tuple[str, ...]


@dataclass(frozen=True)
class Pmi:
    """All that was read; faces are named as FreeCAD does, in TopExp order."""

    datums: tuple[PmiDatum, ...]
    tolerances: tuple[PmiTolerance, ...]
    sizes: tuple[PmiSize, ...]

    def __bool__(self) -> bool:
        return bool(self.datums or self.tolerances or self.sizes)


def in_order(faces: set[str]) -> tuple[str, ...]:
    """Names of faces by number: Face2 before Face10."""
    return tuple(sorted(faces, key=lambda name: (len(name), name)))
