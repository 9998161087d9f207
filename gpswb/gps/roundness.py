# SPDX-License-Identifier: LGPL-2.1-or-later
"""Roundness in sections across an axis (ISO 12181)."""

from __future__ import annotations

import numpy as np
from scipy.optimize import least_squares

from gpswb.core.mesh import FloatArray
from gpswb.gps.minimax import minimax

SECTION = 60
"""Points of a section that roundness is worth judging by: 6 degrees apart on a whole turn."""

MOST_SECTIONS = 10


def roundness(
    points: FloatArray, origin: FloatArray, axis: FloatArray
) -> tuple[float, float, int] | None:
    """Largest roundness deviation over sections of a cylinder.

    A section is a slice of the points across the axis; slices hold equally many. Within each, the
    deviation is that from the least-squares circle and from the minimum-zone circle.

    Args:
        points: (n, 3) extracted points, mm.
        origin, axis: (3,) of the associated cylinder; the axis is a unit vector.

    Returns:
        Roundness by least squares, by minimum zone, mm, and the number of sections; None if there
        are too few points for one.
    """
    sections = min(MOST_SECTIONS, len(points) // SECTION)
    if sections < 1:
        return None
    along = (points - origin) @ axis
    helper = np.eye(3)[int(np.argmin(np.abs(axis)))]
    u = np.cross(axis, helper)
    u /= np.linalg.norm(u)
    plane = np.column_stack([(points - origin) @ u, (points - origin) @ np.cross(axis, u)])
    gauss, zone = 0.0, 0.0
    for part in np.array_split(np.argsort(along, kind="stable"), sections):
        a, b = _circle(plane[part])
        gauss, zone = max(gauss, a), max(zone, b)
    return gauss, zone, sections


def _circle(points: FloatArray) -> tuple[float, float]:
    """Widths of the rings about the least-squares and the minimum-zone circle, mm."""
    size = float(np.linalg.norm(np.ptp(points, axis=0))) or 1.0
    x = (points - points.mean(axis=0)) / size

    def evaluate(c: FloatArray) -> tuple[FloatArray, FloatArray]:
        arm = x - c[:2]
        length = np.maximum(np.linalg.norm(arm, axis=1), 1e-300)
        return length - c[2], np.column_stack([-arm / length[:, None], -np.ones(len(x))])

    # The algebraic circle: x² + y² = 2 a x + 2 b y + c.
    rows = np.column_stack([2 * x, np.ones(len(x))])
    a, b, c = np.linalg.lstsq(rows, (x**2).sum(axis=1), rcond=None)[0]
    start = np.array([a, b, np.sqrt(max(c + a * a + b * b, 0.0))])
    best = least_squares(
        lambda p: evaluate(p)[0], start, jac=lambda p: evaluate(p)[1], xtol=1e-15, ftol=1e-15
    ).x
    gauss = float(np.ptp(evaluate(best)[0]))
    least = minimax(evaluate, best, trust=10.0 * gauss + 1e-12)
    return size * gauss, size * float(np.ptp(evaluate(least)[0]))
