# SPDX-License-Identifier: LGPL-2.1-or-later
"""features.csv and specifications.csv: a row a feature, and a row a permitted specification."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from gpswb.gps.annotation import Annotation
from gpswb.gps.gps_feature import GpsFeature
from gpswb.io.csv_table import write_csv

FEATURES = (
    "id",
    "name",
    "kind",
    "class",
    "surface",
    "material",
    "size_kind",
    "size",
    "derived",
    "point",
    "direction",
    "intrinsic",
    "area_mm2",
    "faces",
    "members",
    "datum",
    "sure",
    "body",
)
PERMITTED = (
    "feature",
    "characteristic",
    "symbol",
    "status",
    "reason",
    "datum",
    "datums",
    "modifiers",
    "combination",
    "zone",
    "prefix",
    "value",
)


def write_features_csv(path: Path, annotation: Annotation) -> None:
    """Write the feature table: lengths in mm, lists separated by spaces.

    Raises:
        OSError: the file can't be written.
    """
    letters: dict[int, str] = {}
    for datum in annotation.system.datums if annotation.system is not None else ():
        for feature in datum.features:
            letters.setdefault(feature.id, datum.name)
    rows = [_feature(f, letters.get(f.id, "")) for f in annotation.table.features]
    write_csv(path, FEATURES, rows)


def write_specifications_csv(path: Path, annotation: Annotation) -> None:
    """Write every characteristic of every feature with its status and reason.

    Raises:
        OSError: the file can't be written.
    """
    rows = [
        (
            feature.name,
            row.characteristic,
            row.symbol,
            row.status,
            row.reason,
            row.datum,
            row.datums,
            " ".join(row.modifiers),
            row.combination,
            row.zone,
            row.prefix,
            row.value,
        )
        for feature in annotation.table.features
        for row in annotation.permitted[feature.id]
    ]
    write_csv(path, PERMITTED, rows)


def _feature(feature: GpsFeature, letter: str) -> Sequence[object]:
    situation = feature.situation
    direction = situation.get("normal") or situation.get("direction") or ()
    return (
        feature.id,
        feature.name,
        feature.kind,
        feature.invariance_class or "none",
        feature.surface,
        feature.material,
        feature.size.kind if feature.size else "",
        f"{feature.size.value:.9g}" if feature.size else "",
        feature.derived,
        _numbers(situation.get("point", ())),
        _numbers(direction),
        " ".join(f"{key}={value:.9g}" for key, value in feature.intrinsic.items()),
        f"{feature.area:.9g}",
        " ".join(feature.faces),
        " ".join(map(str, feature.members)),
        letter,
        "yes" if feature.sure else "no",
        feature.body,
    )


def _numbers(values: Iterable[float]) -> str:
    # Rounding leaves 1e-17 and -0, which say nothing.
    return " ".join(f"{round(value, 12) + 0.0:.9g}" for value in values)
