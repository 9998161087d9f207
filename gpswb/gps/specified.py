# SPDX-License-Identifier: LGPL-2.1-or-later
"""Specifications with the user's own values, tied to features and datums of a part."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches

from gpswb.errors import InputError
from gpswb.gps.characteristics import RULES, Characteristic
from gpswb.gps.datum_system import Datum, datum_system, parse_datums
from gpswb.gps.feature_table import FeatureTable
from gpswb.gps.gps_feature import UNRECOGNISED, GpsFeature
from gpswb.gps.on_faces import chosen_features, with_hint
from gpswb.gps.specifications import permitted_specifications
from gpswb.sentence import Sentence, joined

Letters = Mapping[str, tuple[GpsFeature, ...]]
"""The features behind each datum letter, in order of precedence."""


@dataclass(frozen=True)
class SpecificationRow:
    """One row of the user's table, as read: nothing is resolved yet.

    Args:
        feature: name in the feature table, or faces as ``Face5+Face6``.
        characteristic: of ISO 1101, or ``size``.
        value: width or diameter of the tolerance zone, mm; None for ``size``.
        datums: as ``A|B-C``, empty for none.
        modifiers: of Ⓜ Ⓛ Ⓡ.
        upper, lower: signed deviations of a size, mm (degrees for an angle).
        fit: tolerance class of a size (``H7``), instead of deviations.
    """

    feature: str
    characteristic: str
    value: float | None = None
    datums: str = ""
    modifiers: tuple[str, ...] = ()
    upper: float | None = None
    lower: float | None = None
    fit: str = ""


@dataclass(frozen=True, eq=False)
class GeometricalTolerance:
    """One characteristic of one feature; ``remark`` where ISO 1101 speaks against it.

    ``modifiers`` are those of the row, after CZ where the feature is a group. ``prefix`` stands
    before the value: nothing, Ø or SØ. A value of None is still open: "?".
    """

    feature: GpsFeature
    characteristic: Characteristic
    value: float | None
    datums: tuple[Datum, ...]
    modifiers: tuple[str, ...]
    prefix: str
    remark: str = ""

    @property
    def open(self) -> bool:
        """Whether the value is still to be given."""
        return self.value is None

    @property
    def cells(self) -> tuple[str, ...]:
        """The tolerance indicator: what stands beside it, symbol, value with modifiers, datums."""
        value = self.prefix + ("?" if self.value is None else f"{self.value:g}")
        datums = (datum.notation for datum in self.datums)
        symbol = RULES[self.characteristic].symbol
        return (*_beside(self.feature), symbol, " ".join([value, *self.modifiers]), *datums)

    @property
    def frame(self) -> str:
        """The tolerance indicator on one line: ``⌖ Ø0.1 Ⓜ | A | B``."""
        *beside, symbol, value = self.cells[: -len(self.datums) or None]
        cells = [value, *(datum.notation for datum in self.datums)]
        return " ".join([*beside, symbol, " | ".join(cells)])


@dataclass(frozen=True, eq=False)
class SizeTolerance:
    """Signed deviations (mm, degrees for an angle) or a tolerance class for a feature's size."""

    feature: GpsFeature
    lower: float | None
    upper: float | None
    fit: str = ""

    @property
    def open(self) -> bool:
        """Whether the deviations are still to be given."""
        return not self.fit and (self.upper is None or self.lower is None)

    @property
    def cells(self) -> tuple[str, ...]:
        """A size stands in no frame: one text."""
        return (self.frame,)

    @property
    def frame(self) -> str:
        """As ``Ø10 +0.02/-0.1``, ``Ø10 H7``, or for a pattern ``4× Ø10 H7``."""
        size = self.feature.size
        assert size is not None
        sign = {"diameter": "Ø", "spherical diameter": "SØ"}.get(size.kind, "")
        said = "?" if self.open else self.fit or f"{self.upper:+g}/{self.lower:+g}"
        return " ".join([*_beside(self.feature), f"{sign}{size.value:.6g}", said])


Specified = GeometricalTolerance | SizeTolerance


def specify(
    rows: Sequence[SpecificationRow], table: FeatureTable, letters: Letters
) -> tuple[Specified, ...]:
    """Tie the user's rows to features and datums.

    Raises:
        InputError: a row names what isn't there, or lacks what its characteristic needs.
    """
    return tuple(_specify(row, table, letters) for row in rows)


def _beside(feature: GpsFeature) -> tuple[str, ...]:
    """What stands beside the frame: ``4×`` of a pattern of four (ISO 5458), ``UF`` of surfaces
    apart that are taken as one (ISO 1101), nothing of any other feature."""
    if feature.interrupted:
        return ("UF",)
    return (f"{int(feature.intrinsic['count'])}×",) if "count" in feature.intrinsic else ()


