# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of recognised features and the validation, as lines of text."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from gpswb.batch.one_part import Outcome
    from gpswb.core.partition import Region
    from gpswb.validation.validate import Validation

MOST_ROWS = 60
"""A terminal's worth of rows; the files hold all of them."""

SHORT = {
    "radius": "R",
    "major_radius": "R",
    "minor_radius": "r",
    "half_angle_deg": "half angle",
    "lead": "lead",
}


def aligned(rows: Sequence[Sequence[str]], right: Iterable[int] = ()) -> list[str]:
    """Rows of cells as lines with aligned columns; the columns ``right`` to the right."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    flush = set(right)
    return [
        "  ".join(
            cell.rjust(width) if i in flush else cell.ljust(width)
            for i, (cell, width) in enumerate(zip(row, widths, strict=True))
        ).rstrip()
        for row in rows
    ]


def result_lines(outcome: Outcome) -> list[str]:
    """What `partition` prints: counts, features, validation."""
    solid, partition, validation = outcome.solid, outcome.partition, outcome.validation
    counts = {
        f"triangles ({solid.density}, {solid.mesher})": len(partition.mesh.triangles),
        "initial regions": partition.initial_region_count,
        "sharp-edge regions": partition.sharp_edge_regions,
        "regions": len(partition.regions),
    }
    lines = [
        f"{Path(solid.source).name}: " + ", ".join(f"{n} {what}" for what, n in counts.items()),
        *(f"note: {note}" for note in solid.notes),
        "",
    ]
    on_region: dict[int, list[str]] = {}
    for face in validation.faces if validation else ():
        for region_id in face.regions[:1]:
            on_region.setdefault(region_id, []).append(face.name)
    rows = [("region", "class", "surface", "area mm²", "characteristics", "faces")]
    largest = sorted(partition.regions, key=lambda r: -r.area)[:MOST_ROWS]
    rows += [
        (
            str(region.id),
            region.invariance_class + (" ?" if region.undecided else ""),
            region.surface,
            f"{region.area:.6g}",
            intrinsic_text(region),
            _names(on_region.get(region.id, [])),
        )
        for region in sorted(largest, key=lambda r: r.id)
    ]
    lines += aligned(rows, right=(0, 3))
    if len(partition.regions) > MOST_ROWS:
        lines.append(f"... and {len(partition.regions) - MOST_ROWS} smaller regions")
    return [*lines, "", *(validation_lines(validation) if validation else [])]


def intrinsic_text(region: Region) -> str:
    """Intrinsic characteristics on one line: ``R 5, half angle 30°``."""
    return ", ".join(
        f"{SHORT.get(name, name)} {value:.6g}" + ("°" if name.endswith("_deg") else "")
        for name, value in region.intrinsic.items()
    )


def validation_lines(validation: Validation) -> list[str]:
    """Validation against CAD: the figures and the faces that disagree."""
    area, face = validation.area_accuracy, validation.face_accuracy
    found, regions = f"{validation.found}/{validation.features}", validation.regions
    figures: Mapping[str, str] = {
        "area accuracy": percent(area),
        "face accuracy": f"{percent(face)}  {validation.right_faces}/{validation.judged_faces}",
        "region F1": f"{percent(validation.region_f1)}  {found} features in {regions} regions",
    }
    lines = ["validation against CAD"]
    lines += aligned([("  " + name, text) for name, text in figures.items()])
    wrong = [failure for failure in validation.failures if failure.wrong_class]
    if wrong:
        rows = [("  face", "is", "recognised", "surface", "triangles", "kind")]
        rows += [
            (
                "  " + f.face,
                f.true_class or "-",
                f.recognised or "-",
                f.surface,
                str(f.triangles),
                f.kind,
            )
            for f in wrong[:MOST_ROWS]
        ]
        lines += aligned(rows, right=(4,))
    if len(wrong) > MOST_ROWS:
        lines.append(f"  ... and {len(wrong) - MOST_ROWS} more faces")
    return lines


def percent(value: float | None) -> str:
    """A share as per cent; ``-`` where there is none. Rounded down, so that 100 % means all."""
    if value is None:
        return "-"
    return "100 %" if value >= 1 else f"{int(value * 10000) / 100:.2f} %"


def _names(names: list[str]) -> str:
    shown = " ".join(names[:6])
    return shown if len(names) <= 6 else f"{shown} +{len(names) - 6}"
