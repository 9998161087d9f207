# SPDX-License-Identifier: LGPL-2.1-or-later
"""A motion seen from the points that it moves: coordinates in which its reference is refined.

The axis of a motion may be far from a region, so that a small turn of it throws the region's orbits
off the region. These coordinates act where the region is: the angular velocity (three) and the
velocity at the region's centre (three), in units of the region's mean speed. One of the six is the
speed, which changes nothing.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray
from gpswb.core.reference import Reference, axis_frame, cross3, screw

_STEP = 1e-7  # of the derivative's differences, in coordinates of order one


@dataclass(frozen=True, eq=False)
class MotionChart:
    """The motion of one reference, near the centre of some points.

    Args:
        invariance_class: prismatic, revolute or helical.
        reference: the reference.
        centre: (3,) mm; ``size`` mm, radius of gyration of the points about it.
    """

    invariance_class: InvarianceClass
    reference: Reference
    centre: FloatArray
    size: float

    @property
    def freedoms(self) -> int:
        """Number of coordinates: a translation has no angular velocity."""
        return 2 if self.invariance_class == "prismatic" else 6

    def moved(self, step: FloatArray) -> Reference:
        """The reference after a (q,) step in the coordinates."""
        d = self.reference.direction
        if self.invariance_class == "prismatic":
            u, v, _ = axis_frame(d)
            direction = d + step[0] * u + step[1] * v
            return Reference(self.reference.point, direction / float(np.linalg.norm(direction)))
        pitch = self.reference.lead / (2.0 * np.pi)
        velocity = cross3(d, self.centre - self.reference.point) + pitch * d
        speed = float(np.hypot(np.linalg.norm(velocity), self.size))
        omega = d / speed + step[:3] / self.size
        velocity = velocity / speed + step[3:6]
        if self.invariance_class == "revolute":
            velocity = velocity - (omega @ velocity) / max(float(omega @ omega), 1e-300) * omega
        found = screw(np.concatenate([omega, velocity - cross3(omega, self.centre)]))
        return (
            found if self.invariance_class == "helical" else Reference(found.point, found.direction)
        )

    def derivative(self) -> FloatArray:
        """(p, q) change of tilt (2), shift (2) and lead of the axis with the coordinates.

        Tilt alone for prismatic, no lead for revolute: as `quotient_jacobian` has them.
        """
        here = self._off(self.reference)
        moves = [self._off(self.moved(_STEP * unit)) for unit in np.eye(self.freedoms)]
        return np.column_stack([(off - here) / _STEP for off in moves])

    def _off(self, other: Reference) -> FloatArray:
        """Tilt, shift and lead of another reference against this one; NaN where it has no axis."""
        if not np.isfinite(other.lead):
            return np.full(4 if self.invariance_class == "revolute" else 5, np.nan)
        u, v, d = axis_frame(self.reference.direction)
        along = float(other.direction @ d)
        direction = other.direction / along
        if self.invariance_class == "prismatic":
            return np.array([direction @ u, direction @ v])
        # Shifts are those of the axis where it passes this reference's point.
        gap = other.point - self.reference.point
        gap = gap - float(gap @ d) * direction
        off = [direction @ u, direction @ v, gap @ u, gap @ v]
        return np.array([*off, other.lead] if self.invariance_class == "helical" else off)
