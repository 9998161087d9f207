# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run by FreeCAD at the start of its window."""

import FreeCADGui

from gpswb.gui.workbench import GpsWorkbench

FreeCADGui.addWorkbench(GpsWorkbench())
