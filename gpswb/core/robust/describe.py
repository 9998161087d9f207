# SPDX-License-Identifier: LGPL-2.1-or-later
"""Situation feature and intrinsic characteristics of a surface found by consensus."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import FloatArray
from gpswb.core.robust.growth import Grown
from gpswb.core.robust.surfaces import distance


def describe_surface(
    grown: Grown, points: FloatArray
) -> tuple[str, dict[str, list[float]], dict[str, float], float]:
    """Name, situation, intrinsic characteristics and RMS residual (mm) of a surface.

    Args:
        grown: the surface.
        points: (n, 3) mm vertices of its region.

    Returns:
        As `situation.describe`, and the RMS distance of the points.
    """
    s = grown.surface
    point, direction = s[:3], s[3:6]
    d, _ = distance(grown.kind, s[None], points[None])
    residual = float(np.sqrt(np.mean(d**2))) if len(points) else 0.0
    axis = {"point": point.tolist(), "direction": direction.tolist()}
    if grown.kind == "plane":
        return "plane", {"point": point.tolist(), "normal": direction.tolist()}, {}, residual
    if grown.kind == "sphere":
        return "sphere", {"point": point.tolist()}, {"radius": float(s[6])}, residual
    if grown.kind == "cylinder":
        return "cylinder", axis, {"radius": float(s[6])}, residual
    if grown.kind == "torus":
        sizes = {"major_radius": abs(float(s[6])), "minor_radius": abs(float(s[7]))}
        return "torus", axis, sizes, residual
    apex = point - s[6] / np.sin(s[7]) * direction if abs(np.sin(s[7])) > 1e-9 else point
    axis["point"] = apex.tolist()
    return "cone", axis, {"half_angle_deg": abs(float(np.degrees(s[7])))}, residual
