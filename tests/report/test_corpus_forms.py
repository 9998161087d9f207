# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many parts: totals from their definitions, Markdown section, page."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from made_parts import put_together, sheet, solid_of, truth

from gpswb.errors import OutputError
from gpswb.io.result_json import result_document
from gpswb.report.corpus_markdown import corpus_section, renew_section
from gpswb.report.corpus_page import Figure, corpus_page
from gpswb.validation.corpus import (
    PartRow,
    failures_by_kind,
    pooled_confusion,
    recall,
    totals,
    worst_first,
)
from gpswb.validation.validate import validate

HOSTILE = "a|b<script>alert(1)</script>`.step"


def row(name: str, n: int, right: int, size: float = 1.0) -> PartRow:
    """A part of ``n`` equal squares, the first ``right`` of them recognised, the others helical."""
    patches = [
        sheet(
            [
                [i * size, 0, 0],
                [(i + 1) * size, 0, 0],
                [(i + 1) * size, size, 0],
                [i * size, size, 0],
            ]
        )
        for i in range(n)
    ]
    classes = ["planar"] * right + ["helical"] * (n - right)
    partition, facemap = put_together(patches, [truth("planar")] * n, list(range(n)), classes)
    document = result_document(
        solid_of(partition.mesh, facemap, name), partition, validate(partition, facemap)
    )
    return PartRow(name, "done", "", document, 1.0)


ROWS = [
    row("good.step", 2, 2),
    row(HOSTILE, 8, 2, size=10.0),
    PartRow("bad.step", "refused", "not a STEP file", {}, 0.1),
    PartRow("worse.step", "crashed", "the process was ended by SIGSEGV", {}, 0.1),
]


def test_means_and_pools() -> None:
    t = totals(ROWS)
    assert (t.parts, t.judged, t.refused, t.failed, t.faces, t.all_right) == (4, 2, 1, 1, 10, 1)
    assert t.mean_face == t.mean_area == pytest.approx((1 + 2 / 8) / 2)
    assert t.pooled_face == pytest.approx(4 / 10)
    assert t.pooled_area == pytest.approx((2 + 200) / (2 + 800))
    assert t.mean_f1 == t.pooled_f1 == 1.0  # every region is a feature, whatever its class


def test_no_part_at_all() -> None:
    t = totals([])
    assert (t.mean_area, t.pooled_face, t.pooled_f1) == (0.0, 0.0, 0.0)
    assert failures_by_kind([]) == []


def test_confusion_and_recall_pool_the_faces() -> None:
    assert pooled_confusion(ROWS)["planar"]["planar"] == 4
    assert pooled_confusion(ROWS)["planar"]["helical"] == 6
    assert recall(ROWS, 0)["planar"] == (4, 10)
    assert recall(ROWS, 3)["planar"] == (0, 0)  # a square has two triangles


def test_kinds_add_up_to_the_wrong_faces() -> None:
    kinds = failures_by_kind(ROWS)
    assert sum(kind.wrong for kind in kinds) == 6
    # What the kinds cost in the mean is what the mean lacks.
    assert sum(kind.area_share for kind in kinds) == pytest.approx(1 - totals(ROWS).mean_area)


def test_worst_part_comes_first_and_right_parts_not_at_all() -> None:
    assert [r.name for r in worst_first([*ROWS, row("half.step", 2, 1)])] == [HOSTILE, "half.step"]


def test_section_has_a_row_for_every_file_and_no_markup_of_theirs() -> None:
    section = corpus_section(ROWS, "density stl", "gpswb validate x")
    assert "| bad.step | - | - | - | - | - | - | - | refused: not a STEP file |" in section
    assert "<script>" not in section
    lines = [line for line in section.splitlines() if line.startswith("| a&#124;b")]
    assert len(lines) == 1
    assert lines[0].count("|") == 10


def test_page_shows_every_file_and_runs_no_markup_of_theirs() -> None:
    page = corpus_page(ROWS, HOSTILE, HOSTILE, [], [Figure(HOSTILE, b"png")])
    assert "<script" not in page
    assert page.count("&lt;script&gt;") >= 4
    assert "the process was ended by SIGSEGV" in page


@given(st.text(alphabet="abc \n", max_size=30), st.text(alphabet="xyz\n", max_size=20))
def test_section_is_renewed_in_place(before: str, after: str) -> None:
    once = renew_section(before, "t", "one\n") + after
    twice = renew_section(once, "t", "two\n")
    assert twice == once.replace("one\n", "two\n")
    assert renew_section(twice, "t", "two\n") == twice
    both = renew_section(twice, "other", "three\n")
    assert both.startswith(twice)
    assert "three" in both


@pytest.mark.parametrize(
    "broken",
    [
        "<!-- gpswb:begin t -->",
        "<!-- gpswb:end t -->",
        "<!-- gpswb:end t --><!-- gpswb:begin t -->",
        "<!-- gpswb:begin t --><!-- gpswb:begin t --><!-- gpswb:end t -->",
    ],
)
def test_markers_that_do_not_pair_are_refused(broken: str) -> None:
    with pytest.raises(OutputError, match="do not pair"):
        renew_section(broken, "t", "x\n")
