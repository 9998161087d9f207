# SPDX-License-Identifier: LGPL-2.1-or-later
"""features.json, schema ``gpswb-features/1``: features, datum system, specifications."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from gpswb.gps.annotation import Annotation
from gpswb.gps.datum_system import DatumSystem
from gpswb.gps.explain import explain_datum_system
from gpswb.gps.gps_feature import GpsFeature
from gpswb.gps.review import Remark
from gpswb.gps.specifications import Specification
from gpswb.gps.specified import GeometricalTolerance, Specified

SCHEMA = "gpswb-features/1"


def features_document(
    annotation: Annotation, source: dict[str, str], remarks: Sequence[Remark] = ()
) -> dict[str, Any]:
    """Everything that was found, as plain values that JSON can hold.

    Args:
        source: path, sha256 and unit of the input.
        remarks: of the review of the PMI that the file holds.
    """
    needed, system = annotation.needed, annotation.system
    return {
        "schema": SCHEMA,
        "source": dict(source),
        "features": [_feature(f) for f in annotation.table.features],
        "datum_system": None if system is None else _system(system, needed),
        "datums_given": annotation.given,
        "suggestions": [_system(s.system, needed) for s in annotation.suggestions],
        "permitted": {
            str(id_): [_permitted(row) for row in rows]
            for id_, rows in annotation.permitted.items()
        },
        "specified": [_specified(each) for each in annotation.specified],
        "review": [
            {
                "subject": remark.subject,
                "features": list(remark.features),
                "class": remark.invariance_class,
                "text": remark.text,
            }
            for remark in remarks
        ],
    }


def write_features_json(path: Path, document: dict[str, Any]) -> None:
    """Write a document that `features_document` made.

    Raises:
        OSError: the file can't be written.
    """
    with path.open("w", encoding="utf-8") as file:
        json.dump(document, file, indent=1, ensure_ascii=False, allow_nan=False)
        file.write("\n")


def _feature(feature: GpsFeature) -> dict[str, Any]:
    size = feature.size
    return {
        "id": feature.id,
        "name": feature.name,
        "kind": feature.kind,
        "class": feature.invariance_class,
        "surface": feature.surface,
        "situation": {key: [_finite(v) for v in xs] for key, xs in feature.situation.items()},
        "intrinsic": {key: _finite(value) for key, value in feature.intrinsic.items()},
        "size": None if size is None else {"kind": size.kind, "value": _finite(size.value)},
        "material": feature.material,
        "derived": feature.derived,
        "arrangement": feature.arrangement,
        "interrupted": feature.interrupted,
        "sure": feature.sure,
        "members": list(feature.members),
        "regions": list(feature.regions),
        "faces": list(feature.faces),
        "area": _finite(feature.area),
        "body": feature.body,
    }


def _system(system: DatumSystem, needed: int) -> dict[str, Any]:
    return {
        "notation": system.notation,
        "degrees": system.degrees,
        "needed": needed,
        "complete": system.degrees >= needed,
        "redundant": list(system.redundant),
        "datums": [
            {
                "letter": datum.name,
                "features": [feature.id for feature in datum.features],
                "faces": [name for feature in datum.features for name in feature.faces],
                "translations": lock.translations,
                "rotations": lock.rotations,
            }
            for datum, lock in zip(system.datums, system.locks, strict=True)
        ],
        "explanation": explain_datum_system(system, needed),
    }


def _permitted(row: Specification) -> dict[str, Any]:
    return {
        "characteristic": row.characteristic,
        "symbol": row.symbol,
        "status": row.status,
        "reason": row.reason,
        "datum": row.datum,
        "datums": row.datums,
        "modifiers": list(row.modifiers),
        "combination": row.combination,
        "zone": row.zone,
        "prefix": row.prefix,
        "value": row.value,
    }


def _specified(each: Specified) -> dict[str, Any]:
    if isinstance(each, GeometricalTolerance):
        return {
            "feature": each.feature.id,
            "characteristic": each.characteristic,
            "value": each.value,
            "datums": "|".join(datum.notation for datum in each.datums),
            "modifiers": list(each.modifiers),
            "indication": each.frame,
            "remark": each.remark,
        }
    return {
        "feature": each.feature.id,
        "characteristic": "size",
        "upper": each.upper,
        "lower": each.lower,
        "fit": each.fit,
        "indication": each.frame,
        "remark": "",
    }


def _finite(value: float) -> float | None:
    """JSON has no NaN and no infinity: null stands for them; numpy scalars become Python's."""
    number = float(value)
    return number if math.isfinite(number) else None
