# SPDX-License-Identifier: LGPL-2.1-or-later
"""Projection F_i(S; R_i) on the quotient by a class's motions (paper, Table 3).

Points that a motion of the class carries into one another get equal quotient coordinates, so that a
surface of the class projects on a point or a curve, and any other surface on something thicker.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray
from gpswb.core.reference import Reference, axis_frame


@dataclass(frozen=True, eq=False)
class AxisCoordinates:
    """Points about an axis: rho (n,) and z (n,) in mm, phi (n,) in radians in (-pi, pi]."""

    rho: FloatArray
    phi: FloatArray
    z: FloatArray


def axis_coordinates(points: FloatArray, reference: Reference) -> AxisCoordinates:
    """Cylindrical coordinates of points (n, 3) about the reference axis."""
    x, y, z = ((points - reference.point) @ axis_frame(reference.direction).T).T
    return AxisCoordinates(np.hypot(x, y), np.arctan2(y, x), z)


def helical_height(coordinates: AxisCoordinates, lead: float) -> FloatArray:
    """h = z - c phi, c = lead / 2 pi, cut at its largest gap so that a curve stays in one piece.

    Returns:
        (n,) mm within one lead; constant along every helix of that lead about the axis.
    """
    period = abs(lead)
    height = np.mod(coordinates.z - lead / (2.0 * np.pi) * coordinates.phi, period)
    _, start = largest_gap(height, period)
    cut: FloatArray = np.mod(height - start, period)
    return cut


def largest_gap(values: FloatArray, period: float) -> tuple[float, float]:
    """Length of the largest gap of points (n,) on a circle of given period, and where it ends."""
    ordered = np.sort(np.mod(values, period))
    gaps = np.diff(np.append(ordered, ordered[0] + period))
    k = int(np.argmax(gaps))
    return float(gaps[k]), float(ordered[(k + 1) % len(ordered)])


def quotient_coordinates(
    points: FloatArray, invariance_class: InvarianceClass, reference: Reference
) -> FloatArray:
    """Coordinates of points on the quotient space of a class.

    Args:
        points: (n, 3) mm.
        invariance_class: the class.
        reference: its reference parameters.

    Returns:
        (n, 1) for planar (distance), spherical and cylindrical (rho); (n, 2) for revolute
        (rho, z), helical (rho, h) and prismatic (x', y'); (n, 3) for complex. All in mm. A screw
        without axis is a translation, so helical with infinite lead is prismatic, and helical with
        a vanishing lead sees the whole axis as one orbit: cylindrical with (rho, 0).
    """
    frame = axis_frame(reference.direction)
    if invariance_class == "planar":
        distance: FloatArray = (points - reference.point) @ frame[2:].T
        return distance
    if invariance_class == "spherical":
        rho: FloatArray = np.linalg.norm(points - reference.point, axis=1)[:, None]
        return rho
    if invariance_class == "complex":
        return points.copy()
    if invariance_class == "prismatic" or not np.isfinite(reference.lead):
        across: FloatArray = (points - reference.point) @ frame[:2].T
        return across
    about = axis_coordinates(points, reference)
    if invariance_class == "cylindrical":
        return about.rho[:, None]
    if invariance_class == "revolute":
        return np.column_stack([about.rho, about.z])
    if reference.lead == 0.0:
        return np.column_stack([about.rho, np.zeros(len(points))])
    height = helical_height(about, reference.lead)
    return np.column_stack([about.rho, height])
