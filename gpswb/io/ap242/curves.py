# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points along edges (ISO 10303-42 curves), enough to tell a face by its border."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.interpolate import BSpline

from gpswb.core.mesh import FloatArray
from gpswb.errors import InputError
from gpswb.io.ap242.part21 import Part21, Ref, Value
from gpswb.io.ap242.placement import placement, point
from gpswb.io.ap242.units import number_of

_STRAIGHT, _ROUND, _WINDING = 4, 64, 128
"""Pieces that an edge is cut into. A chord of a 64th turn is 0.1 % of the radius off the arc; free
curves may wind, as a thread's edges do."""
_WRAPPED = {
    "SURFACE_CURVE": 1, "SEAM_CURVE": 1, "INTERSECTION_CURVE": 1, "BOUNDED_SURFACE_CURVE": 1,
    "TRIMMED_CURVE": 1,
}  # fmt: skip
_MOST_POLES = 20_000


def edge_points(file: Part21, edge: Value, mm: float) -> FloatArray:
    """(k, 3) mm along an EDGE_CURVE from its start to its end; a curve of a kind that isn't known
    is taken as straight.

    Raises:
        InputError: the edge has no ends.
    """
    found = file.get(edge, "EDGE_CURVE")
    if found is None or len(found) < 5:
        raise InputError(f"entity #{edge} of the STEP file is no edge")
    start, end = point(file, found[1], mm), point(file, found[2], mm)
    forward = found[4] != "F"
    curve = found[3]
    for _ in range(4):
        keyword = next((k for k in _keywords(file, curve) if k in _WRAPPED), None)
        if keyword is None or not isinstance(curve, Ref):
            break
        curve = file[curve][keyword][_WRAPPED[keyword]]
    ends = (start, end) if forward else (end, start)
    points = _along(file, curve, ends, mm)
    return points if forward else points[::-1]


def _keywords(file: Part21, number: Value) -> tuple[str, ...]:
    return file.keywords(number) if isinstance(number, Ref) and number in file else ()


def _along(
    file: Part21, curve: Value, ends: tuple[FloatArray, FloatArray], mm: float
) -> FloatArray:
    for keyword in _keywords(file, curve):
        sampler = _SAMPLERS.get(keyword)
        if sampler is not None:
            return sampler(file, curve, ends, mm)
    return np.linspace(*ends, _STRAIGHT + 1)


def _conic(
    file: Part21, curve: Value, ends: tuple[FloatArray, FloatArray], mm: float
) -> FloatArray:
    """An arc of a CIRCLE or ELLIPSE, counter-clockwise about its axis."""
    assert isinstance(curve, Ref)
    keyword = "CIRCLE" if "CIRCLE" in file.keywords(curve) else "ELLIPSE"
    parameters = file[curve][keyword]
    radii = [r * mm for r in map(number_of, parameters[2:]) if r is not None]
    if not radii or min(radii) <= 0:
        return np.linspace(*ends, _STRAIGHT + 1)
    frame = placement(file, parameters[1], mm)
    first, second = radii[0], radii[-1]
    angle = [
        float(np.arctan2((p @ frame[:3, 1]) / second, (p @ frame[:3, 0]) / first))
        for p in (e - frame[:3, 3] for e in ends)
    ]
    closed = float(np.linalg.norm(ends[1] - ends[0])) <= 1e-6 * max(first, second)
    sweep = 2 * np.pi if closed else (angle[1] - angle[0]) % (2 * np.pi)
    turn = angle[0] + np.linspace(0.0, sweep, _ROUND + 1)
    x, y = first * np.cos(turn), second * np.sin(turn)
    return np.asarray(frame[:3, 3] + np.outer(x, frame[:3, 0]) + np.outer(y, frame[:3, 1]))


def _open_conic(
    file: Part21, curve: Value, ends: tuple[FloatArray, FloatArray], mm: float
) -> FloatArray:
    """A piece of a HYPERBOLA or PARABOLA."""
    assert isinstance(curve, Ref)
    keyword = "HYPERBOLA" if "HYPERBOLA" in file.keywords(curve) else "PARABOLA"
    parameters = file[curve][keyword]
    sizes = [s * mm for s in map(number_of, parameters[2:]) if s is not None]
    if not sizes or min(sizes) <= 0:
        return np.linspace(*ends, _STRAIGHT + 1)
    frame = placement(file, parameters[1], mm)
    heights = [float((end - frame[:3, 3]) @ frame[:3, 1]) for end in ends]
    if keyword == "HYPERBOLA":
        low, high = (float(np.arcsinh(height / sizes[-1])) for height in heights)
        t = np.linspace(low, high, _ROUND + 1)
        x, y = sizes[0] * np.cosh(t), sizes[-1] * np.sinh(t)
    else:
        y = np.linspace(heights[0], heights[1], _ROUND + 1)
        x = y**2 / (4.0 * sizes[0])
    return np.asarray(frame[:3, 3] + np.outer(x, frame[:3, 0]) + np.outer(y, frame[:3, 1]))


