# SPDX-License-Identifier: LGPL-2.1-or-later
"""The example parts: one builder a file, listed in ``PARTS``."""

from __future__ import annotations

from collections.abc import Callable

from parts.benchmark_part import benchmark_part
from parts.blade import blade
from parts.bracket import bracket
from parts.made import MadePart
from parts.multi_solid import multi_solid
from parts.revolution_part import revolution_part
from parts.simple_part import simple_part
from parts.sphere_cube import sphere_cube
from parts.spline_prism import spline_prism
from parts.thread import thread

PARTS: dict[str, Callable[[], MadePart]] = {
    "sphere_cube": sphere_cube,
    "simple_part": simple_part,
    "revolution_part": revolution_part,
    "bracket": bracket,
    "benchmark_part": benchmark_part,
    "blade": blade,
    "thread": thread,
    "spline_prism": spline_prism,
    "multi_solid": multi_solid,
}
