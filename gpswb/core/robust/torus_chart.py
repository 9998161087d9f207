# SPDX-License-Identifier: LGPL-2.1-or-later
"""A torus seen from a patch of it: coordinates in which a fit to the patch converges.

Centre and axis of a torus are far from a small patch, so that a small turn of the axis throws the
torus off the patch. These seven coordinates act at the point of the torus nearest to the patch: its
height, three turns about it, the tube's radius, the angle of the axis about the tube's centre, and
the tube's distance from the axis.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gpswb.core.mesh import FloatArray
from gpswb.core.robust.turns import TINY, lengths, turned, turning


@dataclass(frozen=True, eq=False)
class TorusChart:
    """b tori with the points of them nearest to given points.

    Args:
        foot: (b, 3) nearest points; ``normal`` (b, 3) normals there, away from the tube's centre.
        axis: (b, 3) unit; ``radial`` (b, 3) unit, from the axis to the tube's centre.
        major, minor: (b,) R and r.
    """

    foot: FloatArray
    normal: FloatArray
    axis: FloatArray
    radial: FloatArray
    major: FloatArray
    minor: FloatArray

    @classmethod
    def at(cls, surface: FloatArray, points: FloatArray) -> TorusChart:
        """The chart of (b, 8) tori next to (b, 3) points."""
        u = surface[:, 3:6]
        x = points - surface[:, :3]
        t = np.einsum("bk,bk->b", x, u)
        radial = x - t[:, None] * u
        radial /= np.maximum(lengths(radial), TINY)[:, None]
        tube = surface[:, :3] + surface[:, 6, None] * radial
        normal = points - tube
        normal /= np.maximum(lengths(normal), TINY)[:, None]
        foot = tube + surface[:, 7, None] * normal
        return cls(foot, normal, u, radial, surface[:, 6], surface[:, 7])

    @property
    def surface(self) -> FloatArray:
        """(b, 8) the tori."""
        tube = self.foot - self.minor[:, None] * self.normal
        out = np.empty((len(self.foot), 8))
        out[:, :3] = tube - self.major[:, None] * self.radial
        out[:, 3:6] = self.axis / np.maximum(lengths(self.axis), TINY)[:, None]
        out[:, 6], out[:, 7] = np.abs(self.major), self.minor
        return out

    def derivative(self) -> FloatArray:
        """(b, 8, 7) change of the surface's numbers with the seven coordinates."""
        out = np.zeros((len(self.foot), 8, 7))
        centre = self.foot - self.minor[:, None] * self.normal - self.major[:, None] * self.radial
        out[:, :3, 0] = self.normal
        out[:, :3, 1:4] = turning(centre - self.foot)
        out[:, 3:6, 1:4] = turning(self.axis)
        out[:, :3, 4], out[:, 7, 4] = -self.normal, 1.0
        out[:, :3, 5], out[:, 3:6, 5] = self.major[:, None] * self.axis, self.radial
        out[:, :3, 6], out[:, 6, 6] = -self.radial, 1.0
        return out

    def moved(self, step: FloatArray) -> TorusChart:
        """The chart after a (b, 7) step; turns are carried out exactly."""
        normal, axis, radial = turned(np.stack([self.normal, self.axis, self.radial]), step[:, 1:4])
        cos, sin = np.cos(step[:, 5, None]), np.sin(step[:, 5, None])
        return TorusChart(
            self.foot + step[:, :1] * self.normal,
            normal,
            cos * axis + sin * radial,
            cos * radial - sin * axis,
            self.major + step[:, 6],
            self.minor + step[:, 4],
        )
