# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many parts: a row each, totals, confusion, recall and failures by kind.

Rows come from result documents (schema ``gpswb-result/1``), so that a summary can be made from
files that other processes wrote.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from gpswb.core.invariance import CLASSES
from gpswb.validation.failures import KINDS

Status = Literal["done", "refused", "crashed", "timeout", "memory"]

RECALL_TRIANGLES = 30
"""Recall by class is given for faces with at least this many triangles as well."""


EXAMPLES = 3
"""Examples of each kind of failure."""


@dataclass(frozen=True, eq=False)
class PartRow:
    """One file of the corpus.

    Args:
        name: file name.
        status: how it ended; anything but ``done`` comes with a one-line ``message``.
        document: the result document; empty where there is none.
        seconds: wall time of the whole part.
    """

    name: str
    status: Status
    message: str = ""
    document: Mapping[str, Any] = field(default_factory=dict)
    seconds: float = 0.0

    @property
    def figures(self) -> Mapping[str, Any]:
        """The result's ``validation``; empty where there is none."""
        return self.document.get("validation") or {}

    @property
    def judged(self) -> bool:
        """The part has faces with a truth, so that it counts in the means."""
        return bool(self.figures.get("judged_faces"))


@dataclass(frozen=True)
class Totals:
    """Means over the judged parts, and the same pooled over all their area, faces, features.

    ``surplus`` counts the regions that match no feature: with the features not found they are what
    F1 lacks.
    """

    parts: int
    judged: int
    refused: int
    failed: int
    faces: int
    triangles: int
    mean_area: float
    mean_face: float
    mean_f1: float
    pooled_area: float
    pooled_face: float
    pooled_f1: float
    all_right: int
    surplus: int


@dataclass(frozen=True)
class Example:
    """A face on which a kind of failure can be seen."""

    part: str
    face: str
    true_class: str | None
    recognised: str | None

    def __str__(self) -> str:
        return f"{self.part} {self.face} ({self.true_class} as {self.recognised})"


@dataclass(frozen=True)
class KindRow:
    """One kind of failure: wrong faces, faces right but whose feature was not found, parts."""

    kind: str
    meaning: str
    wrong: int
    unmatched: int
    parts: int
    face_share: float
    area_share: float
    examples: tuple[Example, ...]


def totals(rows: Sequence[PartRow]) -> Totals:
    """Totals of the corpus; every figure 0 where no part could be judged."""
    judged = [row.figures for row in rows if row.judged]

    def mean(key: str) -> float:
        return sum(figures[key] or 0.0 for figures in judged) / len(judged) if judged else 0.0

    def ratio(part: str, whole: str) -> float:
        total = sum(figures[whole] for figures in judged)
        return float(sum(figures[part] for figures in judged) / total) if total else 0.0

    pieces = sum(figures["regions"] + figures["features"] for figures in judged)
    return Totals(
        parts=len(rows),
        judged=len(judged),
        refused=sum(row.status == "refused" for row in rows),
        failed=sum(row.status in ("crashed", "timeout", "memory") for row in rows),
        faces=sum(figures["judged_faces"] for figures in judged),
        triangles=sum(row.document["mesh"]["triangles"] for row in rows if row.judged),
        mean_area=mean("area_accuracy"),
        mean_face=mean("face_accuracy"),
        mean_f1=mean("region_f1"),
        pooled_area=ratio("right_area", "judged_area"),
        pooled_face=ratio("right_faces", "judged_faces"),
        pooled_f1=2.0 * sum(figures["found"] for figures in judged) / pieces if pieces else 0.0,
        surplus=sum(figures["regions"] - figures["found"] for figures in judged),
        all_right=sum(figures["right_faces"] == figures["judged_faces"] for figures in judged),
    )


def pooled_confusion(rows: Sequence[PartRow]) -> dict[str, dict[str, int]]:
    """Faces of all judged parts by true and recognised class."""
    table: dict[str, dict[str, int]] = {
        true: dict.fromkeys((*CLASSES, "none"), 0) for true in CLASSES
    }
    for row in rows:
        for true, counts in row.figures.get("confusion", {}).items():
            for recognised, count in counts.items():
                table[true][recognised] += count
    return table


def recall(rows: Sequence[PartRow], least_triangles: int) -> dict[str, tuple[int, int]]:
    """(right, all) faces by true class, of faces with at least ``least_triangles`` triangles."""
    counts: dict[str, tuple[int, int]] = dict.fromkeys(CLASSES, (0, 0))
    for row in rows:
        for face in row.document.get("faces", ()):
            true = face["true_class"]
            if true is not None and face["triangles"] >= least_triangles:
                right, every = counts[true]
                counts[true] = (right + (face["class"] == true), every + 1)
    return counts


def failures_by_kind(rows: Sequence[PartRow]) -> list[KindRow]:
    """The kinds that occur, the one with most wrong faces first.

    ``face_share`` is relative to all judged faces. ``area_share`` is the mean over the judged parts
    of the share of the part's area that lies in wrong faces of the kind: what the kind costs in the
    mean area accuracy. The examples are the faces of the largest share of their part, wrong ones
    before others, from different parts.
    """
    judged = [row for row in rows if row.judged]
    faces = sum(row.figures["judged_faces"] for row in judged)
    kinds = []
    for kind, meaning in KINDS.items():
        hits = [
            (row, failure)
            for row in judged
            for failure in row.figures["failures"]
            if failure["kind"] == kind
        ]
        if not hits:
            continue
        wrong = [(row, failure) for row, failure in hits if failure["wrong_class"]]
        share = sum(failure["area"] / _cad_area(row) for row, failure in wrong if _cad_area(row))
        kinds.append(
            KindRow(
                kind=kind,
                meaning=meaning,
                wrong=len(wrong),
                unmatched=len(hits) - len(wrong),
                parts=len({id(row) for row, _ in hits}),
                face_share=len(wrong) / faces,
                area_share=share / len(judged),
                examples=_examples(hits),
            )
        )
    return sorted(kinds, key=lambda row: (-row.wrong, -row.unmatched))


def _examples(hits: Sequence[tuple[PartRow, Mapping[str, Any]]]) -> tuple[Example, ...]:
    """The clearest case of each part, the clearest part first."""
    ranked = sorted(
        hits,
        key=lambda hit: (not hit[1]["wrong_class"], -hit[1]["area"] / (_cad_area(hit[0]) or 1)),
    )
    of_part: dict[str, Example] = {}
    for row, failure in ranked:
        case = Example(row.name, failure["face"], failure["true_class"], failure["class"])
        of_part.setdefault(row.name, case)
    return tuple(of_part.values())[:EXAMPLES]


def worst_first(rows: Sequence[PartRow]) -> list[PartRow]:
    """Judged parts that are not wholly right, the lowest face accuracy first."""
    imperfect = [
        row
        for row in rows
        if row.judged and row.figures["right_faces"] < row.figures["judged_faces"]
    ]
    return sorted(
        imperfect, key=lambda row: (row.figures["face_accuracy"], row.figures["area_accuracy"])
    )


def _cad_area(row: PartRow) -> float:
    return float(sum(face["area"] for face in row.document["faces"]))
