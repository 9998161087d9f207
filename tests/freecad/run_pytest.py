# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs pytest inside FreeCAD's own Python: ``freecadcmd tests/freecad/run_pytest.py``.

freecadcmd ends with 0 whatever a script does, also where it has a syntax error or is missing. So
this one ends the process itself, and success is known only from the file that it leaves.
"""

import os
import sys
from pathlib import Path

import FreeCAD
import pytest

ROOT = Path(__file__).resolve().parents[2]
PASSED = ROOT / "build" / "freecad" / "passed"
# These use packages from pip; all else must also run on Debian's own, older numpy and scipy.
NEED_PIP = {"batch", "cli", "report"}
NEED_WINDOW = {"gui"}

os.chdir(ROOT)
sys.path.insert(0, str(ROOT))
# A test that starts a process with sys.executable means this Python, not another freecadcmd.
sys.executable = "/usr/bin/python3"
os.environ["PYTHONPATH"] = f"{ROOT}:{FreeCAD.getHomePath()}lib"
elsewhere = {*NEED_PIP, *NEED_WINDOW, "__pycache__"}
suites = [entry for entry in (ROOT / "tests").iterdir() if entry.is_dir()]
wanted = [str(suite) for suite in sorted(suites) if suite.name not in elsewhere]
status = pytest.main(os.environ.get("GPSWB_TESTS", "").split() or wanted)
sys.stdout.flush()
if status == 0:
    PASSED.parent.mkdir(parents=True, exist_ok=True)
    PASSED.touch()
os._exit(int(status))
