# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a feature nominally stands to the datums of a system."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import cos, sin
from typing import Literal

import numpy as np

from gpswb.gps.datum_system import DatumSystem, Freedom, freedom_left
from gpswb.gps.gps_feature import GpsFeature
from gpswb.gps.invariance_of_union import invariance_of_union
from gpswb.gps.tolerances import Tolerances
from gpswb.gps.twists import (
    Frame,
    SituationFeature,
    as_datum,
    constraint_rows,
    locked_degrees,
    null_space,
)

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
        partly_located: a translation of it is locked, so that it has a dimension to the datums.
        by: the datum that an orientation, the "axis", the "centre" or the "median" refers to, as
            written in the frame; the whole system where it takes several.
    """

    orientations: tuple[Orientation, ...]
    angle_deg: float
    coaxial: bool
    turning: bool
    concentric: bool
    symmetric: bool
    freedom: Freedom
    partly_located: bool
    by: Mapping[str, str]


def relation(feature: GpsFeature, system: DatumSystem) -> Relation:
    """Compare a feature with each datum of a system, and with the system as a whole."""
    frame, tolerances = system.frame, system.tolerances
    near = tolerances.distance * frame.length
    own = invariance_of_union([as_datum(s) for s in feature.situations], frame, tolerances)
    if not own.directed:
        own = feature.place
    angles: list[tuple[Orientation, float]] = []
    by: dict[str, str] = {}
    for datum in system.datums:
        for each in _parts(datum.situations, frame, tolerances):
            if own.directed and each.directed:
                angles.append(_orientation(own, each, tolerances.angle))
                by.setdefault(angles[-1][0], datum.notation)
    located = [datum for datum in system.datums if not datum.orientation_only]
    places = [(datum.notation, datum.situations) for datum in located]
    places.append((system.notation, tuple(s for datum in located for s in datum.situations)))
    for notation, situations in places if located else ():
        if any(
            _contains(each, own, near, tolerances.angle)
            for each in _parts(situations, frame, tolerances)
        ):
            by.setdefault("median", notation)
        whole = invariance_of_union(situations, frame, tolerances)
        joint = invariance_of_union([whole, own], frame, tolerances)
        if whole.has_axis and joint.has_axis:
            by.setdefault("axis", notation)
        if own.invariance_class == joint.invariance_class == "spherical":
            by.setdefault("centre", notation)
    turning, ball = "axis" in by, own.invariance_class == "spherical"
    freedom = freedom_left(system, feature)
    rows = np.vstack([constraint_rows(s, frame) for s in feature.situations])
    translations, _ = locked_degrees(null_space(rows, tolerances.distance))
    return Relation(
        tuple(dict.fromkeys(kind for kind, _ in angles)),
        angles[0][1] if angles else 0.0,
        turning and own.has_axis,
        turning,
        "centre" in by or (turning and (own.has_axis or ball)),
        "median" in by and not ball,
        freedom,
        len(freedom.translations) < translations,
        by,
    )


def _parts(
    situations: Sequence[SituationFeature], frame: Frame, tolerances: Tolerances
) -> Sequence[SituationFeature]:
    """The union of a datum's features where it has a direction, else each of them."""
    whole = invariance_of_union(situations, frame, tolerances)
    return [whole] if whole.directed else situations


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
