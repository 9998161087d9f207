# SPDX-License-Identifier: LGPL-2.1-or-later
"""The columns of the table that many parts make, a row a part."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from gpswb.core.invariance import CLASSES

FIGURES = (
    "area_accuracy",
    "face_accuracy",
    "region_f1",
    "judged_faces",
    "right_faces",
    "features",
    "found",
)
"""Of the validation, where there is a B-rep to judge by."""

COLUMNS: dict[str, type] = {
    "part": str,
    "status": str,
    "message": str,
    "seconds": float,
    "cpu_s": float,
    "memory_mb": float,
    "cached": bool,
    "bytes": int,
    "sha256": str,
    "unit": str,
    "density": str,
    "mesher": str,
    "vertices": int,
    "triangles": int,
    "sigma": float,
    "faces": int,
    "initial_regions": int,
    "regions": int,
    "undecided_regions": int,
    **{f"{name}_regions": int for name in CLASSES},
    **{f"{name}_area": float for name in CLASSES},
    **dict.fromkeys(FIGURES[:3], float),
    **dict.fromkeys(FIGURES[3:], int),
}
"""Names and types; lengths are mm, areas mm². A part that isn't done has its first eight only."""


def document_columns(document: Mapping[str, Any]) -> dict[str, Any]:
    """What the table says of a result document (schema ``gpswb-result/1``)."""
    regions, judged = document["regions"], document["validation"] or {}
    of_class = {name: [r["area"] for r in regions if r["class"] == name] for name in CLASSES}
    return {
        "sha256": document["source"]["sha256"],
        "unit": document["source"]["unit"],
        "density": document["mesh"]["density"],
        "mesher": document["mesh"]["mesher"],
        "vertices": document["mesh"]["vertices"],
        "triangles": document["mesh"]["triangles"],
        "sigma": document["settings"]["sigma"],
        "faces": len(document["faces"]),
        "initial_regions": document["initial_region_count"],
        "regions": len(regions),
        "undecided_regions": sum(bool(region["undecided"]) for region in regions),
        **{f"{name}_regions": len(areas) for name, areas in of_class.items()},
        **{f"{name}_area": sum(areas) for name, areas in of_class.items()},
        **{name: judged.get(name) for name in FIGURES},
    }
