# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where frames stand: in two columns beside the part as a view shows it.

Frames are laid out for one view, at first the axonometric one that FreeCAD opens with, later that
which the user asks for. In it the part's box leaves room at the left and at the right; there the
frames stand one above the other in the order of what they point at, so that leaders hardly cross,
and before the part, so that it hides no leader of a face that is seen.
They are points of space: when the view turns they turn with the part, and only their pictures keep
facing the user. Frames that were moved by hand stay where they are, and the others avoid them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gpswb.core.mesh import FloatArray
from gpswb.io.stored_result import StoredResult


@dataclass(frozen=True, eq=False)
class FrameView:
    """A view that frames are laid out for.

    Args:
        axes: (3, 3) rows: to the right, upwards and towards the user.
        row: between frames in a column, mm.
        width, height: of what the view shows, mm.
        offset: (3,) from the middle of the part's box to what is seen in the view's middle, mm.
    """

    axes: FloatArray
    row: float
    width: float
    height: float
    offset: FloatArray


AXONOMETRIC = np.array([[1.0, 1.0, 0.0], [-1.0, 1.0, 2.0], [1.0, -1.0, 1.0]]) / np.sqrt(
    [[2.0], [6.0], [3.0]]
)
"""Axes of the view that FreeCAD opens with: from the right, the front and the top."""
MARK = 0.03
"""Height of a datum triangle, of the part's diagonal."""
_BESIDE = 0.06
"""Between box and column, of the part's diagonal: datum triangles have room there."""
_ROW = 0.065
"""Between frames in a column, of the part's diagonal: a view that fits the part is about a diagonal
high, and a frame with its gap a fifteenth of a window."""
_HEIGHT = 0.8
"""Of such a view, of the diagonal: what it has of room for frames."""
_CELL, _LETTER, _MARGIN = 0.7, 0.24, 0.4
"""Least width of a compartment, widest of a letter and margin of text, of a row."""
_APART = 0.1
"""Between the ends of leaders on one feature, so that they can be told apart."""
_FACING = 0.2
"""A facet that faces the view by at least this cosine is well seen."""


def first_view(diagonal: float) -> FrameView:
    """The view that FreeCAD opens with, fitted to a part of this diagonal, mm."""
    return FrameView(AXONOMETRIC, _ROW * diagonal, np.inf, _HEIGHT * diagonal, np.zeros(3))


def frame_width(cells: Sequence[str], row: float) -> float:
    """Width of a frame at most, mm, where the rows are ``row`` mm apart."""
    return sum(max(_CELL, _LETTER * len(cell) + _MARGIN) for cell in cells) * row


def anchor_on(
    stored: StoredResult, faces: Sequence[int], taken: Sequence[FloatArray], towards: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Where a leader ends: a point (3,) on the first of the faces, and the outward normal there.

    The middle of the face, on its side towards the view, away from the ends of other leaders.

    Args:
        faces: indices; the mesh has facets on the first.
        taken: (3,) ends of the leaders that are there.
        towards: (3,) unit, to the user.
    """
    mesh, facemap = stored.solid.mesh, stored.solid.facemap
    assert facemap is not None
    facets = np.flatnonzero(facemap.face_of_triangle == faces[0])
    centres, normals = mesh.centroids[facets], mesh.facet_normals[facets]
    middle = np.average(centres, axis=0, weights=mesh.areas[facets] + 1e-300)
    good = normals @ towards > _FACING
    score = np.linalg.norm(centres - middle, axis=1) + mesh.diagonal * ~good
    for other in taken:
        near = np.linalg.norm(centres - other, axis=1) < _APART * mesh.diagonal
        score = score + 2 * mesh.diagonal * near
    best = int(np.argmin(score))
    return centres[best], normals[best]


def frame_places(
    anchors: FloatArray, widths: FloatArray, corners: FloatArray, view: FrameView, kept: FloatArray
) -> FloatArray:
    """Places (k, 3) of frames: beside the part; where the view is too narrow for that, before it.

    Args:
        anchors: (k, 3) ends of their leaders.
        widths: (k,) of the frames, mm.
        corners: (2, 3) lowest and highest corner of the part's box.
        kept: (n, 3) places of other frames.
    """
    right, up, towards = view.axes
    middle, size = corners.mean(axis=0), float(np.linalg.norm(np.ptp(corners, axis=0)))
    half, depth = np.ptp(corners, axis=0) / 2 @ np.abs([right, towards]).T
    half += _BESIDE * size
    across, height = (anchors - middle) @ right, (anchors - middle) @ up
    places = np.zeros_like(anchors)
    order = np.argsort(across, kind="stable")
    most = max(int(view.height / view.row), (len(order) + 1) // 2)
    count = min(max(int((across < 0).sum()), len(order) - most), most)
    for side, members in ((-1.0, order[:count]), (1.0, order[count:])):
        rows = members[np.argsort(-height[members], kind="stable")]
        if not len(rows):
            continue
        edge = view.width / 2 - widths[rows].max() + side * view.offset @ right
        beside = kept[(kept - middle) @ right * side > 0]
        level = _spread(height[rows], view.offset @ up, view)
        level = _avoid(level, (beside - middle) @ up, view.row)
        column = middle + depth * towards + side * min(half, edge) * right
        places[rows] = column + level[:, None] * up
    return places


def _avoid(levels: FloatArray, others: FloatArray, gap: float) -> FloatArray:
    """Falling heights pushed down where they come nearer than ``gap`` to others (n,)."""
    found = np.array(levels)
    for i in range(len(found)):
        if i:
            found[i] = min(found[i], found[i - 1] - gap)
        for other in -np.sort(-others):
            if abs(found[i] - other) < gap:
                found[i] = other - gap
    return found


def _spread(wanted: FloatArray, middle: float, view: FrameView) -> FloatArray:
    """Falling heights a row apart, as near to the wanted ones as can be.

    They lie within the view, whose middle is at a height of ``middle``; if not all fit, the first.
    """
    step = view.row * np.arange(len(wanted))
    most = (view.height - view.row) / 2
    # With the steps added, "a row apart" means "not rising": the nearest such row is known.
    level = np.clip(wanted + step, middle - most + step[-1], middle + most)
    down = np.minimum.accumulate(level)
    up = np.maximum.accumulate(level[::-1])[::-1]
    found: FloatArray = (down + up) / 2 - step
    return found
