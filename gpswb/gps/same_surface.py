# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a region continues the surface of another one (ISO 18183: maximal features)."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import FloatArray
from gpswb.core.partition import Region
from gpswb.gps.tolerances import Tolerances


def distance_to_surface(region: Region, own: FloatArray, points: FloatArray) -> FloatArray | None:
    """Distances (k,) mm of points (k, 3) to the unbounded surface recognised for a region.

    Args:
        region: a plane, cylinder, sphere, cone or torus; for others there is no closed form: None.
        own: (n, 3) the region's vertices, which give a cone its radius along the axis.
    """
    situation, intrinsic = region.situation, region.intrinsic
    signed: FloatArray
    if region.surface == "plane":
        signed = (points - np.array(situation["point"])) @ np.array(situation["normal"])
    elif region.surface == "sphere":
        signed = np.linalg.norm(points - situation["point"], axis=1) - intrinsic["radius"]
    elif region.surface in ("cylinder", "cone", "torus"):
        rho, z = cylindrical_coordinates(points, situation["point"], situation["direction"])
        if region.surface == "cylinder":
            signed = rho - intrinsic["radius"]
        elif region.surface == "torus":
            signed = np.hypot(rho - intrinsic["major_radius"], z) - intrinsic["minor_radius"]
        else:
            own_rho, own_z = cylindrical_coordinates(
                own, situation["point"], situation["direction"]
            )
            slope, start = np.polyfit(own_z, own_rho, 1)
            signed = (rho - slope * z - start) / float(np.hypot(1.0, slope))
    else:
        return None
    return np.abs(signed)


def cylindrical_coordinates(
    points: FloatArray, point: list[float] | FloatArray, direction: list[float] | FloatArray
) -> tuple[FloatArray, FloatArray]:
    """(ρ, z) of points (k, 3) about the axis through ``point`` along unit ``direction``."""
    relative = points - np.asarray(point)
    z = relative @ np.asarray(direction)
    return np.linalg.norm(relative - np.outer(z, direction), axis=1), z


def same_surface(
    larger: Region,
    own: FloatArray,
    smaller: Region,
    points: FloatArray,
    length: float,
    tolerances: Tolerances,
) -> bool:
    """Whether the vertices ``points`` of a smaller region lie on the surface of a larger one.

    Both must be of one kind. The root mean square distance may reach what the mesh shows of noise,
    but no more than the frame's rank tolerance: a step of that height is a step.
    """
    if larger.surface != smaller.surface or not _parallel(larger, smaller):
        return False
    distance = distance_to_surface(larger, own, points)
    if distance is None:
        return False
    noise = 2.0 * max(larger.residual, smaller.residual)
    limit = length * min(max(tolerances.surface, noise / length), 10 * tolerances.distance)
    return float(np.sqrt(np.mean(distance**2))) <= limit


def _parallel(one: Region, other: Region) -> bool:
    """Whether directions agree as far as a narrow region can tell: to 5°; spheres have none."""
    for key in ("normal", "direction"):
        if key in one.situation and key in other.situation:
            dot = sum(a * b for a, b in zip(one.situation[key], other.situation[key], strict=True))
            if abs(dot) < 0.996:
                return False
    return True
