# SPDX-License-Identifier: LGPL-2.1-or-later
"""The invariance class of several features taken together (ISO 17450-1, 5459; design, 7)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from gpswb.core.mesh import FloatArray
from gpswb.gps.snapping import snap_directions
from gpswb.gps.tolerances import DEFAULT, Tolerances
from gpswb.gps.twists import (
    Frame,
    SituationFeature,
    constraint_rows,
    null_space,
    rotation_rank,
    rotations_of,
    vector,
)


def invariance_of_union(
    features: Sequence[SituationFeature], frame: Frame, tolerances: Tolerances = DEFAULT
) -> SituationFeature:
    """Situation feature of a union: parallel cylinders are prismatic, plane ⟂ cylinder revolute.

    Args:
        features: at least one; where directions nearly agree the earlier one stands.
        frame: of the part.

    Returns:
        The class by dimension k and rotation rank of the null space, with the direction, a point of
        the axis and the lead that it has. For a planar union the point is the mean of the points.

    Raises:
        ValueError: no feature is given.
    """
    if not features:
        raise ValueError("the union of no features has no invariance class")
    snapped = snap_directions(features, tolerances.angle)
    rows = np.vstack([constraint_rows(feature, frame) for feature in snapped])
    return situation_of(null_space(rows, tolerances.distance), snapped, frame, tolerances)


def situation_of(
    free: FloatArray,
    features: Sequence[SituationFeature],
    frame: Frame,
    tolerances: Tolerances = DEFAULT,
) -> SituationFeature:
    """Situation feature of the group of twists ``free`` (6, k) that ``features`` leave."""
    turning = rotation_rank(free)
    middle = vector(np.mean([feature.point for feature in features], axis=0))
    match free.shape[1], turning:
        case 3, 3:
            return SituationFeature("spherical", _centre(free, frame))
        case 3, 1:
            return SituationFeature("planar", middle, _spin(free))
        case 2, 1:
            return SituationFeature("cylindrical", _axis_point(free, frame), _spin(free))
        case 1, 0:
            return SituationFeature("prismatic", middle, vector(_unit(free[3:, 0])))
        case 1, 1:
            axis = SituationFeature("revolute", _axis_point(free, frame), _spin(free))
            pitch = float(free[:3, 0] @ free[3:, 0] / (free[:3, 0] @ free[:3, 0]))
            if abs(pitch) <= tolerances.pitch:
                return axis
            lead = 2 * np.pi * pitch * frame.length
            return replace(axis, invariance_class="helical", lead=lead)
    return SituationFeature("complex", middle)


def _unit(v: FloatArray) -> FloatArray:
    v = v / np.linalg.norm(v)
    # One sense for both: the largest component is positive.
    return v if v[np.argmax(np.abs(v).round(6))] > 0 else -v


def _spin(free: FloatArray) -> tuple[float, float, float]:
    """Unit direction of the only rotation among twists (6, k)."""
    return vector(_unit(rotations_of(free)[0]))


def _axis_point(free: FloatArray, frame: Frame) -> tuple[float, float, float]:
    """Point (ω×v)/|ω|² of the axis, nearest to the frame's origin."""
    twist = free @ np.linalg.svd(free[:3])[2][0]
    omega, v = twist[:3], twist[3:]
    return vector(np.cross(omega, v) / (omega @ omega) * frame.length + frame.origin)


def _centre(free: FloatArray, frame: Frame) -> tuple[float, float, float]:
    """Point that all rotations leave: least squares of v = c×ω over the basis."""
    omega, v = free[:3].T, free[3:].T
    cross = np.array([[[0, w[2], -w[1]], [-w[2], 0, w[0]], [w[1], -w[0], 0]] for w in omega])
    c = np.linalg.lstsq(cross.reshape(-1, 3), v.reshape(-1), rcond=None)[0]
    return vector(c * frame.length + frame.origin)
