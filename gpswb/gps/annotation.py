# SPDX-License-Identifier: LGPL-2.1-or-later
"""What annotating a part comes to: features, datum system, suggestions, specifications."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from gpswb.errors import InputError
from gpswb.gps.datum_system import Datum, DatumSystem, datum_system, needed_degrees, parse_datums
from gpswb.gps.feature_table import FeatureTable
from gpswb.gps.gps_feature import UNRECOGNISED, GpsFeature
from gpswb.gps.on_faces import chosen_features
from gpswb.gps.specifications import Specification, permitted_specifications
from gpswb.gps.specified import Letters, SpecificationRow, Specified, specify
from gpswb.gps.suggest_datums import LETTERS, Suggestion, suggest_datums
from gpswb.sentence import Sentence


@dataclass(frozen=True, eq=False)
class Annotation:
    """A part's features with the datum system that its specifications are judged under.

    Args:
        table: the features.
        letters: datum features: the user's, else those of the best suggestion.
        given: whether the datums are the user's.
        system: the user's datum system, else the best suggestion; None for a part without features.
        needed: degrees of freedom that any datum system of the part can lock.
        suggestions: the best datum system and the runner-up.
        specified: the user's own specifications.
    """

    table: FeatureTable
    letters: Letters
    given: bool
    system: DatumSystem | None
    needed: int
    suggestions: tuple[Suggestion, ...]
    specified: tuple[Specified, ...]

    @cached_property
    def permitted(self) -> Mapping[int, tuple[Specification, ...]]:
        """By feature id, the 15 characteristics of ISO 1101 with status and reason."""
        return {f.id: permitted_specifications(f, self.system) for f in self.table.features}


def annotate(
    table: FeatureTable,
    datums: Sequence[tuple[str, str]] = (),
    rows: Sequence[SpecificationRow] = (),
    notation: str = "",
    taken: Collection[str] = (),
) -> Annotation:
    """Annotate a part.

    Args:
        table: its features.
        datums: letter and choice (``Face5+Face6``, ``Hole 1``) in order of precedence.
        rows: the user's specifications.
        notation: the datum system of these datums, as ``A|B-C``; each letter in turn if not given.
        taken: letters of datums that the part has already; suggestions use others.

    Raises:
        InputError: a choice or a row doesn't fit the part.
    """
    letters: dict[str, tuple[GpsFeature, ...]] = {}
    for letter, choice in datums:
        if letter in letters:
            raise InputError(Sentence("datum {letter} is given twice", letter=letter))
        try:
            letters[letter] = _datum_features(table, choice)
        except InputError as error:
            raise InputError(
                Sentence("datum {letter}: {why}", letter=letter, why=str(error))
            ) from None
    free = [letter for letter in LETTERS if letter not in taken]
    suggestions = suggest_datums(table.features, table.frame, letters=free)
    system = suggestions[0].system if suggestions else None
    if datums:
        own: Sequence[Datum] = [Datum(letter, features) for letter, features in letters.items()]
        if notation:
            own = parse_datums(notation, letters)
        system = datum_system(own, table.frame)
    elif system is not None:
        letters = {datum.name: datum.features for datum in system.datums}
    return Annotation(
        table=table,
        letters=letters,
        given=bool(datums),
        system=system,
        needed=_needed(system, table),
        suggestions=suggestions,
        specified=specify(rows, table, letters),
    )


def _datum_features(table: FeatureTable, choice: str) -> tuple[GpsFeature, ...]:
    features = chosen_features(table.features, choice)
    for feature in features:
        if not feature.recognised:
            raise InputError(
                Sentence("{feature} is {why}", feature=" ".join(feature.faces), why=UNRECOGNISED)
            )
    return features


def _needed(system: DatumSystem | None, table: FeatureTable) -> int:
    """Degrees that the bodies with datums let any system lock."""
    if system is None:
        return 0
    bodies = {feature.body for datum in system.datums for feature in datum.features}
    own = [f for f in table.integral if f.body in bodies]
    return needed_degrees(own or table.integral, table.frame)
