# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed forms of the five elementary surfaces (ISO 10303-42), evaluated for all points at once.

Going through a kernel costs about 2 µs a point; these cost a few ns, and most faces of real parts
are elementary.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from gpswb.core.mesh import FloatArray

ElementaryKind = Literal["Plane", "Cylinder", "Cone", "Sphere", "Torus"]


@dataclass(frozen=True, eq=False)
class Elementary:
    """A plane, cylinder, cone, sphere or torus in the parametrisation of ISO 10303-42.

    Args:
        kind: which of the five.
        origin: (3,) mm.
        frame: (3, 3) rows are the local x, y and z axes, unit vectors; it may be left-handed.
        radius: of cylinder and sphere; of the cone at the origin's level; major one of a torus.
        extra: half angle of a cone (rad), minor radius of a torus; 0 otherwise.
    """

    kind: ElementaryKind
    origin: FloatArray
    frame: FloatArray
    radius: float = 0.0
    extra: float = 0.0

    def derivatives(self, uv: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Points and first derivatives, each (k, 3), at the parameters (k, 2)."""
        u, v = uv[:, 0], uv[:, 1]
        zero, one = np.zeros_like(u), np.ones_like(u)
        if self.kind == "Plane":
            local = (u, v, zero), (one, zero, zero), (zero, one, zero)
        else:
            # Profile in the half plane (rho, z) and its derivative by v, turned about z by u.
            rho, z, drho, dz = self._profile(v)
            c, s = np.cos(u), np.sin(u)
            local = (
                (rho * c, rho * s, z),
                (-rho * s, rho * c, zero),
                (drho * c, drho * s, dz),
            )
        point, du, dv = (np.column_stack(part) @ self.frame for part in local)
        return point + self.origin, du, dv

    def _profile(self, v: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
        one = np.ones_like(v)
        if self.kind == "Cylinder":
            return self.radius * one, v, 0.0 * one, one
        if self.kind == "Cone":
            s, c = np.sin(self.extra), np.cos(self.extra)
            return self.radius + v * s, v * c, s * one, c * one
        arm = self.radius if self.kind == "Sphere" else self.extra
        centre = 0.0 if self.kind == "Sphere" else self.radius
        c, s = arm * np.cos(v), arm * np.sin(v)
        return centre + c, s, -s, c
