# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cone seen from a patch of it: coordinates in which a fit to the patch converges.

The half angle shows in the third order only, in how curvature changes along the rulings. When it is
changed alone, the cone leaves the patch at once, so that a descent crawls along a bent valley.
These six coordinates act at the point of the cone nearest to the patch: its height, three turns
about it, the curvature across its ruling, and the half angle with curvature and ruling kept.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gpswb.core.mesh import FloatArray
from gpswb.core.robust.turns import TINY, lengths, turned, turning

LEAST = 0.1
"""Distance from the axis, in sizes of the patch, that the point has at least: at the apex there is
no ruling."""


@dataclass(frozen=True, eq=False)
class ConeChart:
    """b cones with the points of them nearest to given points.

    Args:
        foot: (b, 3) nearest points; ``normal`` (b, 3) normals there, away from the axis.
        ruling: (b, 3) unit, away from the apex where the half angle is positive.
        curvature: (b,) across the ruling; ``angle`` (b,) half angle, rad, 0 for a cylinder.
    """

    foot: FloatArray
    normal: FloatArray
    ruling: FloatArray
    curvature: FloatArray
    angle: FloatArray

    @classmethod
    def at(cls, surface: FloatArray, points: FloatArray) -> ConeChart:
        """The chart of (b, 8) cones next to (b, 3) points, in units of their patches."""
        u, angle = surface[:, 3:6], surface[:, 7]
        cos, sin = np.cos(angle), np.sin(angle)
        x = points - surface[:, :3]
        t = np.einsum("bk,bk->b", x, u)
        radial = x - t[:, None] * u
        rho = lengths(radial)
        radial /= np.maximum(rho, TINY)[:, None]
        normal = cos[:, None] * radial - sin[:, None] * u
        ruling = cos[:, None] * u + sin[:, None] * radial
        height = rho * cos - t * sin - surface[:, 6]
        foot = points - height[:, None] * normal
        rho = rho - height * cos
        # Along the ruling by as much as the distance from the axis is too small.
        short = np.where(np.abs(sin) > TINY, np.maximum(LEAST - rho, 0.0), 0.0)
        foot += (short / np.where(short > 0.0, sin, 1.0))[:, None] * ruling
        curvature = cos / np.maximum(rho + short, TINY)
        return cls(foot, normal, ruling, curvature, angle)

    @property
    def surface(self) -> FloatArray:
        """(b, 8) the cones."""
        out = np.empty((len(self.foot), 8))
        with np.errstate(divide="ignore", invalid="ignore"):
            radius = 1.0 / self.curvature
            out[:, :3] = self.foot - radius[:, None] * self.normal
        out[:, 3:6] = self._axis
        out[:, 3:6] /= np.maximum(lengths(out[:, 3:6]), TINY)[:, None]
        out[:, 6], out[:, 7] = radius, self.angle
        return out

    @property
    def _axis(self) -> FloatArray:
        cos, sin = np.cos(self.angle)[:, None], np.sin(self.angle)[:, None]
        axis: FloatArray = cos * self.ruling - sin * self.normal
        return axis

    def derivative(self) -> FloatArray:
        """(b, 8, 6) change of the surface's numbers with the six coordinates."""
        out = np.zeros((len(self.foot), 8, 6))
        radius = 1.0 / self.curvature
        cos, sin = np.cos(self.angle)[:, None], np.sin(self.angle)[:, None]
        out[:, :3, 0] = self.normal
        out[:, :3, 1:4] = turning(-radius[:, None] * self.normal)
        out[:, 3:6, 1:4] = turning(self._axis)
        out[:, :3, 4], out[:, 6, 4] = (radius**2)[:, None] * self.normal, -(radius**2)
        out[:, 3:6, 5], out[:, 7, 5] = -sin * self.ruling - cos * self.normal, 1.0
        return out

    def moved(self, step: FloatArray) -> ConeChart:
        """The chart after a (b, 6) step; turns are carried out exactly."""
        normal, ruling = turned(np.stack([self.normal, self.ruling]), step[:, 1:4])
        return ConeChart(
            self.foot + step[:, :1] * self.normal,
            normal,
            ruling,
            self.curvature + step[:, 4],
            self.angle + step[:, 5],
        )
