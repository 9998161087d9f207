# SPDX-License-Identifier: LGPL-2.1-or-later
"""When two nominal features count as parallel, coincident or equal."""

from __future__ import annotations

from dataclasses import dataclass
from math import radians


@dataclass(frozen=True)
class Tolerances:
    """Tolerances of the GPS layer; lengths relative to the part, so that no unit matters.

    Args:
        angle: rad; directions closer than this to parallel, perpendicular or coplanar are made
            exactly so. Above what recognition loses, below the smallest draft drawn (0.25°).
        distance: of the frame's length; smaller offsets are none. Also the rank tolerance.
        pitch: of the frame's length; a screw with less is a rotation. Directions are exact after
            snapping, so this only has to stand above rounding, and a fine thread above it.
        surface: of the frame's length; root mean square distance of a region to the surface it
            continues. Nominal vertices lie on their surface to rounding.
        size: relative difference of two sizes that are drawn as one.
        size_arc: rad; a cylinder that covers less has no opposed points and so no size.
        whole_arc: rad; a cylinder that covers more goes all round, but for a keyway or the gap
            between two vertices of a coarse mesh.
        negligible: share of the part's area; a smaller feature can't take a symmetry from the part.
    """

    angle: float = radians(0.1)
    distance: float = 1e-4
    pitch: float = 1e-6
    surface: float = 2e-5
    size: float = 1e-3
    size_arc: float = radians(181.0)
    whole_arc: float = radians(270.0)
    negligible: float = 1e-4


DEFAULT = Tolerances()
