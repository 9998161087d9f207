# SPDX-License-Identifier: LGPL-2.1-or-later
"""Evenly spread samples and points in triangles, the ground that slots and ribs stand on."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gpswb.gps.facing import inside, samples_of

SQUARE = np.array([[[0, 0], [1, 0], [1, 1]], [[0, 0], [1, 1], [0, 1]]], dtype=float)
# A border belongs to the square, but rounding decides on which side a point next to it lies.
COORDINATE = st.floats(-0.5, 1.5).filter(
    lambda x: x in (0.0, 1.0) or min(abs(x), abs(x - 1)) > 1e-9
)


@given(st.lists(st.tuples(COORDINATE, COORDINATE), min_size=1, max_size=20), st.booleans())
def test_points_in_a_square(points, flipped):
    points = np.array(points)
    triangles = SQUARE[:, ::-1] if flipped else SQUARE
    expected = ((points >= 0) & (points <= 1)).all(axis=1)
    assert np.array_equal(inside(points, triangles), expected)


def test_facets_without_area_hold_nothing():
    point = np.tile([[0.5, 0.5]], (3, 1))
    line = np.array([[0.0, 0.0], [0.5, 0.1], [1.0, 0.2]])
    assert not inside(np.array([[0.5, 0.5], [0.2, 0.3]]), np.array([point, line])).any()
    assert not inside(np.array([[0.5, 0.5]]), np.zeros((0, 3, 2))).any()


@pytest.mark.parametrize("share", [0.1, 0.25, 0.5, 0.9])
def test_samples_measure_areas_whatever_the_triangulation(share):
    """The share of samples below a height is the share of the area, coarse or fine."""
    flat = np.dstack([SQUARE, np.zeros((2, 3))])
    middle = flat.mean(axis=1, keepdims=True)
    fine = np.concatenate(
        [np.concatenate([flat[:, [i, (i + 1) % 3]], middle], axis=1) for i in range(3)]
    )
    for facets in (flat, fine, np.concatenate([flat[:1], fine[1::2]])):
        samples = samples_of(facets, 400)
        assert (samples[:, 1] <= share).mean() == pytest.approx(share, abs=0.03)
        assert samples[:, 2] == pytest.approx(0.0)
