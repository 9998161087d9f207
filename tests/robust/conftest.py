# SPDX-License-Identifier: LGPL-2.1-or-later
"""The example parts, for whichever kernel this Python has."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path

TESTS = Path(__file__).parents[1]
sys.path.insert(0, str(TESTS / "core"))  # the meshes in closed form
if importlib.util.find_spec("FreeCAD") is None:
    sys.path.insert(0, str(TESTS.parent / "examples"))
