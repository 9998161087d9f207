# SPDX-License-Identifier: LGPL-2.1-or-later
"""Frames stand beside the part and apart from each other, whatever they point at."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from gpswb.gui.frame_axes import axes_of, placement_of
from gpswb.gui.frame_places import AXONOMETRIC, FrameView, first_view, frame_places

CORNERS = np.array([[-20.0, 5.0, 0.0], [60.0, 35.0, 30.0]])
SIZE = float(np.linalg.norm(np.ptp(CORNERS, axis=0)))
RIGHT, UP, TOWARDS = AXONOMETRIC
NONE = np.zeros((0, 3))


def test_the_view_is_that_from_the_right_front_top():
    assert np.allclose(AXONOMETRIC @ AXONOMETRIC.T, np.eye(3))
    assert np.linalg.det(AXONOMETRIC) > 0
    assert np.allclose(TOWARDS * np.sqrt(3), [1.0, -1.0, 1.0])
    assert UP[2] > 0
    assert np.allclose(axes_of(placement_of(AXONOMETRIC)), AXONOMETRIC)


@given(arrays(float, st.tuples(st.integers(1, 40), st.just(3)), elements=st.floats(0, 1)))
def test_beside_the_part_and_apart(shares):
    anchors = CORNERS[0] + shares * np.ptp(CORNERS, axis=0)
    places = frame_places(anchors, np.ones(len(anchors)), CORNERS, first_view(SIZE), NONE)
    middle = CORNERS.mean(axis=0)
    corners = np.array(np.meshgrid(*CORNERS.T)).reshape(3, -1).T
    edge = np.abs((corners - middle) @ RIGHT).max()
    across = (places - middle) @ RIGHT
    assert (np.abs(across) > edge).all()
    for column in (across < 0, across > 0):
        level = (places[column] - middle) @ UP
        assert (np.diff(np.sort(level)) > 0.06 * SIZE).all()
        # From top to bottom as what they point at, so that leaders of a column hardly cross.
        order = np.argsort(-level)
        pointed = ((anchors[column] - middle) @ UP)[order]
        assert (np.diff(pointed) <= 1e-9).all()
    # Up to a dozen a side, each stands on its own side.
    if len(anchors) <= 12:
        assert (((anchors - middle) @ RIGHT < 0) == (across < 0)).all()


@given(
    arrays(float, st.tuples(st.integers(1, 8), st.just(3)), elements=st.floats(0, 1)),
    arrays(float, st.tuples(st.integers(1, 4), st.just(2)), elements=st.floats(-1, 1)),
)
def test_away_from_frames_that_the_user_has_moved(shares, moved):
    anchors = CORNERS[0] + shares * np.ptp(CORNERS, axis=0)
    kept = CORNERS.mean(axis=0) + SIZE * moved @ AXONOMETRIC[:2]
    view = first_view(SIZE)
    places = frame_places(anchors, np.ones(len(anchors)), CORNERS, view, kept)
    for side in (-1.0, 1.0):
        own, other = (
            np.sort((each - CORNERS.mean(axis=0)) @ UP)
            for each in (
                each[(each - CORNERS.mean(axis=0)) @ RIGHT * side > 0] for each in (places, kept)
            )
        )
        assert (np.diff(own) >= view.row * (1 - 1e-9)).all()
        assert (np.abs(own[:, None] - other) >= view.row * (1 - 1e-9)).all()


@given(arrays(float, st.tuples(st.integers(1, 8), st.just(3)), elements=st.floats(0, 1)))
def test_within_a_view_that_shows_but_a_corner_of_the_part(shares):
    anchors = CORNERS[0] + shares * np.ptp(CORNERS, axis=0)
    centre = np.array([10.0, -4.0]) @ AXONOMETRIC[:2]
    view = FrameView(AXONOMETRIC, 2.0, 50.0, 24.0, centre)
    widths = np.linspace(5.0, 12.0, len(anchors))
    places = frame_places(anchors, widths, CORNERS, view, NONE)
    x, y = AXONOMETRIC[:2] @ (places - CORNERS.mean(axis=0) - centre).T
    assert (np.abs(x) + widths <= 25.0 + 1e-9).all()
    assert (np.abs(y) + 1.0 <= 12.0 + 1e-9).all()
