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
    origin, u = surface[:, None, 0:3], surface[:, None, 3:6]
    a, b = surface[:, None, 6], surface[:, None, 7]
    x = points - origin
    jac = np.zeros((*x.shape[:2], 8) if jacobian else (0, 0, 8))
    if kind == "sphere":
        length = np.sqrt(np.einsum("bnk,bnk->bn", x, x))
        normal = x / np.maximum(length, TINY)[..., None]
        if jacobian:
            jac[..., 0:3] = -normal
            jac[..., 6] = -1.0
        return length - a, normal, jac
    t = np.einsum("bnk,bnk->bn", x, np.broadcast_to(u, x.shape))
    if kind == "plane":
        if jacobian:
            jac[..., 0:3] = -u
            jac[..., 3:6] = x - t[..., None] * u
        return t, np.broadcast_to(u, x.shape), jac
    radial = x - t[..., None] * u
    rho = np.sqrt(np.einsum("bnk,bnk->bn", radial, radial))
    e = radial / np.maximum(rho, TINY)[..., None]
    if kind == "cylinder":
        if jacobian:
            jac[..., 0:3] = -e
            jac[..., 3:6] = -t[..., None] * e
            jac[..., 6] = -1.0
        return rho - a, e, jac
    if kind == "cone":
        cos, sin = np.cos(b), np.sin(b)
        normal = cos[..., None] * e - sin[..., None] * u
        if jacobian:
            jac[..., 0:3] = -normal
            jac[..., 3:6] = -(t * cos + rho * sin)[..., None] * e
            jac[..., 6] = -1.0
            jac[..., 7] = -rho * sin - t * cos
        return rho * cos - t * sin - a, normal, jac
    tube = np.sqrt((rho - a) ** 2 + t**2)
    f, g = (rho - a) / np.maximum(tube, TINY), t / np.maximum(tube, TINY)
    normal = f[..., None] * e + g[..., None] * u
    if jacobian:
        jac[..., 0:3] = -normal
        jac[..., 3:6] = (g * rho - f * t)[..., None] * e
        jac[..., 6] = -f
        jac[..., 7] = -1.0
    return tube - b, normal, jac


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
