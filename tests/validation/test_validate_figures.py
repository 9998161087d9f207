# SPDX-License-Identifier: LGPL-2.1-or-later
"""The figures of a validation from their definitions."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from made_parts import partition_of, put_together, row_of_squares, sheet, truth

from gpswb.core.invariance import CLASSES
from gpswb.core.mesh import Mesh
from gpswb.validation.validate import validate


def big_and_small() -> tuple:
    """A face of area 9 that is right and one of area 1 that is wrong."""
    patches = [
        sheet([[0, 0, 0], [9, 0, 0], [9, 1, 0], [0, 1, 0]]),
        sheet([[9, 0, 0], [10, 0, 0], [10, 1, 0], [9, 1, 0]]),
    ]
    return put_together(
        patches, [truth("planar"), truth("cylindrical", "Cylinder")], [0, 1], ["planar", "complex"]
    )


def test_area_and_face_accuracy() -> None:
    result = validate(*big_and_small())
    assert result.area_accuracy == pytest.approx(0.9)
    assert result.face_accuracy == 0.5
    assert (result.right_faces, result.judged_faces) == (1, 2)
    assert result.confusion["cylindrical"]["complex"] == 1
    assert sum(sum(row.values()) for row in result.confusion.values()) == 2


def test_area_counts_facets_and_not_faces() -> None:
    # 12 of 20 facets right: the whole face is right, three fifths of its area are.
    partition, facemap = put_together(
        row_of_squares(1, (5, 2)),
        [truth("planar")],
        np.r_[np.zeros(12), np.ones(8)],
        ["planar", "helical"],
    )
    result = validate(partition, facemap)
    assert (result.area_accuracy, result.face_accuracy) == (pytest.approx(0.6), 1.0)


def test_face_without_truth_is_left_out() -> None:
    partition, facemap = put_together(
        row_of_squares(2), [truth("planar"), None], [0, 1], ["planar", "complex"]
    )
    result = validate(partition, facemap)
    assert (result.area_accuracy, result.face_accuracy) == (1.0, 1.0)
    assert result.judged_area == pytest.approx(1.0)


def test_nothing_to_judge_gives_no_figure() -> None:
    partition, facemap = put_together(row_of_squares(1), [None], [0], ["planar"])
    result = validate(partition, facemap)
    assert (result.area_accuracy, result.face_accuracy) == (None, None)


@given(
    st.lists(st.sampled_from(CLASSES), min_size=6, max_size=6),
    st.lists(st.sampled_from(CLASSES), min_size=6, max_size=6),
    st.floats(1e-3, 1e3),
    st.lists(st.floats(-1, 1), min_size=3, max_size=3).filter(lambda v: np.linalg.norm(v) > 0.1),
)
def test_figures_do_not_depend_on_pose_or_unit(
    true: list, found: list, scale: float, axis: list
) -> None:
    partition, facemap = put_together(
        row_of_squares(6), [truth(name) for name in true], list(range(6)), found
    )
    k = np.array(axis) / np.linalg.norm(axis)
    cross = np.cross(np.eye(3), k)
    turn = np.eye(3) + cross + cross @ cross  # a quarter turn about k
    moved = Mesh(scale * partition.mesh.vertices @ turn.T + 7.0, partition.mesh.triangles)
    one = validate(partition, facemap)
    two = validate(partition_of(moved, partition.region, found), facemap)
    agree = sum(a == b for a, b in zip(true, found, strict=True)) / 6
    assert one.area_accuracy == pytest.approx(agree)
    assert two.area_accuracy == pytest.approx(agree)
    assert one.face_accuracy == two.face_accuracy == pytest.approx(agree)
    assert one.region_f1 == two.region_f1 == 1.0
