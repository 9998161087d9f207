# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moments of the ten quadratic monomials: distance to a plane, sphere or cylinder in O(1).

Slippage signatures don't see position: parallel planes a step apart, or coaxial cylinders of two
radii, slip alike. The moments sum w m m^T of m = (x^2, y^2, z^2, xy, yz, zx, x, y, z, 1) add over
regions and give the mean square of any quadratic function, hence how far a union is from one
surface.
"""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import FloatArray, IntArray
from gpswb.core.outer_sums import outer_sums


def quadric_moments(
    points: FloatArray, weights: FloatArray, label: IntArray, count: int
) -> FloatArray:
    """(r, 10, 10) moments of each region.

    Args:
        points: (n, 3), scaled to about 1 so that fourth powers stay comparable.
        weights: (n,).
        label: (n,) int region 0..count-1; negative for points of none.
        count: number of regions.
    """
    x, y, z = points.T
    one = np.ones_like(x)
    monomials = np.column_stack([x * x, y * y, z * z, x * y, y * z, z * x, x, y, z, one])
    return outer_sums(monomials, weights, label, count)


def plane_stand_off(moments: FloatArray) -> FloatArray:
    """(r,) RMS distance of each region to its best plane."""
    weight = np.maximum(moments[:, 9, 9], 1e-300)
    mean = moments[:, 6:9, 9] / weight[:, None]
    covariance = moments[:, 6:9, 6:9] / weight[:, None, None] - mean[:, :, None] * mean[:, None, :]
    thickness: FloatArray = np.sqrt(np.maximum(np.linalg.eigvalsh(covariance)[:, 0], 0.0))
    return thickness


def sphere_stand_off(moments: FloatArray) -> FloatArray:
    """(r,) RMS distance to the best algebraic sphere |p|^2 - 2 c.p - e = 0."""
    square = np.zeros(10)
    square[:3] = 1.0
    return _least(moments, np.broadcast_to(square, (len(moments), 10)), linear=True)


def cylinder_stand_off(moments: FloatArray, point: FloatArray, direction: FloatArray) -> FloatArray:
    """(r,) RMS distance to the best cylinder about each given axis (points and directions (r, 3)).

    Distances are (rho^2 - r^2) / (2 r) with r^2 the mean of rho^2: exact to first order.
    """
    dx, dy, dz = direction.T
    # |(p - a) x d|^2 = p^T (I - d d^T) p - 2 b.p + a.b with b = (I - d d^T) a.
    b = point - np.einsum("ri,ri->r", point, direction)[:, None] * direction
    quadric = np.column_stack(
        [1 - dx * dx, 1 - dy * dy, 1 - dz * dz, -2 * dx * dy, -2 * dy * dz, -2 * dz * dx]
    )
    constant = np.einsum("ri,ri->r", point, b)[:, None]
    return _least(moments, np.concatenate([quadric, -2.0 * b, constant], axis=1), linear=False)


def _least(moments: FloatArray, function: FloatArray, linear: bool) -> FloatArray:
    """RMS of a quadratic function over its gradient once a constant (and linear part) is fitted."""
    weight = np.maximum(moments[:, 9, 9], 1e-300)
    q = moments / weight[:, None, None]
    free = slice(6, 10) if linear else slice(9, 10)
    cross = np.einsum("rij,rj->ri", q[:, free], function)
    gram = q[:, free, free] + 1e-14 * np.eye(4 if linear else 1)
    fitted = np.linalg.solve(gram, cross[:, :, None])[:, :, 0]
    rest = function.copy()
    rest[:, free] -= fitted
    square = np.einsum("ri,rij,rj->r", rest, q, rest)
    gradient = _mean_square_gradient(q, rest)
    distance: FloatArray = np.sqrt(np.maximum(square, 0.0) / np.maximum(gradient, 1e-300))
    return distance


def _mean_square_gradient(q: FloatArray, f: FloatArray) -> FloatArray:
    """Mean of |grad f|^2, which is quadratic in p and so a matter of second moments."""
    a = np.zeros((len(f), 3, 3))
    for k in range(3):
        a[:, k, k] = 2.0 * f[:, k]
    for k, (i, j) in enumerate(((0, 1), (1, 2), (2, 0))):
        a[:, i, j] = a[:, j, i] = f[:, 3 + k]
    b = f[:, 6:9]
    second, first = q[:, 6:9, 6:9], q[:, 6:9, 9]
    squared = np.einsum("rki,rkj->rij", a, a)
    mixed = np.einsum("rki,rk->ri", a, b)
    mean: FloatArray = (
        np.einsum("rij,rij->r", squared, second)
        + 2.0 * np.einsum("ri,ri->r", mixed, first)
        + np.einsum("ri,ri->r", b, b)
    )
    return mean
