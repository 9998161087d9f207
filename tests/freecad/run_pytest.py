# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs pytest inside FreeCAD's own Python: ``freecadcmd tests/freecad/run_pytest.py``.

freecadcmd ends with 0 whatever a script does, also where it has a syntax error or is missing. So
this one ends the process itself, and success is known only from the file that it leaves.
"""

import os
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PASSED = ROOT / "build" / "freecad" / "passed"
# What needs nothing from pip: Debian's numpy and scipy are older than those of the venv.
SUITES = ("core", "gps", "io", "validation", "cad", "freecad")

os.chdir(ROOT)
sys.path.insert(0, str(ROOT))
status = pytest.main([str(ROOT / "tests" / suite) for suite in SUITES])
sys.stdout.flush()
if status == 0:
    PASSED.touch()
os._exit(int(status))
