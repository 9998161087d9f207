# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of classes and shape types: the paper's wheel (Fig. 8) and a colour-blind-safe one."""

from __future__ import annotations

from collections.abc import Mapping

from gpswb.core.invariance import InvarianceClass

Rgb = tuple[int, int, int]

WHEEL: Mapping[InvarianceClass, Rgb] = {
    "planar": (230, 38, 38),
    "cylindrical": (30, 165, 50),
    "spherical": (0, 190, 200),
    "revolute": (240, 200, 0),
    "prismatic": (40, 80, 230),
    "helical": (215, 40, 200),
    "complex": (35, 35, 35),
}
"""Paper, Fig. 8: planar red, cylindrical green, spherical cyan, revolute yellow, prismatic blue,
helical magenta, complex black; classes of one dimension stand opposite one another."""

SAFE: Mapping[InvarianceClass, Rgb] = {
    "planar": (213, 94, 0),
    "cylindrical": (0, 158, 115),
    "spherical": (86, 180, 233),
    "revolute": (240, 228, 66),
    "prismatic": (0, 114, 178),
    "helical": (204, 121, 167),
    "complex": (35, 35, 35),
}
"""Okabe and Ito (2008): seven colours that the common colour-vision deficiencies tell apart."""

NONE: Rgb = (170, 170, 170)
"""A facet of no class."""

SHARP_EDGE: Rgb = (128, 0, 160)
"""Paper, Fig. 8: sharp edges purple."""

SHAPE_TYPES: tuple[tuple[str, Rgb], ...] = (
    ("spherical cup", (0, 60, 160)),
    ("trough", (0, 115, 200)),
    ("rut", (0, 170, 215)),
    ("saddle rut", (90, 200, 180)),
    ("saddle", (120, 190, 90)),
    ("saddle ridge", (190, 210, 70)),
    ("ridge", (250, 200, 50)),
    ("dome", (245, 140, 30)),
    ("spherical cap", (210, 50, 20)),
    ("plane", (205, 205, 205)),
    ("sharp edge", SHARP_EDGE),
)
"""Name and colour of shape types −4..4, 5 (plane) and 6 (sharp edge): paper, Table 5."""