def _specify(row: SpecificationRow, table: FeatureTable, letters: Letters) -> Specified:
    try:
        found = chosen_features(table.features, row.feature)
    except InputError as error:
        raise InputError(
            Sentence(
                "specification {characteristic}: {why}",
                characteristic=Sentence(row.characteristic),
                why=str(error),
            )
        ) from None
    if len(found) != 1:
        raise InputError(
            Sentence(
                "specification of {feature!r}: that is {names}; name one feature",
                feature=row.feature,
                names=joined(", ", [feature.name for feature in found]),
            )
        )
    feature = found[0]
    if not feature.recognised:
        raise _wrong(row, feature, UNRECOGNISED)
    if row.characteristic == "size":
        return _size_tolerance(row, feature)
    name = next((c for c in RULES if c == row.characteristic), None)
    if name is None:
        near = get_close_matches(row.characteristic, [*RULES, "size"], 1)
        said = Sentence(
            "{word!r} is no characteristic of ISO 1101, nor 'size'", word=row.characteristic
        )
        raise InputError(with_hint(said, near))
    zero = bool({"Ⓜ", "Ⓛ"} & set(row.modifiers))
    if row.value is not None and (row.value < 0 or (row.value == 0 and not zero)):
        if zero:
            raise _wrong(row, feature, Sentence("it needs a value of at least 0, or none"))
        raise _wrong(row, feature, Sentence("it needs a value above 0, or none"))
    try:
        datums = parse_datums(row.datums, letters) if row.datums else ()
    except InputError as error:
        raise _wrong(row, feature, str(error)) from None
    if datums and RULES[name].group == "form":
        raise _wrong(row, feature, Sentence("a form tolerance takes no datum"))
    system = datum_system(datums, table.frame) if datums else None
    permitted = permitted_specifications(feature, system)
    rule = next(s for s in permitted if s.characteristic == name)
    return GeometricalTolerance(
        feature,
        name,
        row.value,
        datums,
        (*(("CZ",) if rule.combination == "CZ" else ()), *row.modifiers),
        # With a modifier it is the median line's, whose zone is a cylinder.
        "Ø" if name == "straightness" and row.modifiers else rule.prefix,
        rule.reason if rule.status == "not allowed" else _modifier_remark(row, rule.modifiers),
    )


def _wrong(row: SpecificationRow, feature: GpsFeature, why: str) -> InputError:
    by_name = row.feature.casefold() == feature.name.casefold()
    return InputError(
        Sentence(
            "{characteristic} of {feature!r}: {why}",
            characteristic=Sentence(row.characteristic),
            feature=feature.name if by_name else row.feature,
            why=why,
        )
    )


def _modifier_remark(row: SpecificationRow, permitted: tuple[str, ...]) -> str:
    given = row.modifiers
    wrong = [m for m in given if m not in permitted]
    if wrong:
        return Sentence("{modifier} doesn't go with it (ISO 2692)", modifier=wrong[0])
    if "Ⓜ" in given and "Ⓛ" in given:
        return Sentence("Ⓜ and Ⓛ exclude each other (ISO 2692)")
    if "Ⓡ" in given and len(set(given)) == 1:
        return Sentence("Ⓡ stands after Ⓜ or Ⓛ only (ISO 2692)")
    return ""


def _size_tolerance(row: SpecificationRow, feature: GpsFeature) -> SizeTolerance:
    if feature.size is None:
        raise _wrong(
            row, feature, Sentence("{feature} is no feature of size", feature=feature.name)
        )
    if row.fit:
        if not feature.size.linear:
            raise _wrong(row, feature, Sentence("a tolerance class is for linear sizes"))
        hole = row.fit[0].isupper()
        if feature.material == ("external" if hole else "internal"):
            values = {"fit": row.fit, "feature": feature.name}
            if hole:
                said = Sentence(
                    "{fit} is a class of holes and slots, {feature} is external", **values
                )
            else:
                said = Sentence(
                    "{fit} is a class of shafts and ribs, {feature} is internal", **values
                )
            raise _wrong(row, feature, said)
        return SizeTolerance(feature, None, None, row.fit)
    if (row.upper is None) != (row.lower is None):
        raise _wrong(row, feature, Sentence("it needs both deviations, or none"))
    if row.upper is not None and row.lower is not None and row.lower > row.upper:
        raise _wrong(row, feature, Sentence("the lower deviation is above the upper one"))
    return SizeTolerance(feature, row.lower, row.upper)
