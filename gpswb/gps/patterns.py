# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patterns n × Ø: equal parallel cylinders in a row, a grid or on a circle."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gpswb.core.mesh import FloatArray
from gpswb.gps.coaxial import axial_interval
from gpswb.gps.gps_feature import GpsFeature, group_of, numbered
from gpswb.gps.invariance_of_union import invariance_of_union
from gpswb.gps.tolerances import DEFAULT, Tolerances
from gpswb.gps.twists import Frame, perpendiculars
from gpswb.sentence import Sentence


def hole_patterns(
    features: Sequence[GpsFeature],
    frame: Frame,
    first_id: int,
    tolerances: Tolerances = DEFAULT,
) -> list[GpsFeature]:
    """Two or more equal holes (or pins) with parallel axes that lie side by side.

    They go all round: rounded ends of a flange that cover more than half a turn are no pins.
    The arrangement is linear, circle (evenly spaced, or about a round feature), grid, or free where
    it is none of these; ``intrinsic`` gives count, diameter, and pitches or pitch circle (mm).
    """
    round_ = [
        f
        for f in features
        if f.surface == "cylinder" and f.size and f.whole and f.material != "neither"
        if len(f.points)
    ]
    groups: list[list[GpsFeature]] = []
    for feature in sorted(round_, key=lambda f: f.id):
        for group in groups:
            if _alike(feature, group[0], tolerances):
                group.append(feature)
                break
        else:
            groups.append([feature])
    compounds: list[GpsFeature] = []
    counts = {"internal": 0, "external": 0}
    near = 10 * tolerances.distance * frame.length
    for group in (g for g in groups if len(g) > 1):
        u, w = perpendiculars(group[0].place.direction)
        basis = np.column_stack([u, w])
        spots = np.array([f.place.point for f in group]) @ basis
        others = [
            f.place.point @ basis
            for f in features
            if f.place.has_axis and f not in group and _parallel(f, group[0], tolerances)
        ]
        counts[group[0].material] += 1
        number = counts[group[0].material]
        spread = _arrangement(spots, near, np.reshape(others, (-1, 2)))
        id_ = first_id + len(compounds)
        compounds.append(_compound(group, id_, number, spread, frame, tolerances))
    return compounds


def _alike(one: GpsFeature, other: GpsFeature, tolerances: Tolerances) -> bool:
    if (one.body, one.material) != (other.body, other.material):
        return False
    if one.size is None or other.size is None:
        return False
    if abs(one.size.value - other.size.value) > tolerances.size * other.size.value:
        return False
    if not _parallel(one, other, tolerances):
        return False
    low, high = axial_interval(one, other)
    start, stop = axial_interval(other, other)
    return low < stop and start < high


def _parallel(one: GpsFeature, other: GpsFeature, tolerances: Tolerances) -> bool:
    cross = np.cross(one.place.direction, other.place.direction)
    return bool(np.linalg.norm(cross) <= np.sin(tolerances.angle))


def _arrangement(
    spots: FloatArray, near: float, others: FloatArray
) -> tuple[str, dict[str, float]]:
    """Arrangement of axes at spots (n, 2) mm; ``others`` (k, 2) are other round features' axes.

    Four in a square are a grid, and a circle too: on a circle if something is at its centre.
    """
    n = len(spots)
    away = spots - spots.mean(axis=0)
    _, _, turn = np.linalg.svd(away)
    along, across = (away @ turn.T).T
    if np.abs(across).max() <= near:
        steps = np.diff(np.sort(along))
        if np.ptp(steps) <= near:
            return "linear", {"pitch": float(steps.mean())}
        return "free", {}
    radii = np.linalg.norm(away, axis=1)
    turns = np.diff(np.sort(np.arctan2(away[:, 1], away[:, 0])))
    circle = np.ptp(radii) <= near and np.abs(turns - 2 * np.pi / n).max() * radii.mean() <= near
    pitch_circle = {"pitch_circle_diameter": float(2 * radii.mean())}
    if circle and (n != 4 or _any_at(others, spots.mean(axis=0), near)):
        return "circle", pitch_circle
    distances = np.linalg.norm(spots[:, None] - spots[None], axis=2)
    np.fill_diagonal(distances, np.inf)
    i, j = divmod(int(np.argmin(distances)), n)
    side = (spots[j] - spots[i]) / distances[i, j]
    columns = _levels(spots @ side, near)
    rows = _levels(spots @ np.array([-side[1], side[0]]), near)
    if columns is not None and rows is not None and columns[0] * rows[0] == n:
        return "grid", {
            "columns": columns[0],
            "column_pitch": columns[1],
            "rows": rows[0],
            "row_pitch": rows[1],
        }
    centre, radius = _fitted_circle(spots)
    on_it = np.abs(np.linalg.norm(spots - centre, axis=1) - radius).max() <= near
    if on_it and _any_at(others, centre, near):
        return "circle", {"pitch_circle_diameter": 2 * radius}
    return "free", {}


def _any_at(points: FloatArray, place: FloatArray, near: float) -> bool:
    return bool((np.linalg.norm(points - place, axis=1) <= near).any())


def _fitted_circle(points: FloatArray) -> tuple[FloatArray, float]:
    """Centre and radius of the circle x² + y² = 2 a x + 2 b y + c by least squares."""
    middle = points.mean(axis=0)
    away = points - middle
    table = np.column_stack([2 * away, np.ones(len(away))])
    a, b, c = np.linalg.lstsq(table, (away**2).sum(axis=1), rcond=None)[0]
    return middle + np.array([a, b]), float(np.sqrt(max(a * a + b * b + c, 0.0)))


def _levels(values: FloatArray, near: float) -> tuple[int, float] | None:
    """Count and pitch of evenly spaced levels, or None."""
    ordered = np.sort(values)
    steps = np.diff(ordered)
    steps = steps[steps > near]
    if not len(steps) or np.ptp(steps) > near:
        return None
    return len(steps) + 1, float(steps.mean())


def _compound(
    group: list[GpsFeature],
    id_: int,
    number: int,
    spots: tuple[str, dict[str, float]],
    frame: Frame,
    tolerances: Tolerances,
) -> GpsFeature:
    arrangement, pitches = spots
    holes = group[0].material == "internal"
    union = invariance_of_union([f.place for f in group], frame, tolerances)
    return group_of(
        group,
        id_=id_,
        name=numbered(Sentence("Hole pattern") if holes else Sentence("Pin pattern"), number),
        kind="hole pattern" if holes else "pin pattern",
        invariance_class=union.invariance_class,
        situations=tuple(f.place for f in group),
        situation={"point": list(union.point), "direction": list(union.direction)},
        intrinsic={"count": len(group), "diameter": 2 * group[0].intrinsic["radius"], **pitches},
        size=group[0].size,
        derived="median lines",
        arrangement=arrangement,
    )
