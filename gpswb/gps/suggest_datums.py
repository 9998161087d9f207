# SPDX-License-Identifier: LGPL-2.1-or-later
"""Suggest a complete datum system for a part, and the runner-up (design, 7)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gpswb.gps.datum_system import Datum, DatumSystem, datum_system, needed_degrees
from gpswb.gps.gps_feature import GpsFeature
from gpswb.gps.tolerances import DEFAULT, Tolerances
from gpswb.gps.twists import Frame

_ALPHABET = "ABCDEFGHJKLMNPRSTUVWYZ"
LETTERS = (*_ALPHABET, *(2 * letter for letter in _ALPHABET))
"""Names of datums in their order: without I, O, Q, X, and doubled when they run out (ISO 5459)."""

_OBLIQUE = 0.2
"""A slope is a poor datum beside one that stands square, unless it is five times as large."""


@dataclass(frozen=True, eq=False)
class Suggestion:
    """A datum system with the features behind its letters.

    ``needed`` is 6 less the dimension of the part's own class: no system locks more.
    """

    system: DatumSystem
    needed: int

    @property
    def complete(self) -> bool:
        """Whether nothing stays free but what no datum of this part could lock."""
        return self.system.degrees >= self.needed


def suggest_datums(
    features: Sequence[GpsFeature],
    frame: Frame,
    tolerances: Tolerances = DEFAULT,
    letters: Sequence[str] = LETTERS,
) -> tuple[Suggestion, ...]:
    """The best complete datum system and, where there is one, the runner-up.

    Letter after letter takes the feature that scores most: its area times the degrees of freedom
    it adds, times how well its kind stands on a fixture or gauge, less if it stands oblique to the
    letters before it. So a plate gets planes 3+2+1, a
    flange its face, bore and a hole, a shaft its longest bearing and a shoulder, which stops at 5.
    No letter is without gain. Of several bodies the one with the largest surface gets the datums:
    a datum system belongs to one workpiece.

    Args:
        features: integral features and compounds of the part.
        frame: of the part.
        letters: names for the datums, at least six.

    Returns:
        None, one or two suggestions; the runner-up doesn't use the first one's primary datum, or if
        that isn't possible one of its others.
    """
    candidates = [f for f in features if f.kind in ("integral", "slot", "rib") and f.sure]
    areas: dict[int, float] = {}
    for feature in candidates:
        if feature.kind == "integral":
            areas[feature.body] = areas.get(feature.body, 0.0) + feature.area
    if not areas:
        return ()
    body = max(areas, key=lambda number: areas[number])
    candidates = [f for f in candidates if f.body == body]
    needed = needed_degrees(candidates, frame, tolerances)
    best = _greedy(candidates, needed, frame, tolerances, letters)
    suggestions = [Suggestion(best, needed)]
    for datum in best.datums:
        others = [f for f in candidates if f is not datum.features[0]]
        second = Suggestion(_greedy(others, needed, frame, tolerances, letters), needed)
        if second.complete:
            suggestions.append(second)
            break
    return tuple(suggestions)


def _greedy(
    candidates: Sequence[GpsFeature],
    needed: int,
    frame: Frame,
    tolerances: Tolerances,
    letters: Sequence[str],
) -> DatumSystem:
    by_worth = sorted(candidates, key=lambda f: -f.area * _fitness(f))
    system = datum_system((), frame, tolerances)
    while system.degrees < needed:
        best, most = None, 0.0
        for feature in by_worth:
            worth = feature.area * _fitness(feature)
            if worth * (needed - system.degrees) <= most:
                break
            datum = Datum(letters[len(system.datums)], (feature,))
            longer = datum_system((*system.datums, datum), frame, tolerances)
            score = worth * longer.locks[-1].degrees
            if _oblique(feature, system):
                score *= _OBLIQUE
            if score > most:
                best, most = longer, score
        if best is None:
            break
        system = best
    return system


def _oblique(feature: GpsFeature, system: DatumSystem) -> bool:
    """Whether its direction is neither along nor square to one of the system."""
    if not feature.place.directed:
        return False
    own, near = np.array(feature.place.direction), system.tolerances.angle
    for datum in system.situations:
        if datum.directed:
            along, across = (
                abs(own @ datum.direction),
                np.linalg.norm(np.cross(own, datum.direction)),
            )
            if min(along, float(across)) > np.sin(near):
                return True
    return False


def _fitness(feature: GpsFeature) -> float:
    """How well a kind of feature serves as a datum: planes, then sizes, then the rest."""
    if feature.kind != "integral":
        return 0.2
    if feature.surface == "plane":
        return 1.0
    if feature.of_linear_size:  # a lobe that goes half round is bad to chuck or to gauge
        return 0.5 if feature.whole else 0.15
    kind = feature.invariance_class or ""
    return {"revolute": 0.1, "prismatic": 0.02, "helical": 0.05}.get(kind, 0.01)
