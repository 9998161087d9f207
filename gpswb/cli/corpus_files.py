# SPDX-License-Identifier: LGPL-2.1-or-later
"""What `validate` writes and prints."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Sequence
from pathlib import Path

from gpswb.batch.settings import Settings
from gpswb.cli.corpus_pictures import draw_kinds, draw_worst_parts
from gpswb.cli.table import aligned
from gpswb.errors import OutputError
from gpswb.io.csv_table import write_csv
from gpswb.io.whole import write_whole
from gpswb.report.corpus_markdown import corpus_section, renew_section
from gpswb.report.corpus_page import corpus_page
from gpswb.report.corpus_tables import counts_sentence, figures_table, kinds_table
from gpswb.validation.corpus import (
    RECALL_TRIANGLES,
    PartRow,
    failures_by_kind,
    pooled_confusion,
    recall,
    totals,
)

SCHEMA = "gpswb-summary/1"

PART_COLUMNS = (
    "area_accuracy",
    "face_accuracy",
    "region_f1",
    "judged_faces",
    "right_faces",
    "features",
    "regions",
    "found",
    "over_segmented",
    "under_segmented",
)


def write_corpus(
    draft: Path,
    rows: Sequence[PartRow],
    settings: Settings,
    title: str,
    command: str,
    pictures: int,
) -> list[str]:
    """Write summary.csv, faces.csv, summary.json, pictures and report.html; their names.

    Raises:
        OSError: a file can't be written.
    """
    _write_parts(draft / "summary.csv", rows)
    _write_failures(draft / "faces.csv", rows)
    summary = {
        "schema": SCHEMA,
        "title": title,
        "command": command,
        "settings": {**dataclasses.asdict(settings), "density": str(settings.density)},
        "totals": dataclasses.asdict(totals(rows)),
        "confusion": pooled_confusion(rows),
        "recall": recall(rows, 0),
        f"recall_{RECALL_TRIANGLES}_triangles": recall(rows, RECALL_TRIANGLES),
        "failures_by_kind": [dataclasses.asdict(kind) for kind in failures_by_kind(rows)],
        "parts": [
            {
                "name": row.name,
                "status": row.status,
                "message": row.message,
                "seconds": round(row.seconds, 3),
                "mesh": row.document.get("mesh"),
                **{key: row.figures.get(key) for key in PART_COLUMNS},
            }
            for row in rows
        ],
    }
    text = json.dumps(summary, indent=1, ensure_ascii=False, allow_nan=False)
    (draft / "summary.json").write_text(text + "\n", encoding="utf-8")
    (draft / "pictures").mkdir()
    kinds = draw_kinds(draft, rows) if pictures else []
    page = corpus_page(rows, title, command, kinds, draw_worst_parts(draft, rows, pictures))
    (draft / "report.html").write_text(page, encoding="utf-8")
    return ["report.html", "summary.json", "summary.csv", "faces.csv", "pictures", "parts"]


def write_docs(path: Path, rows: Sequence[PartRow], title: str, command: str) -> None:
    """Renew the section ``title`` of a Markdown document, whole or not at all.

    Raises:
        OutputError: the document can't be read or written, or its markers do not pair.
    """
    write_whole(path, renew_section(_docs(path), title, corpus_section(rows, title, command)))


def check_docs(path: Path, title: str) -> None:
    """Find out before a long run what would keep `write_docs` from working after it.

    Raises:
        OutputError: the document can't be read, has no directory, or its markers do not pair.
    """
    renew_section(_docs(path), title, "")
    if not path.parent.is_dir():
        raise OutputError(f"can't write {path}: no such directory")


def _docs(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8") if path.exists() else "# Validation\n\n"
    except (OSError, UnicodeDecodeError) as error:
        raise OutputError(f"can't read {path}: {error}") from error


def summary_lines(rows: Sequence[PartRow]) -> list[str]:
    """What is printed: totals, failures by kind, files without a result."""
    figures, kinds = figures_table(rows), kinds_table(rows)
    lines = [f"{row.name}: {row.status}: {row.message}" for row in rows if row.status != "done"]
    lines.append(counts_sentence(rows))
    lines += aligned([figures.head, *figures.rows], right=(1, 2, 3))
    if kinds.rows:
        shown = (0, 2, 4, 5, 6, 7)
        head = ("failures by kind", "wrong", "area", "unmatched", "parts", "largest")
        short = [head, *(tuple(row[i] for i in shown) for row in kinds.rows)]
        lines += aligned(short, right=(1, 2, 3, 4))
    return lines


def _write_parts(path: Path, rows: Sequence[PartRow]) -> None:
    header = ("file", "status", "message", "seconds", "triangles", *PART_COLUMNS)
    write_csv(path, header, map(_part, rows))


def _part(row: PartRow) -> tuple[object, ...]:
    triangles = row.document["mesh"]["triangles"] if row.document else None
    figures = (row.figures.get(key) for key in PART_COLUMNS)
    return (row.name, row.status, row.message, f"{row.seconds:.2f}", triangles, *figures)


def _write_failures(path: Path, rows: Sequence[PartRow]) -> None:
    columns = ("face", "kind", "wrong_class", "true_class", "class", "surface", "area",
               "triangles", "iou", "region")  # fmt: skip
    failures = ((row.name, f) for row in rows for f in row.figures.get("failures", ()))
    write_csv(path, ("file", *columns), ((name, *(f[c] for c in columns)) for name, f in failures))
