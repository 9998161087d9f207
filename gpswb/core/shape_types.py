# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ten local shape types (paper, equation 8 and Table 5) and the sharp edge."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import BoolArray, FloatArray, IntArray

PLANE = 5
"""Shape type of a plane point (T = 5 in the paper)."""

SHARP_EDGE = 6
"""Label of a point on a sharp edge; the paper keeps sharp edges as an eleventh cluster."""

SHAPE_TYPE_NAMES: dict[int, str] = {
    -4: "spherical cup",
    -3: "trough",
    -2: "rut",
    -1: "saddle rut",
    0: "saddle",
    1: "saddle ridge",
    2: "ridge",
    3: "dome",
    4: "spherical cap",
    PLANE: "plane",
    SHARP_EDGE: "sharp edge",
}
"""Names of Table 5, with the sharp edge."""


def shape_types(index: FloatArray, plane: BoolArray) -> IntArray:
    """Shape type T = floor(4 s + 1/2), or 5 where the surface is plane (equation 8).

    Args:
        index: (n,) shape index in [-1, 1].
        plane: (n,) bool, true where the curvedness says plane.

    Returns:
        (n,) int64 in -4..5.
    """
    types = np.floor(4.0 * index + 0.5).astype(np.int64)
    return np.where(plane, np.int64(PLANE), np.clip(types, -4, 4))


def plane_by_curvedness(curvedness: FloatArray, limit: float) -> BoolArray:
    """Plane where c <= p_c, as printed; the limit carries the unit of the curvedness, 1/mm."""
    plane: BoolArray = curvedness <= limit
    return plane


def plane_by_sagitta(curvedness: FloatArray, length: FloatArray, tolerance: float) -> BoolArray:
    """Plane where the sagitta c l^2 / 8 over the local edge length stays below a tolerance.

    Args:
        curvedness: (n,) 1/mm.
        length: (n,) local edge length, mm.
        tolerance: mm.
    """
    plane: BoolArray = curvedness * length**2 / 8.0 <= tolerance
    return plane
