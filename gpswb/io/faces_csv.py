# SPDX-License-Identifier: LGPL-2.1-or-later
"""faces.csv: a row a B-rep face."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from gpswb.io.csv_table import write_csv
from gpswb.validation.face_result import FaceResult

COLUMNS = (
    "face",
    "class",
    "true_class",
    "agrees",
    "surface",
    "area_mm2",
    "share",
    "triangles",
    "regions",
    "undecided",
    "truth_disputed",
)


def write_faces(path: Path, faces: Sequence[FaceResult]) -> None:
    """Write one row a face, in FreeCAD's order.

    Raises:
        OSError: the file can't be written.
    """
    write_csv(path, COLUMNS, map(_row, faces))


def _row(face: FaceResult) -> tuple[object, ...]:
    return (
        face.name,
        face.invariance_class,
        face.true_class,
        "yes" if face.agrees else "no" if face.disagrees else "",
        face.surface,
        f"{face.area:.9g}",
        f"{face.share:.6f}",
        face.triangles,
        " ".join(map(str, face.regions)),
        " ".join(face.undecided),
        "yes" if face.ambiguous else "no",
    )
