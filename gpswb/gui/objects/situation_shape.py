# SPDX-License-Identifier: LGPL-2.1-or-later
"""A region's situation feature as thin geometry: its axis, centre point or plane."""

from __future__ import annotations

from typing import Any

import numpy as np
import Part
from FreeCAD import Vector

from gpswb.core.mesh import FloatArray
from gpswb.core.partition import Region

OVERHANG = 0.15
"""An axis stands out at both ends by this fraction of its feature's extent, as on a drawing."""
PLANE = 0.12
"""Side of the square that stands for a plane, of its feature's extent."""


def situation_shape(region: Region, points: FloatArray) -> Any:
    """A FreeCAD shape: edges and vertices only.

    Args:
        region: the region.
        points: (n, 3) its vertices, for how far the geometry reaches.
    """
    size = float(np.linalg.norm(np.ptp(points, axis=0))) or 1.0
    point = np.array(region.situation.get("point", points.mean(axis=0)))
    if region.invariance_class == "planar":
        return _plane(points, np.array(region.situation["normal"]))
    if region.invariance_class in ("spherical", "complex") or "direction" not in region.situation:
        return _cross(point, 0.1 * size)
    direction = np.array(region.situation["direction"])
    if region.invariance_class == "prismatic":  # its axis may lie anywhere: show it on the surface
        point = points.mean(axis=0)
    along = (points - point) @ direction
    over = OVERHANG * max(float(np.ptp(along)), 0.3 * size)
    low, high = along.min() - over, along.max() + over
    line = Part.makeLine(_vector(point + low * direction), _vector(point + high * direction))
    if region.invariance_class == "revolute" and low <= 0.0 <= high:
        return Part.makeCompound([line, _cross(point, 0.05 * size)])
    return line


def _plane(points: FloatArray, normal: FloatArray) -> Any:
    """A small square in the plane, amid its feature, with its normal: outlines as large as the
    features would hide one another."""
    low, high = points.min(axis=0), points.max(axis=0)
    side = PLANE * float(np.linalg.norm(high - low))
    u = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
    u *= side / 2 / np.linalg.norm(u)
    v = np.cross(normal, u)
    middle = (low + high) / 2
    middle -= ((middle - points.mean(axis=0)) @ normal) * normal
    corners = [_vector(middle + a * u + b * v) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    square = Part.makePolygon([*corners, corners[0]])
    arrow = Part.makeLine(_vector(middle), _vector(middle + side * normal))
    return Part.makeCompound([square, arrow])


def _cross(point: FloatArray, arm: float) -> Any:
    """A point, and three short lines through it that make it seen."""
    lines = [
        Part.makeLine(_vector(point - arm * axis), _vector(point + arm * axis))
        for axis in np.eye(3)
    ]
    return Part.makeCompound([Part.Vertex(_vector(point)), *lines])


def _vector(point: FloatArray) -> Any:
    return Vector(*point.tolist())
