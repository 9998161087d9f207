# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions against features: F1 from its definition, and what it must not depend on."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from made_parts import partition_of, put_together, row_of_squares, truth

from gpswb.cad.solid import FaceMap
from gpswb.validation.region_match import match_regions


def squares(n: int, region: list[int], features: list[int] | None = None) -> tuple:
    count = max(region) + 1
    return put_together(
        row_of_squares(n), [truth("planar")] * n, region, ["planar"] * count, features
    )


def test_regions_equal_to_features_score_one() -> None:
    match = match_regions(*squares(4, [0, 1, 2, 3]))
    assert (match.f1, match.over_segmented, match.under_segmented) == (1.0, 0, 0)


def test_faces_of_one_feature_are_one() -> None:
    assert match_regions(*squares(4, [0, 0, 1, 1], features=[7, 7, 3, 3])).f1 == 1.0


def test_merge_of_two_finds_neither() -> None:
    match = match_regions(*squares(4, [0, 0, 1, 2]))
    assert match.f1 == pytest.approx(2 * 2 / (3 + 4))
    assert match.under_segmented == 1


def test_split_in_two_is_not_found() -> None:
    match = match_regions(*squares(4, [0, 1, 2, 3], features=[0, 0, 1, 2]))
    assert match.f1 == pytest.approx(2 * 2 / (4 + 3))
    assert match.over_segmented == 1


@pytest.mark.parametrize(("inside", "found"), [(90, True), (89, False)])
def test_threshold_is_nine_tenths_of_the_union(inside: int, found: bool) -> None:
    # One feature of 100 equal triangles; the region holds `inside` of them and nothing else.
    region = np.r_[np.zeros(inside), -np.ones(100 - inside)]
    partition, facemap = put_together(
        row_of_squares(1, (10, 5)), [truth("planar")], region, ["planar"]
    )
    assert (match_regions(partition, facemap).true_positives == 1) is found


def test_no_region_at_all() -> None:
    partition, facemap = put_together(row_of_squares(2), [truth("planar")] * 2, [-1, -1], [])
    assert match_regions(partition, facemap).f1 == 0.0


@given(
    st.lists(st.integers(0, 4), min_size=12, max_size=12),
    st.lists(st.integers(0, 4), min_size=12, max_size=12),
    st.permutations(range(5)),
    st.permutations(range(24)),
)
def test_names_and_order_do_not_matter(
    region: list[int], feature: list[int], renamed: list[int], order: list[int]
) -> None:
    partition, facemap = put_together(
        row_of_squares(12), [truth("planar")] * 12, region, ["planar"] * 5, feature
    )
    names = np.array(renamed)
    shuffled = np.array(order)
    mesh = type(partition.mesh)(partition.mesh.vertices, partition.mesh.triangles[shuffled])
    again = partition_of(mesh, names[partition.region][shuffled], ["planar"] * 5)
    same = FaceMap(
        facemap.face_of_triangle[shuffled], facemap.faces, 10 + names[facemap.feature_of_face]
    )
    one, two = match_regions(partition, facemap), match_regions(again, same)
    assert one.true_positives == two.true_positives
    assert one.f1 == two.f1
    assert one.over_segmented == two.over_segmented
    assert one.under_segmented == two.under_segmented


@given(st.lists(st.integers(0, 3), min_size=8, max_size=8))
def test_matching_a_partition_with_itself_is_perfect(region: list[int]) -> None:
    numbers = np.unique(region, return_inverse=True)[1].tolist()
    assert match_regions(*squares(8, numbers, features=region)).f1 == 1.0
