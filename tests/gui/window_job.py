# SPDX-License-Identifier: LGPL-2.1-or-later
"""Do something in FreeCAD's window, and end it: what every script for ``run.sh`` shares.

FreeCAD ends with 0 whatever happens, so success is known only from the file that is left.
"""

import os
import sys
import traceback
from pathlib import Path

from PySide import QtCore


def start(job):
    """Call ``job`` when the window is up and its event loop runs; leave the file if it returns."""
    QtCore.QTimer.singleShot(1500, lambda: _do(job))


def _do(job):
    # FreeCAD 1.0 has put its report view in their place.
    sys.stdout, sys.stderr = sys.__stdout__, sys.__stderr__
    try:
        job()
        Path(os.environ["GPSWB_GUI_PASSED"]).touch()
    except BaseException:  # noqa: BLE001 - nothing else would print it
        traceback.print_exc()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(0)
