# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of what went wrong: the worst parts, and close-ups of each kind of failure."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from gpswb.core.mesh import Mesh
from gpswb.report.picture import Labelled, close_up, whole_part
from gpswb.report.png import png_bytes
from gpswb.report.static_page import Figure
from gpswb.validation.corpus import PartRow, failures_by_kind, worst_first


def draw_worst_parts(draft: Path, rows: Sequence[PartRow], most: int) -> list[Figure]:
    """A picture of each of the ``most`` worst parts, written in ``draft/pictures`` too."""
    figures = []
    for row in worst_first(rows)[:most]:
        faces = row.document["faces"]
        wrong = [i for i, f in enumerate(faces) if f["true_class"] not in (None, f["class"])]
        png = png_bytes(whole_part(_labelled(draft, row), np.array(wrong, dtype=np.int64)))
        (draft / "pictures" / f"{row.name}.png").write_bytes(png)
        counts = f"{row.figures['right_faces']} of {row.figures['judged_faces']} faces right"
        figures.append(Figure(f"{row.name}: {counts}", png))
    return figures


def draw_kinds(draft: Path, rows: Sequence[PartRow]) -> list[Figure]:
    """Close-ups of the examples of each kind of failure, written in ``draft/pictures`` too."""
    by_name = {row.name: row for row in rows}
    figures = []
    for kind in failures_by_kind(rows):
        for number, example in enumerate(kind.examples, 1):
            row = by_name[example.part]
            names = [face["name"] for face in row.document["faces"]]
            part, face = _labelled(draft, row), names.index(example.face)
            if not (part.face == face).any():
                continue
            png = png_bytes(close_up(part, face))
            file = f"{kind.kind.replace(' ', '-')}-{number}.png"
            (draft / "pictures" / file).write_bytes(png)
            figures.append(Figure(f"{kind.kind}: {example}", png))
    return figures


def _labelled(draft: Path, row: PartRow) -> Labelled:
    with np.load(draft / "parts" / row.name / "labels.npz", allow_pickle=False) as labels:
        return Labelled(
            mesh=Mesh(labels["vertices"], labels["triangles"]),
            face=labels["face"],
            truth=[face["true_class"] for face in row.document["faces"]],
            label=labels["class"],
            region=labels["region"],
        )
