# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the icons are."""

from __future__ import annotations

from pathlib import Path

import gpswb

FOLDER = Path(gpswb.__file__).parents[1] / "icons"


def icon(name: str) -> str:
    """Path of ``name.svg``; FreeCAD runs InitGui.py without ``__file__``, so ask here."""
    return str(FOLDER / f"{name}.svg")


def class_icon(invariance_class: str) -> str:
    """Path of the icon of a class: its symbol in the paper's colour."""
    return icon(f"class_{invariance_class}")
