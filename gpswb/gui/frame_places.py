# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where frames stand: in two columns beside the part as FreeCAD first shows it.

The axonometric view that FreeCAD opens with looks from (1, −1, 1). In it the part's box leaves room
at the left and at the right; there the frames stand one above the other in the order of what they
point at, so that leaders hardly cross. They are points of space: when the view turns they turn with
the part, and only their pictures keep facing the user.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gpswb.core.mesh import FloatArray
from gpswb.io.stored_result import StoredResult

TOWARDS = np.array([1.0, -1.0, 1.0]) / np.sqrt(3.0)
RIGHT = np.array([1.0, 1.0, 0.0]) / np.sqrt(2.0)
UP = np.cross(TOWARDS, RIGHT)
MARK = 0.03
"""Height of a datum triangle, of the part's diagonal."""
_BESIDE = 0.03
"""Between box and column, of the part's diagonal."""
_ROW = 0.065
"""Between frames in a column: a view that fits the part is about a diagonal high, and a frame with
its gap a fifteenth of a window."""
_COLUMN = 12
"""Frames that a column holds in such a view; more go to the other side, where that has room."""
_APART = 0.1
"""Between the ends of leaders on one feature, so that they can be told apart."""
_FACING = 0.2
"""A facet that faces the view by at least this cosine is well seen."""


def anchor_on(
    stored: StoredResult, faces: Sequence[int], taken: Sequence[FloatArray]
) -> tuple[FloatArray, FloatArray]:
    """Where a leader ends: a point (3,) on the first of the faces, and the outward normal there.

    The middle of the face, on its side towards the view, away from the ends of other leaders.

    Args:
        faces: indices; the mesh has facets on the first.
        taken: (3,) ends of the leaders that are there.
    """
    mesh, facemap = stored.solid.mesh, stored.solid.facemap
    assert facemap is not None
    facets = np.flatnonzero(facemap.face_of_triangle == faces[0])
    centres, normals = mesh.centroids[facets], mesh.facet_normals[facets]
    middle = np.average(centres, axis=0, weights=mesh.areas[facets] + 1e-300)
    good = normals @ TOWARDS > _FACING
    score = np.linalg.norm(centres - middle, axis=1) + mesh.diagonal * ~good
    for other in taken:
        near = np.linalg.norm(centres - other, axis=1) < _APART * mesh.diagonal
        score = score + 2 * mesh.diagonal * near
    best = int(np.argmin(score))
    return centres[best], normals[best]


def frame_places(anchors: FloatArray, corners: FloatArray) -> FloatArray:
    """Places (k, 3) of frames.

    Args:
        anchors: (k, 3) ends of their leaders.
        corners: (2, 3) lowest and highest corner of the part's box.
    """
    middle, size = corners.mean(axis=0), float(np.linalg.norm(np.ptp(corners, axis=0)))
    half = np.ptp(corners, axis=0) / 2 @ np.abs(RIGHT) + _BESIDE * size
    across, height = (anchors - middle) @ RIGHT, (anchors - middle) @ UP
    places = np.zeros_like(anchors)
    order = np.argsort(across, kind="stable")
    most = max(_COLUMN, (len(order) + 1) // 2)
    count = min(max(int((across < 0).sum()), len(order) - most), most)
    for side, members in ((-1.0, order[:count]), (1.0, order[count:])):
        rows = members[np.argsort(-height[members], kind="stable")]
        level = _spread(height[rows], _ROW * size)
        places[rows] = middle + side * half * RIGHT + level[:, None] * UP
    return places


def _spread(wanted: FloatArray, gap: float) -> FloatArray:
    """Falling heights at least ``gap`` apart, as near to the wanted ones as pushing makes them."""
    step = gap * np.arange(len(wanted))
    # With the steps added, "gap apart" means "not rising": the nearest such row is known.
    level = wanted + step
    down = np.minimum.accumulate(level)
    up = np.maximum.accumulate(level[::-1])[::-1]
    found: FloatArray = (down + up) / 2 - step
    return found
