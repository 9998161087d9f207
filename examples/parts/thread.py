# SPDX-License-Identifier: LGPL-2.1-or-later
"""A screw thread: helical flanks swept along a helix."""

from __future__ import annotations

import cadquery as cq

from parts.made import MadePart

PITCH = 2.5
"""Lead of the thread, mm."""
TURNS = 4


def thread() -> MadePart:
    """A trapezoidal ridge swept along a helix by a pipe shell, on its own: two helical flanks,
    crest and root cylindrical, two plane ends."""
    radius = 6.0
    helix = cq.Wire.makeHelix(PITCH, PITCH * TURNS, radius)
    ridge = (
        cq.Workplane("XZ", origin=(radius, 0, 0))
        .polyline([(-0.4, -0.9), (1.4, -0.3), (1.4, 0.3), (-0.4, 0.9)])
        .close()
        .sweep(cq.Workplane(helix), isFrenet=True)
    )
    counts = {"helical": 2, "cylindrical": 2, "planar": 2}
    return MadePart("thread", ridge.val(), counts, features=6)
