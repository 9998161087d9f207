# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mapping back: class, share and regions of a face follow from areas that are known."""

import numpy as np
import pytest
from made_parts import put_together, row_of_squares, truth

from gpswb.cad.solid import Face, FaceMap
from gpswb.validation.face_result import map_back


def halves(first: str, second: str, split: int) -> tuple:
    """One face of 20 equal triangles, ``split`` of them in region 0."""
    region = np.r_[np.zeros(split), np.ones(20 - split)]
    return put_together(row_of_squares(1, (5, 2)), [truth("planar")], region, [first, second])


def test_largest_share_wins() -> None:
    (face,) = map_back(*halves("planar", "cylindrical", 14))
    assert face.invariance_class == "planar"
    assert face.share == pytest.approx(0.7)
    assert face.regions == (0, 1)
    assert face.agrees


def test_tie_goes_to_the_class_named_first() -> None:
    (face,) = map_back(*halves("complex", "revolute", 10))
    assert face.invariance_class == "revolute"
    assert face.share == pytest.approx(0.5)


def test_regions_of_one_class_add_up() -> None:
    partition, facemap = put_together(
        row_of_squares(1, (5, 2)),
        [truth("planar")],
        np.r_[np.zeros(7), np.ones(7), np.full(6, 2)],
        ["planar", "cylindrical", "planar"],
    )
    (face,) = map_back(partition, facemap)
    assert (face.invariance_class, face.share) == ("planar", pytest.approx(13 / 20))


def test_sliver_of_a_region_is_not_listed() -> None:
    partition, facemap = put_together(
        row_of_squares(1, (20, 10)),
        [truth("planar")],
        np.r_[1, np.zeros(399)],
        ["planar", "cylindrical"],
    )
    assert map_back(partition, facemap)[0].regions == (0,)


def test_face_without_triangles_is_wrong() -> None:
    partition, facemap = put_together(row_of_squares(1), [truth("planar")], [0], ["planar"])
    bare = Face("Face2", 3.0, 0, truth("planar"))
    both = FaceMap(facemap.face_of_triangle, (*facemap.faces, bare), np.array([0, 1]))
    face = map_back(partition, both)[1]
    assert face.invariance_class is None
    assert not face.agrees
    assert (face.triangles, face.share, face.regions) == (0, 0.0, ())


def test_facets_in_no_region_lower_the_share() -> None:
    partition, facemap = put_together(
        row_of_squares(1, (5, 2)), [truth("planar")], np.r_[np.zeros(15), -np.ones(5)], ["planar"]
    )
    assert map_back(partition, facemap)[0].share == pytest.approx(0.75)


def test_other_number_of_triangles_is_refused() -> None:
    partition, _ = put_together(row_of_squares(1), [truth("planar")], [0], ["planar"])
    _, facemap = put_together(row_of_squares(2), [truth("planar")] * 2, [0, 0], ["planar"])
    with pytest.raises(ValueError, match="4 triangles in the face map, 2 in the partition"):
        map_back(partition, facemap)
