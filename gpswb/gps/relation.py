# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a feature nominally stands to the datums of a system."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, sin
from typing import Literal

import numpy as np

from gpswb.gps.datum_system import DatumSystem, Freedom, freedom_left
from gpswb.gps.gps_feature import GpsFeature
from gpswb.gps.invariance_of_union import invariance_of_union
from gpswb.gps.twists import SituationFeature, as_datum

Orientation = Literal["parallelism", "perpendicularity", "angularity"]


@dataclass(frozen=True, eq=False)
class Relation:
    """A feature against a datum system.

    Args:
        orientations: the characteristics that fit the angles to the datums, in order.
        angle_deg: to the first datum with a direction, 0 to 90.
        coaxial: its axis is a datum axis. ``turning``: it is a surface of revolution about one.
        concentric: its centre is a datum point or on a datum axis.
        symmetric: its median plane or axis lies in a datum's plane or axis.
        freedom: what the whole system leaves free of it.
    """

    orientations: tuple[Orientation, ...]
    angle_deg: float
    coaxial: bool
    turning: bool
    concentric: bool
    symmetric: bool
    freedom: Freedom


def relation(feature: GpsFeature, system: DatumSystem) -> Relation:
    """Compare a feature with each datum of a system, and with the system as a whole."""
    frame, tolerances = system.frame, system.tolerances
    near = tolerances.distance * frame.length
    own = invariance_of_union([as_datum(s) for s in feature.situations], frame, tolerances)
    if not own.directed:
        own = feature.place
    angles: list[tuple[Orientation, float]] = []
    turning = concentric = symmetric = False
    everything = [s for datum in system.datums for s in datum.situations]
    for situations in [*(datum.situations for datum in system.datums), everything]:
        whole = invariance_of_union(situations, frame, tolerances)
        for datum in [whole] if whole.directed else situations:
            if own.directed and datum.directed and situations is not everything:
                angles.append(_orientation(own, datum, tolerances.angle))
            symmetric |= _contains(datum, own, near, tolerances.angle)
        joint = invariance_of_union([whole, own], frame, tolerances)
        turning |= whole.has_axis and joint.has_axis
        concentric |= own.invariance_class == joint.invariance_class == "spherical"
    coaxial = turning and own.has_axis
    return Relation(
        tuple(dict.fromkeys(kind for kind, _ in angles)),
        angles[0][1] if angles else 0.0,
        coaxial,
        turning,
        concentric or coaxial or (turning and own.invariance_class == "spherical"),
        symmetric and own.invariance_class != "spherical",
        freedom_left(system, feature),
    )


def _orientation(
    own: SituationFeature, datum: SituationFeature, angle: float
) -> tuple[Orientation, float]:
    """The fitting characteristic and the angle (degrees) between planes and lines."""
    d, e = np.array(own.direction), np.array(datum.direction)
    between = float(np.arctan2(np.linalg.norm(np.cross(d, e)), abs(d @ e)))
    if (own.invariance_class == "planar") != (datum.invariance_class == "planar"):
        between = np.pi / 2 - between
    if between <= angle:
        return "parallelism", 0.0
    if between >= np.pi / 2 - angle:
        return "perpendicularity", 90.0
    return "angularity", float(np.degrees(between))


def _contains(datum: SituationFeature, own: SituationFeature, near: float, angle: float) -> bool:
    """Whether the feature's median plane or axis coincides with, holds or lies in the datum."""
    planes = [s for s in (datum, own) if s.invariance_class == "planar"]
    if not planes:
        return False
    other = own if planes[0] is datum else datum
    normal = np.array(planes[0].direction)
    if abs(float(normal @ np.subtract(other.point, planes[0].point))) > near:
        return False
    slant = abs(float(normal @ np.array(other.direction)))
    if len(planes) == 2:
        return slant >= cos(angle)
    return not other.directed or slant <= sin(angle)
