# SPDX-License-Identifier: LGPL-2.1-or-later
"""Associated features: the ideal surface nearest to extracted points (ISO 22432, ISO 14405-1).

Total least squares, the Gaussian criterion, or minimax, the Chebyshev criterion.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from scipy.optimize import least_squares

from gpswb.core.mesh import FloatArray
from gpswb.core.robust.surfaces import UNKNOWNS, Kind, distance_jacobian
from gpswb.gps.minimax import minimax

Criterion = Literal["least squares", "minimax"]


@dataclass(frozen=True, eq=False)
class Associated:
    """An ideal feature associated with extracted points.

    Args:
        kind: plane, cylinder, cone, sphere or torus.
        surface: (8,) as in `gpswb.core.robust.surfaces`.
        deviations: (n,) signed distances of the points, mm.
    """

    kind: Kind
    surface: FloatArray
    deviations: FloatArray

    @property
    def zone(self) -> float:
        """Form deviation, mm: the width of the zone about the feature that holds all points."""
        return float(np.ptp(self.deviations))


def associate(
    kind: Kind, start: FloatArray, points: FloatArray, criterion: Criterion
) -> Associated | None:
    """The ideal feature nearest to the points; None if they are too few to determine it.

    Args:
        kind: of the feature.
        start: (8,) the nominal surface, or another near the points.
        points: (n, 3) extracted points, mm.
        criterion: which distance is made smallest: root mean square, or largest.
    """
    if len(points) <= UNKNOWNS[kind]:
        return None
    centre = points.mean(axis=0)
    size = float(np.linalg.norm(np.ptp(points, axis=0))) or 1.0
    x = (points - centre) / size

    def evaluate(free: FloatArray) -> tuple[FloatArray, FloatArray]:
        length = float(np.linalg.norm(free[3:6])) or 1.0
        u = free[3:6] / length
        row = np.r_[free[:3], u, free[6:]]
        d, jacobian = distance_jacobian(kind, row[None], x[None])
        jacobian = jacobian[0]
        jacobian[:, 3:6] = jacobian[:, 3:6] @ (np.eye(3) - np.outer(u, u)) / length
        return d[0], jacobian

    free = _scaled(kind, start, centre, size)
    solved = least_squares(
        lambda p: evaluate(p)[0],
        free,
        jac=lambda p: evaluate(p)[1],
        xtol=1e-15,
        ftol=1e-15,
        gtol=1e-15,
    )
    free = solved.x
    if criterion == "minimax":
        largest = float(np.abs(evaluate(free)[0]).max())
        free = minimax(evaluate, free, trust=10.0 * largest + 1e-12)
    deviations = evaluate(free)[0] * size
    return Associated(kind, _unscaled(kind, free, centre, size), deviations)


def _scaled(kind: Kind, surface: FloatArray, centre: FloatArray, size: float) -> FloatArray:
    """The surface in the frame of the scaled points; its point moved near them along the axis."""
    row = np.array(surface, dtype=np.float64)
    row[:3] = (row[:3] - centre) / size
    if kind in ("plane", "cylinder", "cone"):
        u = row[3:6] / np.linalg.norm(row[3:6])
        shift = -float(row[:3] @ u)
        row[:3] += shift * u
        if kind == "cone":
            row[6] += shift * size * np.sin(row[7])
    row[6] /= size
    if kind == "torus":
        row[7] /= size
    return row


def _unscaled(kind: Kind, free: FloatArray, centre: FloatArray, size: float) -> FloatArray:
    row = free.copy()
    row[:3] = row[:3] * size + centre
    row[3:6] /= np.linalg.norm(row[3:6]) or 1.0
    row[6] *= size
    if kind == "torus":
        row[7] *= size
    return row
