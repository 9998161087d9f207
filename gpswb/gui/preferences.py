# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench's preferences, as the preferences page stores them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import FreeCAD

from gpswb.core.invariance import InvarianceClass
from gpswb.io.colours import SAFE, WHEEL, Rgb

PATH = "User parameter:BaseApp/Preferences/Mod/GPS"

DENSITIES = ("auto", "coarse", "medium", "fine", "stl")
MODES = ("robust", "corrected", "paper")
PALETTES: tuple[Mapping[InvarianceClass, Rgb], ...] = (WHEEL, SAFE)


def _group() -> Any:
    return FreeCAD.ParamGet(PATH)


def default_density() -> str:
    """Density of a new partition."""
    index = _group().GetInt("Density", 0)
    return DENSITIES[index] if 0 <= index < len(DENSITIES) else DENSITIES[0]


def default_mode() -> str:
    """Mode of a new partition."""
    index = _group().GetInt("Mode", 0)
    return MODES[index] if 0 <= index < len(MODES) else MODES[0]


def palette() -> Mapping[InvarianceClass, Rgb]:
    """Colours of the classes: the paper's wheel, or the one for colour-blind eyes."""
    index = _group().GetInt("Palette", 0)
    return PALETTES[index] if 0 <= index < len(PALETTES) else PALETTES[0]


def recompute_limit_s() -> float:
    """A partition that took longer than this is not recomputed by itself but marked stale."""
    return float(_group().GetFloat("RecomputeLimit", 5.0))


def show_situation() -> bool:
    """Whether new features show their axis, centre or plane."""
    return bool(_group().GetBool("ShowSituation", True))
