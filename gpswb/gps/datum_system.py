# SPDX-License-Identifier: LGPL-2.1-or-later
"""Datum systems A|B|C: what each letter locks and what stays free (ISO 5459; design, 7)."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gpswb.core.invariance import DIMENSION
from gpswb.core.mesh import FloatArray
from gpswb.errors import InputError
from gpswb.gps.gps_feature import GpsFeature
from gpswb.gps.invariance_of_union import invariance_of_union
from gpswb.gps.snapping import snap_directions
from gpswb.gps.tolerances import DEFAULT, Tolerances
from gpswb.gps.twists import (
    Frame,
    SituationFeature,
    as_datum,
    beyond,
    constraint_rows,
    locked_degrees,
    null_space,
    rotations_of,
    translations_of,
)
from gpswb.sentence import Sentence


@dataclass(frozen=True, eq=False)
class Datum:
    """A single datum ``A`` or common datum ``A-B``; with ``><`` it orients only."""

    name: str
    features: tuple[GpsFeature, ...]
    orientation_only: bool = False

    @property
    def situations(self) -> tuple[SituationFeature, ...]:
        """Of all its features, a thread as its pitch cylinder."""
        return tuple(as_datum(s) for feature in self.features for s in feature.situations)

    @property
    def notation(self) -> str:
        """As in the tolerance frame."""
        return self.name + ("><" if self.orientation_only else "")


@dataclass(frozen=True)
class Lock:
    """Degrees of freedom that a letter locks beyond the letters before it."""

    name: str
    translations: int
    rotations: int

    @property
    def degrees(self) -> int:
        """Both together."""
        return self.translations + self.rotations

    @property
    def redundant(self) -> bool:
        """Whether the system is the same without this letter."""
        return self.degrees == 0


@dataclass(frozen=True, eq=False)
class DatumSystem:
    """A datum system: its locks in order and the twists (6, k) that it leaves free.

    ``situations`` are the datums' situation features with snapped directions, ``rows`` (m, 6) their
    constraints.
    """

    datums: tuple[Datum, ...]
    locks: tuple[Lock, ...]
    situations: tuple[SituationFeature, ...]
    rows: FloatArray
    free: FloatArray
    frame: Frame
    tolerances: Tolerances

    @property
    def degrees(self) -> int:
        """Degrees of freedom locked, 0 to 6."""
        return 6 - int(self.free.shape[1])

    @property
    def redundant(self) -> tuple[str, ...]:
        """Names of the letters that lock nothing."""
        return tuple(lock.name for lock in self.locks if lock.redundant)

    @property
    def notation(self) -> str:
        """``A|B-C|D><``."""
        return "|".join(datum.notation for datum in self.datums)


def datum_system(
    datums: Sequence[Datum], frame: Frame, tolerances: Tolerances = DEFAULT
) -> DatumSystem:
    """Degrees of freedom as successive rank gains of the letters' constraint rows.

    Args:
        datums: in order of precedence; none gives the empty system, which locks nothing.
        frame: of the part.
    """
    snapped = snap_directions([s for d in datums for s in d.situations], tolerances.angle)
    rows = np.zeros((0, 6))
    free = np.eye(6)
    locks = []
    start = 0
    for datum in datums:
        stop = start + len(datum.situations)
        own = [constraint_rows(s, frame) for s in snapped[start:stop]]
        start = stop
        if datum.orientation_only:
            own = [orientation_rows(np.vstack(own), tolerances)]
        before = locked_degrees(free)
        rows = np.vstack([rows, *own])
        free = null_space(rows, tolerances.distance)
        after = locked_degrees(free)
        locks.append(Lock(datum.notation, after[0] - before[0], after[1] - before[1]))
    return DatumSystem(tuple(datums), tuple(locks), snapped, rows, free, frame, tolerances)


def orientation_rows(rows: FloatArray, tolerances: Tolerances) -> FloatArray:
    """Of constraints (m, 6) what they say of rotation alone: (r, 6) rows [e, 0]."""
    locked = beyond(rotations_of(null_space(rows, tolerances.distance)), np.eye(3))
    return np.hstack([locked, np.zeros_like(locked)])


@dataclass(frozen=True, eq=False)
class Freedom:
    """How a feature can still move under a datum system.

    ``translations`` (t, 3) and ``rotations`` (r, 3) are unit directions, mutually perpendicular;
    ``oriented`` says whether the system fixes the feature's orientation.
    """

    translations: FloatArray
    rotations: FloatArray
    oriented: bool

    @property
    def located(self) -> bool:
        """Fully located: rank [C_DS; C_F] = rank C_DS."""
        return not len(self.translations) and not len(self.rotations)


def freedom_left(system: DatumSystem, feature: GpsFeature) -> Freedom:
    """What stays free for a feature: the motions the system allows and that displace it."""
    tolerances = system.tolerances
    both = snap_directions([*system.situations, *feature.situations], tolerances.angle)
    own = np.vstack([constraint_rows(s, system.frame) for s in both[len(system.situations) :]])
    after = null_space(np.vstack([system.rows, own]), tolerances.distance)
    turned = orientation_rows(own, tolerances) @ system.free
    return Freedom(
        beyond(translations_of(after), translations_of(system.free)),
        beyond(rotations_of(after), rotations_of(system.free)),
        bool(np.all(np.abs(turned) <= tolerances.distance)),
    )


def part_situation(
    features: Iterable[GpsFeature], frame: Frame, tolerances: Tolerances = DEFAULT
) -> SituationFeature:
    """Union of all features of a part as datums: ``complete`` means 6 - its class's dimension.

    A feature whose class is in doubt, or a negligible one, can't take a symmetry from the part.
    """
    known = sorted((f for f in features if f.kind == "integral"), key=lambda f: -f.area)
    least = tolerances.negligible * sum(f.area for f in known)
    sure = [f for f in known if f.sure and f.area >= least] or known
    places = [as_datum(s) for feature in sure for s in feature.situations]
    return invariance_of_union(places, frame, tolerances)


def needed_degrees(
    features: Iterable[GpsFeature], frame: Frame, tolerances: Tolerances = DEFAULT
) -> int:
    """Degrees of freedom that any datum system can lock of the part with these features."""
    return 6 - DIMENSION[part_situation(features, frame, tolerances).invariance_class]


_DATUM = re.compile(r"([A-Z]{1,3}(?:-[A-Z]{1,3})*)(><)?")


def parse_datums(
    text: str, letters: Mapping[str, GpsFeature | tuple[GpsFeature, ...]]
) -> tuple[Datum, ...]:
    """Datums of a notation as ``A|B-C|D><``; a letter stands for one feature or several.

    Raises:
        InputError: the text isn't a datum system, or names a letter that is no datum.
    """
    datums = []
    used: set[str] = set()
    for part in text.split("|"):
        match = _DATUM.fullmatch(part.strip())
        if match is None:
            raise InputError(
                Sentence(
                    "{part!r} in {text!r} is no datum; write A|B-C|D><",
                    part=part.strip(),
                    text=text,
                )
            )
        names = match[1].split("-")
        for name in names:
            if name not in letters:
                raise InputError(
                    Sentence(
                        "datum {name} in {text!r} isn't assigned to a feature", name=name, text=text
                    )
                )
            if name in used:
                raise InputError(
                    Sentence("datum {name} stands twice in {text!r}", name=name, text=text)
                )
            used.add(name)
        meant = [letters[name] for name in names]
        features = [f for m in meant for f in (m if isinstance(m, tuple) else (m,))]
        datums.append(Datum(match[1], tuple(features), bool(match[2])))
    return tuple(datums)