def _polyline(
    file: Part21, curve: Value, ends: tuple[FloatArray, FloatArray], mm: float
) -> FloatArray:
    assert isinstance(curve, Ref)
    corners = file[curve]["POLYLINE"][1]
    if not isinstance(corners, tuple) or len(corners) < 2:
        return np.linspace(*ends, _STRAIGHT + 1)
    return _between(np.array([point(file, p, mm) for p in corners]), ends)


def _spline(
    file: Part21, curve: Value, ends: tuple[FloatArray, FloatArray], mm: float
) -> FloatArray:
    """The piece of a B-spline curve between its ends."""
    assert isinstance(curve, Ref)
    record = file[curve]
    if "B_SPLINE_CURVE" in record:
        degree, poles = record["B_SPLINE_CURVE"][:2]
        knots = record.get("B_SPLINE_CURVE_WITH_KNOTS", ())[:2]
    else:
        parameters = record["B_SPLINE_CURVE_WITH_KNOTS"]
        degree, poles, knots = parameters[1], parameters[2], parameters[6:8]
    rational = record.get("RATIONAL_B_SPLINE_CURVE", ((),))[0]
    if not isinstance(poles, tuple) or not isinstance(degree, int) or len(poles) > _MOST_POLES:
        return np.linspace(*ends, _STRAIGHT + 1)
    control = np.array([point(file, p, mm) for p in poles])
    weights = np.array(
        [number_of(w) or 1.0 for w in rational] if isinstance(rational, tuple) else []
    )
    if len(weights) != len(control):
        weights = np.ones(len(control))
    vector = _knots(knots, len(control), degree)
    if vector is None:
        return np.linspace(*ends, _STRAIGHT + 1)
    lifted = np.column_stack([control * weights[:, None], weights])
    t = np.linspace(vector[degree], vector[len(control)], 4 * _WINDING + 1)
    value = BSpline(vector, lifted, degree)(t)
    return _between(np.asarray(value[:, :3] / value[:, 3:]), ends)


def _knots(knots: tuple[Value, ...], poles: int, degree: int) -> FloatArray | None:
    """Knot vector with repetitions; None if it doesn't fit the poles."""
    if len(knots) != 2 or not isinstance(knots[0], tuple) or not isinstance(knots[1], tuple):
        return None
    times = [m if isinstance(m, int) and 0 < m <= _MOST_POLES else 0 for m in knots[0]]
    values = [number_of(v) for v in knots[1]]
    if len(times) != len(values) or sum(times) != poles + degree + 1 or None in values:
        return None
    vector = np.repeat(np.array(values, dtype=np.float64), times)
    return vector if degree >= 1 and np.all(np.diff(vector) >= 0) else None


def _between(points: FloatArray, ends: tuple[FloatArray, FloatArray]) -> FloatArray:
    """The part of a curve's points (k, 3) between two ends, through the start of a closed curve."""
    first, last = (int(np.argmin(np.linalg.norm(points - end, axis=1))) for end in ends)
    size = float(np.linalg.norm(np.ptp(points, axis=0)))
    if float(np.linalg.norm(ends[1] - ends[0])) <= 1e-6 * size:
        piece = np.roll(points[:-1], -first, axis=0)
    elif first <= last:
        piece = points[first : last + 1]
    else:
        piece = np.concatenate([points[first:], points[: last + 1]])
    keep = np.unique(np.linspace(0, len(piece) - 1, _WINDING + 1).round().astype(int))
    return np.concatenate([[ends[0]], piece[keep][1:-1], [ends[1]]])


_Sampler = Callable[[Part21, Value, tuple[FloatArray, FloatArray], float], FloatArray]
_SAMPLERS: dict[str, _Sampler] = {
    "CIRCLE": _conic,
    "ELLIPSE": _conic,
    "HYPERBOLA": _open_conic,
    "PARABOLA": _open_conic,
    "POLYLINE": _polyline,
    "B_SPLINE_CURVE_WITH_KNOTS": _spline,
}
