# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs pytest in FreeCAD's window: ``sh tests/gui/run.sh DIRECTORY``."""

import os
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "gui"))

from window_job import start  # noqa: E402

TESTS = os.environ.get("GPSWB_GUI_TESTS", str(ROOT / "tests" / "gui"))


def run():
    status = pytest.main(["-p", "no:cacheprovider", TESTS])
    if status != 0:
        raise SystemExit(int(status))


os.chdir(ROOT)
start(run)
