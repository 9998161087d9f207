# SPDX-License-Identifier: LGPL-2.1-or-later
"""Features on one axis: coaxial groups, counterbores and countersinks (ISO 22432)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gpswb.gps.gps_feature import GpsFeature, Kind, group_of, numbered
from gpswb.gps.invariance_of_union import invariance_of_union
from gpswb.gps.same_surface import cylindrical_coordinates
from gpswb.gps.tolerances import DEFAULT, Tolerances
from gpswb.gps.twists import Frame
from gpswb.sentence import Sentence


def coaxial_features(
    features: Sequence[GpsFeature],
    frame: Frame,
    first_id: int,
    tolerances: Tolerances = DEFAULT,
) -> list[GpsFeature]:
    """Groups of two or more holes, shafts, cones and threads on one axis; stepped and sunk holes.

    A counterbore is a hole with a wider one at its end; a countersink has a cone that opens from
    the hole's own diameter. The cone that a drill leaves at the bottom closes from it, and belongs
    to no group. A group that is nothing more than a sunk hole isn't repeated.
    """
    round_ = [f for f in features if f.surface == "helicoid" or (f.size and f.place.has_axis)]
    found: list[tuple[Kind, list[GpsFeature]]] = []
    near = tolerances.distance * frame.length * 10
    for whole in coaxial_groups(round_, frame, tolerances):
        group = [f for f in whole if not _drill_point(f, whole, near)]
        sunk = _sunk_holes(group, near)
        if len(group) > 1 and not any(len(members) == len(group) for _, members in sunk):
            found.append(("coaxial group", group))
        found += sunk
    counts: dict[Kind, int] = {}
    compounds: list[GpsFeature] = []
    for kind, members in found:
        counts[kind] = counts.get(kind, 0) + 1
        compounds.append(
            _compound(kind, members, counts[kind], first_id + len(compounds), frame, tolerances)
        )
    return compounds


def coaxial_groups(
    features: Sequence[GpsFeature], frame: Frame, tolerances: Tolerances = DEFAULT
) -> list[list[GpsFeature]]:
    """Features with an axis, put together by axis; the largest of each group first."""
    groups: list[list[GpsFeature]] = []
    for feature in sorted(features, key=lambda f: -f.area):
        d = np.array(feature.place.direction)
        for group in groups:
            axis = group[0].place
            if feature.body != group[0].body:
                continue
            if np.linalg.norm(np.cross(d, axis.direction)) > np.sin(tolerances.angle):
                continue
            step = np.subtract(feature.place.point, axis.point)
            offset = np.linalg.norm(np.cross(step, axis.direction))
            if offset <= tolerances.distance * frame.length:
                group.append(feature)
                break
        else:
            groups.append([feature])
    return groups


def axial_interval(feature: GpsFeature, group: GpsFeature) -> tuple[float, float]:
    """From where to where (mm) a feature reaches along the axis of ``group``."""
    z = (feature.points - group.place.point) @ np.array(group.place.direction)
    return float(z.min()), float(z.max())


def _drill_point(cone: GpsFeature, group: list[GpsFeature], near: float) -> bool:
    """Whether a cone closes to a point from the end of a hole of the group."""
    if cone.surface != "cone" or cone.material != "internal" or not len(cone.points):
        return False
    rho, _ = cylindrical_coordinates(
        cone.points, np.array(cone.place.point), np.array(cone.place.direction)
    )
    return bool(rho.min() <= near) and any(
        f.surface == "cylinder"
        and f.material == "internal"
        and abs(rho.max() - f.intrinsic["radius"]) <= near
        for f in group
    )


def _sunk_holes(group: list[GpsFeature], near: float) -> list[tuple[Kind, list[GpsFeature]]]:
    inner = [f for f in group if f.material == "internal" and len(f.points)]
    holes = [f for f in inner if f.surface == "cylinder"]
    found: list[tuple[Kind, list[GpsFeature]]] = []
    for hole in holes:
        radius, (low, high) = hole.intrinsic["radius"], axial_interval(hole, group[0])
        for other in inner:
            start, stop = axial_interval(other, group[0])
            if other is hole or min(abs(start - high), abs(stop - low)) > near:
                continue
            if other.surface == "cylinder" and other.intrinsic["radius"] > radius + near:
                found.append(("counterbore", [hole, other]))
            elif other.surface == "cone":
                rho, _ = cylindrical_coordinates(
                    other.points, np.array(hole.place.point), np.array(hole.place.direction)
                )
                if abs(rho.min() - radius) <= near:
                    found.append(("countersink", [hole, other]))
    return found


_NAMES: dict[Kind, Sentence] = {
    "coaxial group": Sentence("Coaxial group"),
    "counterbore": Sentence("Counterbore"),
    "countersink": Sentence("Countersink"),
}


def _compound(
    kind: Kind,
    members: list[GpsFeature],
    number: int,
    id_: int,
    frame: Frame,
    tolerances: Tolerances,
) -> GpsFeature:
    situations = tuple(s for member in members for s in member.situations)
    axis = members[0].place
    diameters = [m.size.value for m in members if m.size is not None and m.size.kind == "diameter"]
    return group_of(
        members,
        id_=id_,
        name=numbered(_NAMES[kind], number),
        kind=kind,
        invariance_class=invariance_of_union(situations, frame, tolerances).invariance_class,
        situations=situations,
        situation={"point": list(axis.point), "direction": list(axis.direction)},
        intrinsic={f"diameter_{i}": value for i, value in enumerate(diameters, start=1)},
        size=None,
        derived="common axis",
    )
