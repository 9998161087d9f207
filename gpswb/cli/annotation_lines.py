# SPDX-License-Identifier: LGPL-2.1-or-later
"""Feature table, datum systems and permitted specifications as lines of text."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from gpswb.batch.messages import one_line
from gpswb.cad.solid import Solid
from gpswb.cli.table import MOST_ROWS, aligned
from gpswb.gps.annotation import Annotation
from gpswb.gps.explain import explain_datum_system
from gpswb.gps.gps_feature import GpsFeature
from gpswb.gps.review import Remark

_SIGN = {"diameter": "Ø", "spherical diameter": "SØ", "width": "width ", "cone angle": "angle "}
_MOST_FACES = 6


def annotation_lines(solid: Solid, annotation: Annotation) -> list[str]:
    """What `annotate` prints."""
    table = annotation.table
    counts = f"{len(table.integral)} features, {len(table.compounds)} compounds"
    lines = [
        f"{one_line(Path(solid.source).name)}: {counts}",
        *(f"note: {one_line(note)}" for note in solid.notes),
        "",
        *_feature_lines(annotation),
        "",
        *_datum_lines(annotation),
        "",
        *_permitted_lines(annotation),
    ]
    if annotation.specified:
        lines += ["", "specified"]
        rows = [
            ("  " + each.feature.name, each.frame, getattr(each, "remark", ""))
            for each in annotation.specified
        ]
        lines += aligned(rows)
    return lines


def review_lines(remarks: Sequence[Remark]) -> list[str]:
    """What the review says of the PMI that the file holds."""
    if not remarks:
        return []
    rows = [("  datum or tolerance", "on", "class", "remark")]
    rows += [
        (
            "  " + one_line(remark.subject),
            _names(remark.features),
            remark.invariance_class,
            one_line(remark.text),
        )
        for remark in remarks
    ]
    return ["", "PMI in the file, reviewed", *aligned(rows)]


def size_text(feature: GpsFeature) -> str:
    """Size of a feature on one line: ``4 × Ø6``, ``width 10``; empty without a size."""
    if feature.size is None:
        return ""
    count = f"{int(feature.intrinsic['count'])} × " if "count" in feature.intrinsic else ""
    degrees = "" if feature.size.linear else "°"
    return f"{count}{_SIGN[feature.size.kind]}{feature.size.value:.6g}{degrees}"


def _feature_lines(annotation: Annotation) -> list[str]:
    letters = {
        feature.id: datum.name
        for datum in (annotation.system.datums if annotation.system else ())
        for feature in datum.features
    }
    rows = [("feature", "class", "size", "side", "derived", "area mm²", "datum", "faces")]
    features = annotation.table.features
    several = len({feature.body for feature in features}) > 1
    shown = [*annotation.table.integral[:MOST_ROWS], *annotation.table.compounds[:MOST_ROWS]]
    rows += [
        (
            feature.name,
            _class(feature),
            size_text(feature),
            "" if feature.material == "neither" else feature.material,
            feature.derived,
            f"{feature.area:.6g}",
            letters.get(feature.id, ""),
            _names(feature.faces) + (f"  ({_body(feature)})" if several else ""),
        )
        for feature in shown
    ]
    more = len(features) - len(shown)
    return aligned(rows, right=(5,)) + ([f"... and {more} more"] if more else [])


def _class(feature: GpsFeature) -> str:
    if feature.invariance_class is None:
        return "none"
    return feature.invariance_class + ("" if feature.sure else " ?")


def _datum_lines(annotation: Annotation) -> list[str]:
    lines = []
    if annotation.given and annotation.system is not None:
        lines.append(f"datum system {annotation.system.notation}")
        lines += _indented(explain_datum_system(annotation.system, annotation.needed))
    for word, suggestion in zip(("suggested", "runner-up"), annotation.suggestions, strict=False):
        lines.append(f"{word} datum system {suggestion.system.notation}")
        lines += _indented(explain_datum_system(suggestion.system, suggestion.needed))
    return lines or ["no feature can serve as a datum"]


def _permitted_lines(annotation: Annotation) -> list[str]:
    notation = annotation.system.notation if annotation.system else "no datum system"
    lines = [f"permitted specifications ({notation}); values are yours to give"]
    rows = [("  feature", "recommended", "also allowed")]
    shown = [*annotation.table.integral[:MOST_ROWS], *annotation.table.compounds[:MOST_ROWS]]
    for feature in shown:
        permitted = annotation.permitted[feature.id]
        best = [
            f"{s.symbol} {s.prefix}{s.value}" + (f" | {s.datums}" if s.datums else "")
            for s in permitted
            if s.status == "recommended"
        ]
        also = [s.symbol for s in permitted if s.status == "allowed"]
        rows.append(("  " + feature.name, "  ".join(best), " ".join(also)))
    more = len(annotation.table.features) - len(shown)
    return lines + aligned(rows) + ([f"  ... and {more} more"] if more else [])


def _indented(text: str) -> list[str]:
    return [f"  {line}" for line in text.splitlines()]


def _body(feature: GpsFeature) -> str:
    return f"solid {feature.body + 1}" if feature.body >= 0 else "no solid"


def _names(names: tuple[str, ...]) -> str:
    shown = " ".join(names[:_MOST_FACES])
    return shown if len(names) <= _MOST_FACES else f"{shown} +{len(names) - _MOST_FACES}"
