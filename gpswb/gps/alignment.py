# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small features take the axis or normal of a larger one where their own points can't object."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from gpswb.core.mesh import FloatArray
from gpswb.core.reference import Reference
from gpswb.core.thickness import thickness
from gpswb.gps.gps_feature import GpsFeature
from gpswb.gps.tolerances import Tolerances
from gpswb.gps.twists import SituationFeature, vector

# Further off than this, a direction or an axis isn't the same one seen badly.
_TILT = np.radians(1.0)
_OFFSET = 1e-3


def align(
    features: Sequence[GpsFeature], length: float, tolerances: Tolerances
) -> tuple[GpsFeature, ...]:
    """Let a narrow shoulder or a fillet's band share the direction it was drawn with.

    The axis of a narrow band is known by position to a few parts in a thousand only, and one such
    axis would cost a turned part its symmetry. A feature adopts the axis (revolute, cylindrical) or
    direction (planar) of a larger one if its points lie as well about that as about its own.

    Args:
        features: integral features by falling area.
        length: of the frame, mm.
    """
    axes: list[SituationFeature] = []
    directions: list[FloatArray] = []
    aligned = []
    for feature in features:
        place = feature.place
        shared = None
        if place.invariance_class in ("cylindrical", "revolute"):
            shared = _shared_axis(feature, axes, length, tolerances)
            if shared is None:
                axes.append(place)
                directions.append(np.array(place.direction))
        elif place.invariance_class == "planar":
            shared = _shared_normal(feature, directions, tolerances.surface * length)
            if shared is None:
                directions.append(np.array(place.direction))
        aligned.append(feature if shared is None else _moved(feature, shared))
    return tuple(aligned)


def _shared_axis(
    feature: GpsFeature, axes: Sequence[SituationFeature], length: float, tolerances: Tolerances
) -> SituationFeature | None:
    place = feature.place
    limit = max(tolerances.surface * length, 2.0 * _axial_thickness(feature, place))
    for axis in axes:
        near = _foot(place.point, axis)
        offset = float(np.linalg.norm(np.subtract(place.point, near)))
        if offset <= _OFFSET * length and _tilt(place, np.array(axis.direction)) <= _TILT:
            shared = replace(place, point=vector(near), direction=axis.direction)
            if _axial_thickness(feature, shared) <= limit:
                return shared
    return None


def _shared_normal(
    feature: GpsFeature, directions: Sequence[FloatArray], limit: float
) -> SituationFeature | None:
    place = feature.place
    for d in directions:
        if _tilt(place, d) <= _TILT and float(np.std(feature.points @ d)) <= limit:
            sense = np.copysign(1.0, d @ np.array(place.direction))
            return replace(place, direction=vector(sense * d))
    return None


def _tilt(place: SituationFeature, d: FloatArray) -> float:
    own = np.array(place.direction)
    return float(np.arctan2(np.linalg.norm(np.cross(own, d)), abs(own @ d)))


def _foot(point: Sequence[float], axis: SituationFeature) -> FloatArray:
    d, p = np.array(axis.direction), np.array(axis.point)
    foot: FloatArray = p + d * ((np.array(point) - p) @ d)
    return foot


def _axial_thickness(feature: GpsFeature, place: SituationFeature) -> float:
    reference = Reference(np.array(place.point), np.array(place.direction))
    return thickness(feature.points, place.invariance_class, reference)


def _moved(feature: GpsFeature, place: SituationFeature) -> GpsFeature:
    situation = dict(feature.situation)
    if place.invariance_class == "planar":
        situation["normal"] = list(place.direction)
    else:
        situation["direction"] = list(place.direction)
        situation["point"] = _foot(situation["point"], place).tolist()
    return replace(feature, situations=(place,), situation=situation)
