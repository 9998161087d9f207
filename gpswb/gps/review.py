# SPDX-License-Identifier: LGPL-2.1-or-later
"""Datums and tolerances that a file holds against the recognised features: information."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from gpswb.cad.pmi import Pmi, PmiDatum, PmiSize, PmiTolerance
from gpswb.errors import InputError
from gpswb.gps.characteristics import RULES
from gpswb.gps.datum_system import Datum, DatumSystem, datum_system, freedom_left, parse_datums
from gpswb.gps.explain import explain_feature, explain_freedom
from gpswb.gps.feature_table import FeatureTable
from gpswb.gps.gps_feature import GpsFeature
from gpswb.gps.invariance_of_union import invariance_of_union
from gpswb.gps.on_faces import features_on
from gpswb.gps.specifications import permitted_specifications
from gpswb.gps.tolerances import DEFAULT
from gpswb.gps.twists import as_datum

_SIZE_TOLERANCE = 1e-3


@dataclass(frozen=True)
class Remark:
    """What a review says of one datum, tolerance or size.

    Args:
        subject: as ``datum A`` or ``position 0.1 | A | B``.
        features: names of the features that its faces make up; empty where they make up none.
        invariance_class: of their union; empty where there is none.
        text: what there is to say, one sentence; empty if all is as it should be.
    """

    subject: str
    features: tuple[str, ...]
    invariance_class: str
    text: str


def review(pmi: Pmi, table: FeatureTable) -> tuple[Remark, ...]:
    """Look through all datums, tolerances and sizes of a file.

    Nothing is an error: a drawing may mean more than its semantic PMI says.
    """
    letters: dict[str, tuple[GpsFeature, ...]] = {}
    remarks = []
    for datum in pmi.datums:
        features, _ = features_on(table.features, datum.faces)
        if features and all(feature.recognised for feature in features):
            letters[datum.letter] = features
        remarks.append(_datum(datum, features, table))
    remarks += [_tolerance(each, letters, table) for each in pmi.tolerances]
    remarks += [_size(each, table) for each in pmi.sizes]
    return tuple(remarks)


def _remark(
    subject: str, features: tuple[GpsFeature, ...], table: FeatureTable, texts: Iterable[str]
) -> Remark:
    union = class_of(features, table) if features else ""
    names = tuple(feature.name for feature in features)
    return Remark(subject, names, union, "; ".join(text for text in texts if text))


def class_of(features: tuple[GpsFeature, ...], table: FeatureTable) -> str:
    """Class of the union of features as a datum; a single feature's own."""
    if len(features) == 1:
        return features[0].invariance_class or "none"
    places = [as_datum(s) for feature in features for s in feature.situations]
    return invariance_of_union(places, table.frame, DEFAULT).invariance_class


def _datum(datum: PmiDatum, features: tuple[GpsFeature, ...], table: FeatureTable) -> Remark:
    subject = f"datum {datum.letter}"
    if not features:
        why = (
            "established by datum targets: the features under them aren't named"
            if datum.target
            else "no feature of the part resolves"
        )
        return Remark(subject, (), "", why)
    # A target is a portion of a feature by nature; a datum feature is all of it.
    said = "established by datum targets" if datum.target else _partial(datum.faces, features)
    return _remark(subject, features, table, [said])


def _partial(faces: Iterable[str], features: tuple[GpsFeature, ...]) -> str:
    """Whether faces are but a part of their features."""
    rest = [name for f in features for name in f.faces if name not in set(faces)]
    if not rest:
        return ""
    return f"the feature goes on over {' '.join(rest[:4])}{' ...' if len(rest) > 4 else ''}"


def _tolerance(
    tolerance: PmiTolerance, letters: Mapping[str, tuple[GpsFeature, ...]], table: FeatureTable
) -> Remark:
    subject = _indication(tolerance)
    features, _ = features_on(table.features, tolerance.faces)
    if not features:
        return Remark(subject, (), "", "it isn't on faces")
    texts = []
    conditional = {"Ⓜ", "Ⓛ"} & set(tolerance.modifiers)  # with these a zone may have no width
    if tolerance.value is None or tolerance.value < 0 or (tolerance.value == 0 and not conditional):
        texts.append("it has no value")
    system = None
    if tolerance.datums:
        system, lacking = _system(tolerance.datums, letters, table)
        if lacking:
            texts.append(lacking)
        elif system is not None and system.redundant:
            texts.append(f"{', '.join(system.redundant)} locks nothing more")
    if not tolerance.datums or system is not None:
        texts += _permission(tolerance, features, system)
    return _remark(subject, features, table, texts)


def _permission(
    tolerance: PmiTolerance, features: tuple[GpsFeature, ...], system: DatumSystem | None
) -> list[str]:
    """What ISO 1101 says of the characteristic on each of the features, and what stays free."""
    texts: dict[str, None] = {}
    for feature in features:
        for row in permitted_specifications(feature, system):
            if row.characteristic != tolerance.characteristic:
                continue
            if row.status == "not allowed":
                texts[f"not allowed: {row.reason}"] = None
        located = system is not None and tolerance.characteristic in RULES
        if located and feature.recognised and RULES[tolerance.characteristic].group == "location":  # type: ignore[index]
            assert system is not None
            freedom = freedom_left(system, feature)
            if not freedom.located:
                texts[f"{feature.name}: {explain_freedom(freedom)}"] = None
    return list(texts)


def _system(
    section: str, letters: Mapping[str, tuple[GpsFeature, ...]], table: FeatureTable
) -> tuple[DatumSystem | None, str]:
    """The datum system of a datum section, or why there is none."""
    for name in re.split(r"[|-]", section.replace("><", "")):
        if name not in letters:
            return None, f"datum {name} has no feature that resolves"
    try:
        datums: tuple[Datum, ...] = parse_datums(section, letters)
    except InputError as error:
        return None, str(error)
    return datum_system(datums, table.frame), ""


def _size(size: PmiSize, table: FeatureTable) -> Remark:
    subject = f"{size.kind} {_number(size.nominal)}"
    if size.fit:
        subject += f" {size.fit}"
    elif size.lower is not None and size.upper is not None:
        subject += f" {size.upper:+g}/{size.lower:+g}"
    features, _ = features_on(table.features, size.faces)
    if not features:
        return Remark(subject, (), "", "it isn't on faces")
    texts = []
    if size.kind == "diameter" and size.nominal is not None:
        for feature in features:
            model = feature.size
            if model is not None and abs(model.value - size.nominal) > _SIZE_TOLERANCE:
                texts.append(f"the model has {explain_feature(feature)}")
    return _remark(subject, features, table, texts)


def _indication(tolerance: PmiTolerance) -> str:
    rule = RULES.get(tolerance.characteristic)  # type: ignore[call-overload]
    words = [rule.symbol if rule else "", tolerance.characteristic or "tolerance"]
    words += [tolerance.prefix + _number(tolerance.value), *tolerance.modifiers]
    cells = [" ".join(word for word in words if word), *tolerance.datums.split("|")]
    return " | ".join(cell for cell in cells if cell)


def _number(value: float | None) -> str:
    return "?" if value is None else f"{value:.6g}"
