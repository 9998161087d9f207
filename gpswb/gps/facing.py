# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which parallel planes a plane faces, and over what share of it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from gpswb.core.mesh import FloatArray
from gpswb.gps.gps_feature import GpsFeature
from gpswb.gps.twists import perpendiculars

_SAMPLES = 200
_BLOCK = 4096
"""Triangles that are tested at once: bounds the memory."""
_PLASTIC = 1.32471795724474602596
"""Root of x³ = x + 1: its powers give the additive sequence that fills a square most evenly."""


def faced_first(
    plane: GpsFeature, others: Sequence[GpsFeature], near: float
) -> dict[tuple[int, bool], tuple[float, float]]:
    """Opposed planes that points of a plane meet first on their way along the normal.

    Args:
        plane: one with facets.
        others: planes with facets, opposed to it (normals antiparallel).
        near: mm; closer ones are the same place.

    Returns:
        For id and side (True beyond the outward normal, through air; False through material):
        the share of the plane that meets it first, and the distance (mm).
    """
    normal = np.array(plane.place.direction)
    across = np.column_stack(perpendiculars(normal))
    samples = samples_of(plane.facets) @ across
    found: dict[tuple[int, bool], tuple[float, float]] = {}
    steps = [float(normal @ np.subtract(o.place.point, plane.place.point)) for o in others]
    for outside in (True, False):
        open_ = np.ones(len(samples), dtype=bool)
        for i in sorted(range(len(others)), key=lambda i: abs(steps[i])):
            if (steps[i] > 0) != outside or abs(steps[i]) <= near:
                continue
            met = np.zeros_like(open_)
            met[open_] = inside(samples[open_], others[i].facets @ across)
            if met.any():
                found[others[i].id, outside] = float(met.mean()), abs(steps[i])
                open_ &= ~met
            if not open_.any():
                break
    return found


def samples_of(facets: FloatArray, count: int = _SAMPLES) -> FloatArray:
    """(count, 3) points spread evenly over facets (f, 3, 3), the same ones every time."""
    edges = facets[:, 1:] - facets[:, :1]
    ends = np.cumsum(np.linalg.norm(np.cross(edges[:, 0], edges[:, 1]), axis=1))
    places = (np.arange(count) + 0.5) / count * ends[-1]
    chosen = np.minimum(np.searchsorted(ends, places), len(facets) - 1)
    k = np.arange(1, count + 1)
    a, b = k / _PLASTIC % 1.0, k / _PLASTIC**2 % 1.0
    over = a + b > 1.0
    a, b = np.where(over, 1.0 - a, a), np.where(over, 1.0 - b, b)
    corner, edge = facets[chosen, 0], edges[chosen]
    points: FloatArray = corner + a[:, None] * edge[:, 0] + b[:, None] * edge[:, 1]
    return points


def inside(points: FloatArray, triangles: FloatArray) -> npt.NDArray[np.bool_]:
    """(k,) bool: which points (k, 2) lie in one of triangles (t, 3, 2), of either orientation."""
    low, high = points.min(axis=0), points.max(axis=0)
    reach = (triangles.min(axis=1) <= high).all(axis=1) & (triangles.max(axis=1) >= low).all(axis=1)
    triangles = triangles[reach]
    found = np.zeros(len(points), dtype=np.bool_)
    for start in range(0, len(triangles), _BLOCK):
        waiting = np.flatnonzero(~found)
        found[waiting] = _in_any(points[waiting], triangles[start : start + _BLOCK])
    return found


def _in_any(points: FloatArray, triangles: FloatArray) -> npt.NDArray[np.bool_]:
    side = []
    for i in range(3):
        start, along = triangles[:, i], triangles[:, (i + 1) % 3] - triangles[:, i]
        step = points[:, None] - start
        side.append(along[:, 0] * step[..., 1] - along[:, 1] * step[..., 0])
    signs = np.array(side)
    within = (signs >= 0).all(axis=0) | (signs <= 0).all(axis=0)
    within &= signs.any(axis=0)  # a facet that is but a point holds nothing
    return np.asarray(np.any(within, axis=1), dtype=np.bool_)
