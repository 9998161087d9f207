# SPDX-License-Identifier: LGPL-2.1-or-later
"""comparison.json and comparison.csv: a scan against its nominal part, a row a feature."""

from __future__ import annotations

import csv
import json
from dataclasses import asdict
from pathlib import Path
from typing import Any

from gpswb.cad.solid import Solid
from gpswb.core.partition import Partition
from gpswb.io.result_json import finite
from gpswb.validation.alignment import Alignment
from gpswb.validation.comparison import Comparison

SCHEMA = "gpswb-comparison/1"

COLUMNS = (
    "faces", "nominal_class", "scan_class", "kind", "points", "extraction", "form",
    "least_squares", "minimax", "roundness_least_squares", "roundness_minimax", "sections",
    "profile", "mean", "rms", "radius", "nominal_radius", "half_angle_deg",
    "nominal_half_angle_deg", "major_radius", "nominal_major_radius", "minor_radius",
    "nominal_minor_radius", "regions",
)  # fmt: skip


def comparison_document(
    scan: Solid,
    part: Solid,
    partition: Partition,
    alignment: Alignment | None,
    comparison: Comparison,
) -> dict[str, Any]:
    """Everything a comparison says, as plain values that JSON can hold; lengths in mm."""
    document = {
        "schema": SCHEMA,
        "scan": {"path": scan.source, "sha256": scan.sha256, "unit": scan.unit},
        "nominal": {"path": part.source, "sha256": part.sha256, "unit": part.unit},
        "settings": {"mode": partition.mode, "sigma": partition.sigma, "density": part.density},
        "notes": [*scan.notes, *(f"nominal part: {note}" for note in part.notes)],
        "alignment": alignment
        and {
            "transform": alignment.transform.tolist(),
            "paired": alignment.paired,
        },
        "vertices": len(partition.mesh.vertices),
        "far": int((comparison.face < 0).sum()),
        "rms": comparison.rms,
        "extracted": int(comparison.extracted.sum()),
        "features": [
            {**asdict(row), "faces": list(row.faces), "regions": list(row.regions)}
            for row in comparison.features
        ],
    }
    plain: dict[str, Any] = finite(document)
    return plain


def write_comparison(directory: Path, document: dict[str, Any]) -> list[str]:
    """Write both files; their names.

    Raises:
        OSError: a file can't be written.
    """
    text = json.dumps(document, indent=1, ensure_ascii=False, allow_nan=False)
    (directory / "comparison.json").write_text(text + "\n", encoding="utf-8")
    with (directory / "comparison.csv").open("w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, COLUMNS, extrasaction="ignore", lineterminator="\n")
        table.writeheader()
        for row in document["features"]:
            listed = {key: " ".join(map(str, row[key])) for key in ("faces", "regions")}
            table.writerow({**row, **row["intrinsic"], **listed})
    return ["comparison.json", "comparison.csv"]
