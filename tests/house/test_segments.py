# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's segments become regions that are validated as gpswb's own are."""

import numpy as np
import pytest
from benchmark_modules import benchmark_module
from made_parts import put_together, row_of_squares, truth

from gpswb.validation.validate import validate


@pytest.fixture(scope="module")
def segments():
    return benchmark_module("segments")


def five_squares():
    """Five planar faces of one area, of two facets each."""
    return put_together(row_of_squares(5), [truth("planar")] * 5, np.arange(5), ["planar"] * 5)


def test_call_gives_the_class_and_no_segment_gives_none(segments):
    whole, facemap = five_squares()
    mesh, face = whole.mesh, facemap.face_of_triangle
    found = [(kind, np.flatnonzero(face == i)) for i, kind in enumerate(("planar", "spherical"))]
    result = validate(segments.partition_of_segments(mesh, found), facemap)
    assert result.area_accuracy == pytest.approx(0.2)
    assert [f.invariance_class for f in result.faces] == ["planar", "spherical", None, None, None]
    # Two regions are two of five features.
    assert result.region_f1 == pytest.approx(2 * 2 / (2 + 5))


@pytest.mark.parametrize("turned", [False, True])
def test_facet_of_several_segments_goes_to_the_largest(segments, turned):
    mesh = five_squares()[0].mesh
    asked = [("cylindrical", np.arange(0, 6)), ("planar", np.arange(4, 8))]
    partition = segments.partition_of_segments(mesh, asked[::-1] if turned else asked)
    kinds = [partition.regions[r].invariance_class if r >= 0 else None for r in partition.region]
    assert kinds == ["cylindrical"] * 6 + ["planar"] * 2 + [None] * 2
    assert [r.triangles for r in partition.regions] == ([2, 6] if turned else [6, 2])


def test_of_equal_segments_the_first_has_the_facets(segments):
    mesh = five_squares()[0].mesh
    asked = [("planar", np.arange(6)), ("cylindrical", np.arange(6))]
    (only,) = segments.partition_of_segments(mesh, asked).regions
    assert (only.invariance_class, only.triangles) == ("planar", 6)


def test_nothing_found_is_nothing_recognised(segments):
    whole, facemap = five_squares()
    result = validate(segments.partition_of_segments(whole.mesh, []), facemap)
    assert (result.area_accuracy, result.face_accuracy, result.region_f1) == (0.0, 0.0, 0.0)
