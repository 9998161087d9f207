# SPDX-License-Identifier: LGPL-2.1-or-later
"""Situation feature, intrinsic characteristics and surface name of a recognised region."""

from __future__ import annotations

import numpy as np

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray
from gpswb.core.quotient import axis_coordinates, quotient_coordinates
from gpswb.core.reference import Reference

Description = tuple[str, dict[str, list[float]], dict[str, float]]


def describe(
    points: FloatArray,
    invariance_class: InvarianceClass,
    reference: Reference,
    tolerance: float,
) -> Description:
    """Name the surface behind a class and measure it.

    Args:
        points: (n, 3) mm, the region's vertices.
        invariance_class: its class.
        reference: reference parameters of that class.
        tolerance: mm: a revolute profile this close to a line is a cone, to a circle a torus.

    Returns:
        Surface name, situation (``point`` mm, ``direction`` or ``normal`` unit), and intrinsic
        characteristics (lengths in mm, angles in degrees), with the keys of `Region`.
    """
    point = reference.point.tolist()
    direction = reference.direction.tolist()
    if invariance_class == "planar":
        return "plane", {"point": point, "normal": direction}, {}
    if invariance_class == "complex":
        return "freeform", {"point": points.mean(axis=0).tolist()}, {}
    if invariance_class == "spherical":
        radius = float(quotient_coordinates(points, "spherical", reference).mean())
        return "sphere", {"point": point}, {"radius": radius}
    axis = {"point": point, "direction": direction}
    if invariance_class == "cylindrical":
        radius = float(quotient_coordinates(points, "cylindrical", reference).mean())
        return "cylinder", axis, {"radius": radius}
    if invariance_class == "prismatic":
        return "extrusion", axis, {}
    if invariance_class == "helical":
        return "helicoid", axis, {"lead": reference.lead} if np.isfinite(reference.lead) else {}
    return _revolution(points, reference, tolerance)


def _revolution(points: FloatArray, reference: Reference, tolerance: float) -> Description:
    about = axis_coordinates(points, reference)
    profile = np.column_stack([about.rho, about.z])
    centre = profile.mean(axis=0)
    values, vectors = np.linalg.eigh(np.cov((profile - centre).T, bias=True))
    slope_rho, slope_z = vectors[:, 1]
    direction = reference.direction
    if np.sqrt(max(float(values[0]), 0.0)) <= tolerance and abs(slope_z) > 1e-9:
        half_angle = float(np.degrees(np.arctan2(abs(slope_rho), abs(slope_z))))
        if abs(slope_rho) < 1e-9:
            point = reference.point
        else:
            point = reference.point + (centre[1] - centre[0] * slope_z / slope_rho) * direction
        situation = {"point": point.tolist(), "direction": direction.tolist()}
        return "cone", situation, {"half_angle_deg": half_angle}
    design = np.column_stack([2.0 * (profile - centre), np.ones(len(profile))])
    squares = ((profile - centre) ** 2).sum(axis=1)
    a, b, c = np.linalg.lstsq(design, squares, rcond=1e-12)[0]
    minor = float(np.sqrt(max(c + a * a + b * b, 0.0)))
    off = np.hypot(profile[:, 0] - centre[0] - a, profile[:, 1] - centre[1] - b) - minor
    if float(np.sqrt(np.mean(off**2))) <= tolerance:
        point = reference.point + (centre[1] + b) * direction
        situation = {"point": point.tolist(), "direction": direction.tolist()}
        major = abs(float(centre[0] + a))
        return "torus", situation, {"major_radius": major, "minor_radius": minor}
    situation = {"point": reference.point.tolist(), "direction": direction.tolist()}
    return "revolution", situation, {}
