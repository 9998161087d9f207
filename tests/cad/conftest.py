# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kernel that this Python has: FreeCAD's Part in FreeCAD's own Python, else OCP."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path

import pytest

IN_FREECAD = importlib.util.find_spec("FreeCAD") is not None
# Not skipped but another suite: in FreeCAD's Python there is neither OCP nor gmsh nor cadquery, and
# in the other there is no FreeCAD.
collect_ignore_glob = ["test_ocp_*.py"] if IN_FREECAD else ["test_freecad_*.py"]

if not IN_FREECAD:
    sys.path.insert(0, str(Path(__file__).parents[2] / "examples"))


@pytest.fixture
def kernel() -> str:
    return "freecad" if IN_FREECAD else "ocp"
