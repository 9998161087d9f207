# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of a run over many parts as text cells, for every form they are shown in."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from gpswb.core.invariance import CLASSES
from gpswb.validation.corpus import (
    RECALL_TRIANGLES,
    PartRow,
    failures_by_kind,
    pooled_confusion,
    recall,
    totals,
)


@dataclass(frozen=True)
class Table:
    """A title, the names of the columns, the rows."""

    title: str
    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


def counts_sentence(rows: Sequence[PartRow]) -> str:
    """How many files were read, judged, refused, failed."""
    t = totals(rows)
    bare = t.parts - t.judged - t.refused - t.failed
    return (
        f"{t.parts} files: {t.judged} judged ({t.faces} faces, {t.triangles} triangles), {bare} "
        f"without a face to judge, {t.refused} refused with one line, {t.failed} failed. "
        f"Every face right in {t.all_right} parts. {t.surplus} regions match no feature."
    )


def figures_table(rows: Sequence[PartRow]) -> Table:
    """Area accuracy, face accuracy, region F1: mean over parts, and pooled."""
    t = totals(rows)
    return Table(
        "Figures",
        ("", "area accuracy", "face accuracy", "region F1 at IoU 0.9"),
        (
            ("mean over parts", four(t.mean_area), four(t.mean_face), four(t.mean_f1)),
            ("pooled", four(t.pooled_area), four(t.pooled_face), four(t.pooled_f1)),
        ),
    )


def kinds_table(rows: Sequence[PartRow]) -> Table:
    """Failures by kind."""
    head = (
        "kind",
        "meaning",
        "faces wrong",
        "of all faces",
        "mean area share",
        "right, but feature not found",
        "parts",
        "largest",
    )
    body = tuple(
        (
            k.kind,
            k.meaning,
            str(k.wrong),
            f"{100 * k.face_share:.2f} %",
            f"{100 * k.area_share:.2f} %",
            str(k.unmatched),
            str(k.parts),
            str(k.examples[0]),
        )
        for k in failures_by_kind(rows)
    )
    return Table("What went wrong, by kind", head, body)


def recall_table(rows: Sequence[PartRow]) -> Table:
    """Recall by true class."""
    everyone, large = recall(rows, 0), recall(rows, RECALL_TRIANGLES)
    return Table(
        "Recall by class",
        ("class", "all faces", f"faces of {RECALL_TRIANGLES} triangles or more"),
        tuple((name, _fraction(everyone[name]), _fraction(large[name])) for name in CLASSES),
    )


def confusion_table(rows: Sequence[PartRow]) -> Table:
    """Faces by true class (rows) and recognised class (columns)."""
    return Table(
        "Confusion: faces, true class down, recognised across",
        ("", *CLASSES, "none"),
        tuple((true, *map(str, row.values())) for true, row in pooled_confusion(rows).items()),
    )


def parts_table(rows: Sequence[PartRow]) -> Table:
    """A row a file; no times, so that two runs give the same text."""
    return Table(
        "Per part",
        (
            "file",
            "faces",
            "triangles",
            "area",
            "face",
            "F1",
            "features found",
            "regions",
            "wrong faces by kind",
        ),
        tuple(_part(row) for row in rows),
    )


def four(value: float) -> str:
    """A share with four decimals."""
    return f"{value:.4f}"


def _fraction(counts: tuple[int, int]) -> str:
    right, every = counts
    return f"{right}/{every} = {right / every:.3f}" if every else "-"


def _part(row: PartRow) -> tuple[str, ...]:
    if not row.judged:
        said = f"{row.status}: {row.message}" if row.message else "no face to judge"
        return (row.name, *"-------", said)
    figures = row.figures
    counts: dict[str, int] = {}
    for failure in figures["failures"]:
        if failure["wrong_class"]:
            counts[failure["kind"]] = counts.get(failure["kind"], 0) + 1
    kinds = ", ".join(f"{n} {kind}" for kind, n in sorted(counts.items(), key=lambda kv: -kv[1]))
    area = figures["area_accuracy"]
    return (
        row.name,
        str(figures["judged_faces"]),
        str(row.document["mesh"]["triangles"]),
        "-" if area is None else four(area),
        four(figures["face_accuracy"]),
        four(figures["region_f1"]),
        f"{figures['found']}/{figures['features']}",
        str(figures["regions"]),
        kinds,
    )
