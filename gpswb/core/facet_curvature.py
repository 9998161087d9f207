# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curvature tensor of each facet from the normals at its corners (Rusinkiewicz 2004)."""

from __future__ import annotations

import numpy as np

from gpswb.core.facet_geometry import cross_product, dot
from gpswb.core.mesh import FloatArray

_USABLE = 1e-20  # share of trace^2 below which the determinant of a sliver is rounding


def facet_curvature(
    corner: FloatArray, corner_normal: FloatArray, normal: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Least-squares fit of dn = S dx to the three sides of each facet, S symmetric.

    In the frame (a, b) of the facet's plane, with a along its first side,
    S = mean I + even (a a^T - b b^T) + odd (a b^T + b a^T).

    Args:
        corner: (3, 3, m) corners, axis by axis, then corner by corner, mm.
        corner_normal: (3, 3, m) unit normals at the corners, in the same order.
        normal: (3, m) unit normals of the facets.

    Returns:
        The first side's direction a (3, m), and mean, even, odd (m,), 1/mm; zero for a degenerate
        facet.
    """
    side, other = corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 1]
    change, last = (corner_normal[:, k + 1] - corner_normal[:, k] for k in (0, 1))
    length = np.sqrt(dot(side, side))
    a = side / np.where(length > 0.0, length, np.inf)
    b = cross_product(normal, a)
    # Sides x and changes y in the frame; the third of each is minus the sum of the others.
    x, y = dot(a, other), dot(b, other)
    pa, pb, qa, qb = dot(a, change), dot(b, change), dot(a, last), dot(b, last)
    sum_x, sum_a, sum_b = length + x, pa + qa, pb + qb
    xx = length * length + x * x + sum_x * sum_x
    xy = y * (x + sum_x)
    yy = 2.0 * y * y
    r0 = length * pa + x * qa + sum_x * sum_a
    r1 = y * (qa + sum_a) + length * pb + x * qb + sum_x * sum_b
    r2 = y * (qb + sum_b)
    # Normal equations [[xx, xy, 0], [xy, xx+yy, xy], [0, xy, yy]] (e, f, g) = (r0, r1, r2):
    # their determinant is (xx + yy) (xx yy - xy^2), so the closed form needs one inverse.
    trace, determinant = xx + yy, 3.0 * (length * y) ** 2
    usable = determinant > _USABLE * trace * trace
    inverse = np.divide(1.0, trace * determinant, out=np.zeros_like(trace), where=usable)
    square, turned = xy * xy, xy * r1
    e = ((yy * yy + determinant) * r0 - yy * turned + square * r2) * inverse
    f = (xx * yy * r1 - xy * (yy * r0 + xx * r2)) * inverse
    g = (square * r0 - xx * turned + (xx * xx + determinant) * r2) * inverse
    return a, 0.5 * (e + g), 0.5 * (e - g), f
