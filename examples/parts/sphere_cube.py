# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cube with a hemisphere on top (the paper's Figs. 9 to 13)."""

from __future__ import annotations

import cadquery as cq

from parts.made import MadePart


def sphere_cube() -> MadePart:
    """Six planes and a spherical face: seven regions."""
    cube = cq.Workplane().box(40, 40, 40)
    part = cube.union(cq.Workplane(origin=(0, 0, 20)).sphere(13))
    return MadePart("sphere_cube", part.val(), {"planar": 6, "spherical": 1}, features=7)
