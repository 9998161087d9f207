# SPDX-License-Identifier: LGPL-2.1-or-later
"""Frames of tangent planes, and the angle between two of them."""

from __future__ import annotations

import numpy as np

from gpswb.core.facet_geometry import dot
from gpswb.core.mesh import FloatArray

ComplexArray = np.ndarray[tuple[int, ...], np.dtype[np.complex128]]


def tangent_frame(normals: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Two unit vectors (n, 3) that complete each unit normal to a right-handed frame.

    Branch on the sign of n_z only (Duff et al. 2017): no normal is near a singularity.
    """
    x, y, z = normals.T
    sign = np.where(z >= 0.0, 1.0, -1.0)
    a = -1.0 / (sign + z)
    b = x * y * a
    u = np.stack([1.0 + sign * x * x * a, sign * b, -sign * x], axis=1)
    v = np.stack([b, sign + y * y * a, -y], axis=1)
    return u, v


def turned_direction(
    vector: FloatArray, start: FloatArray, end: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """A tangent vector at one normal, turned to another by the least rotation, in its frame.

    The rotation is R x = x - (end.x) (start + end) / (1 + start.end). All vectors are stored axis
    by axis.

    Args:
        vector: (3, ...) unit vectors perpendicular to ``start``.
        start, end: (3, ...) unit normals.

    Returns:
        Cosine and sine (...) of the angle from the first vector of `tangent_frame` at ``end``.
    """
    cosine = dot(start, end)
    scale = np.divide(1.0, 1.0 + cosine, out=np.zeros_like(cosine), where=cosine > -0.99)
    scale *= dot(end, vector)
    qx, qy, qz = (v - scale * (s + e) for v, s, e in zip(vector, start, end, strict=True))
    # The frame's vectors times q, with q perpendicular to the normal.
    x, y, z = end
    sign = np.where(z >= 0.0, 1.0, -1.0)
    slope = qz / (1.0 + np.abs(z))
    return qx - sign * x * slope, sign * qy - y * slope
