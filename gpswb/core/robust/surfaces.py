# SPDX-License-Identifier: LGPL-2.1-or-later
"""Signed distance of points to plane, cylinder, cone, sphere and torus, for many surfaces at once.

Every surface is a row of eight numbers: point (3), direction (3), ``a``, ``b``:

========  ===========================  =========  ==================
kind      point, direction             a          b
========  ===========================  =========  ==================
plane     any point, normal            -          -
cylinder  axis                         radius     -
cone      axis                         r·cos φ    half angle φ (rad)
sphere    centre, -                    radius     -
torus     centre, axis                 R          r
========  ===========================  =========  ==================

where r of the cone is its radius at ``point``.
"""

from __future__ import annotations

from typing import Literal

import numpy as np

from gpswb.core.mesh import FloatArray

Kind = Literal["plane", "cylinder", "cone", "sphere", "torus"]

UNKNOWNS: dict[Kind, int] = {"plane": 3, "cylinder": 5, "cone": 6, "sphere": 4, "torus": 7}
"""Degrees of freedom of each kind: points beyond this number are evidence."""

TINY = 1e-300


def distance(kind: Kind, surface: FloatArray, points: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Signed distances and their gradients with respect to the points.

    Args:
        kind: what the rows of ``surface`` are.
        surface: (b, 8) surfaces.
        points: (b, n, 3), mm.

    Returns:
        (b, n) distances, mm, and (b, n, 3) unit normals of the surface at the points.
    """
    d, normal, _ = _evaluate(kind, surface, points, jacobian=False)
    return d, normal


def distance_jacobian(
    kind: Kind, surface: FloatArray, points: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """(b, n) signed distances and (b, n, 8) derivatives with respect to the surface's numbers."""
    d, _, jacobian = _evaluate(kind, surface, points, jacobian=True)
    return d, jacobian


def _evaluate(
    kind: Kind, surface: FloatArray, points: FloatArray, jacobian: bool
) -> tuple[FloatArray, FloatArray, FloatArray]:
    # Axis by axis, each (b, n) in a row of memory: several times faster than (b, n, 3) at once.
    x = np.empty((len(points), 3, points.shape[1]))
    np.subtract(np.swapaxes(points, 1, 2), surface[:, :3, None], out=x)
    rows = np.zeros((len(x), 8, x.shape[2]) if jacobian else (0, 8, 0))
    u, a, b = surface[:, 3:6, None], surface[:, 6, None], surface[:, 7, None]
    if kind == "sphere":
        length = _normalise(x)
        if jacobian:
            np.negative(x, out=rows[:, 0:3])
            rows[:, 6] = -1.0
        return length - a, _last(x), _last(rows)
    t = (surface[:, None, 3:6] @ x)[:, 0]
    if kind == "plane":
        along = np.broadcast_to(surface[:, None, 3:6], points.shape)
        if jacobian:
            rows[:, 0:3] = -u
            np.subtract(x, u * t[:, None], out=rows[:, 3:6])
        return t, along, _last(rows)
    x -= u * t[:, None]
    rho = _normalise(x)
    if kind == "cylinder":
        if jacobian:
            np.negative(x, out=rows[:, 0:3])
            np.multiply(rows[:, 0:3], t[:, None], out=rows[:, 3:6])
            rows[:, 6] = -1.0
        return rho - a, _last(x), _last(rows)
    if kind == "cone":
        cos, sin = np.cos(b), np.sin(b)
        normal = cos[:, None] * x - sin[:, None] * u
        along = t * cos + rho * sin
        if jacobian:
            np.negative(normal, out=rows[:, 0:3])
            np.multiply(x, -along[:, None], out=rows[:, 3:6])
            rows[:, 6] = -1.0
            np.negative(along, out=rows[:, 7])
        return rho * cos - t * sin - a, _last(normal), _last(rows)
    beyond = rho - a
    tube = np.sqrt(beyond * beyond + t * t)
    inverse = 1.0 / np.maximum(tube, TINY)
    f, g = beyond * inverse, t * inverse
    normal = f[:, None] * x + g[:, None] * u
    if jacobian:
        np.negative(normal, out=rows[:, 0:3])
        np.multiply(x, (g * rho - f * t)[:, None], out=rows[:, 3:6])
        np.negative(f, out=rows[:, 6])
        rows[:, 7] = -1.0
    return tube - b, _last(normal), _last(rows)


def _normalise(x: FloatArray) -> FloatArray:
    """(b, n) lengths of (b, 3, n) vectors, which are made unit vectors in place."""
    length: FloatArray = np.sqrt(np.einsum("bkn,bkn->bn", x, x))
    x *= (1.0 / np.maximum(length, TINY))[:, None]
    return length


def _last(rows: FloatArray) -> FloatArray:
    """(b, n, k) view of (b, k, n) rows."""
    return np.swapaxes(rows, 1, 2)


def largest_curvature(kind: Kind, surface: FloatArray, points: FloatArray) -> FloatArray:
    """(n,) largest absolute principal curvature, 1/mm, of one (8,) surface near (n, 3) points."""
    n = len(points)
    if kind == "plane":
        return np.zeros(n)
    if kind in ("cylinder", "sphere"):
        return np.full(n, 1.0 / max(abs(float(surface[6])), TINY))
    x = points - surface[:3]
    rho = np.linalg.norm(x - np.outer(x @ surface[3:6], surface[3:6]), axis=1)
    if kind == "cone":
        around: FloatArray = np.abs(np.cos(surface[7])) / np.maximum(rho, TINY)
        return around
    across = np.abs(rho - surface[6]) / np.maximum(rho, TINY) / max(abs(float(surface[7])), TINY)
    largest: FloatArray = np.maximum(across, 1.0 / max(abs(float(surface[7])), TINY))
    return largest
