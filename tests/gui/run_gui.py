# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs pytest in FreeCAD's window: ``freecad tests/gui/run_gui.py``, under Xvfb.

FreeCAD ends with 0 whatever happens, so success is known only from the file that this leaves.
"""

import os
import sys
from pathlib import Path

import pytest
from PySide import QtCore

ROOT = Path(__file__).resolve().parents[2]
PASSED = Path(os.environ["GPSWB_GUI_PASSED"])
TESTS = os.environ.get("GPSWB_GUI_TESTS", str(ROOT / "tests" / "gui"))


def main():
    # FreeCAD 1.0 has put its report view in their place.
    sys.stdout, sys.stderr = sys.__stdout__, sys.__stderr__
    status = 1
    try:
        status = pytest.main(["-p", "no:cacheprovider", TESTS])
        if status == 0:
            PASSED.touch()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(int(status))


os.chdir(ROOT)
# The window must be up, and its event loop running, before anything is clicked.
QtCore.QTimer.singleShot(1500, main)
