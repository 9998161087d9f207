# SPDX-License-Identifier: LGPL-2.1-or-later
"""result.json, schema ``gpswb-result/1`` (design, section 10)."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from gpswb.cad.solid import Solid
from gpswb.core.partition import Partition, Region
from gpswb.validation.face_result import FaceResult
from gpswb.validation.failures import Failure
from gpswb.validation.validate import Validation

SCHEMA = "gpswb-result/1"


def result_document(
    solid: Solid, partition: Partition, validation: Validation | None
) -> dict[str, Any]:
    """Everything a result says, as plain values that JSON can hold.

    ``faces`` is empty and ``validation`` null for a mesh input, which has no B-rep.
    """
    faces = validation.faces if validation else ()
    on_region: dict[int, list[str]] = {}
    for face in faces:
        for region in face.regions:
            on_region.setdefault(region, []).append(face.name)
    document: dict[str, Any] = {
        "schema": SCHEMA,
        "source": {"path": solid.source, "sha256": solid.sha256, "unit": solid.unit},
        "settings": {"mode": partition.mode, "method": partition.method, "sigma": partition.sigma},
        "mesh": {
            "vertices": len(partition.mesh.vertices),
            "triangles": len(partition.mesh.triangles),
            "density": solid.density,
            "mesher": solid.mesher,
        },
        "timings_s": {**solid.timings, **partition.timings},
        "notes": list(solid.notes),
        "regions": [region_entry(r, on_region.get(r.id, [])) for r in partition.regions],
        "initial_region_count": partition.initial_region_count,
        "sharp_edge_regions": partition.sharp_edge_regions,
        "faces": [face_entry(face) for face in faces],
        "validation": _validation(validation) if validation else None,
    }
    plain: dict[str, Any] = finite(document)
    return plain


def write_result(path: Path, document: dict[str, Any]) -> None:
    """Write a document that `result_document` made.

    Raises:
        OSError: the file can't be written.
    """
    with path.open("w", encoding="utf-8") as file:
        json.dump(document, file, indent=1, ensure_ascii=False, allow_nan=False)
        file.write("\n")


def region_entry(region: Region, faces: Sequence[str]) -> dict[str, Any]:
    """A region as it stands in ``regions``; numbers may not be finite yet."""
    return {
        "id": region.id,
        "class": region.invariance_class,
        "surface": region.surface,
        "area": region.area,
        "triangles": region.triangles,
        "faces": list(faces),
        "initial_regions": region.initial_regions,
        "situation": {name: list(value) for name, value in region.situation.items()},
        "intrinsic": dict(region.intrinsic),
        "residual": region.residual,
        "margin": region.margin,
        "undecided": list(region.undecided),
        "log_likelihood": dict(region.log_likelihood),
    }


def face_entry(face: FaceResult) -> dict[str, Any]:
    """A face as it stands in ``faces``."""
    return {
        "name": face.name,
        "class": face.invariance_class,
        "true_class": face.true_class,
        "surface": face.surface,
        "area": face.area,
        "share": face.share,
        "triangles": face.triangles,
        "regions": list(face.regions),
        "ambiguous": face.ambiguous,
        "undecided": list(face.undecided),
        "solid": face.solid,
    }


def _validation(validation: Validation) -> dict[str, Any]:
    return {
        "area_accuracy": validation.area_accuracy,
        "face_accuracy": validation.face_accuracy,
        "region_f1": validation.region_f1,
        "confusion": {true: dict(row) for true, row in validation.confusion.items()},
        "judged_area": validation.judged_area,
        "right_area": validation.right_area,
        "judged_faces": validation.judged_faces,
        "right_faces": validation.right_faces,
        "features": validation.features,
        "regions": validation.regions,
        "found": validation.found,
        "over_segmented": validation.over_segmented,
        "under_segmented": validation.under_segmented,
        "failures": [_failure(failure) for failure in validation.failures],
    }


def _failure(failure: Failure) -> dict[str, Any]:
    return {
        "face": failure.face,
        "kind": failure.kind,
        "wrong_class": failure.wrong_class,
        "true_class": failure.true_class,
        "class": failure.recognised,
        "surface": failure.surface,
        "area": failure.area,
        "triangles": failure.triangles,
        "iou": failure.iou,
        "region": failure.region,
    }


def finite(value: Any) -> Any:
    """A value that JSON can hold: null for what is not finite, Python's numbers for numpy's."""
    if isinstance(value, dict):
        return {str(key): finite(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [finite(item) for item in value]
    if value is None or isinstance(value, str | bool | int):
        return value
    number = float(value)
    if not math.isfinite(number):
        return None
    return int(value) if hasattr(value, "dtype") and value.dtype.kind in "iu" else number
