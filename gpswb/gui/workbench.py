# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench: its name and icon at FreeCAD's start, all else when it is first chosen."""

from __future__ import annotations

from pathlib import Path

import FreeCADGui

FOLDER = Path(__file__).parent
ICONS = FOLDER.parents[1] / "icons"


class GpsWorkbench(FreeCADGui.Workbench):
    """ISO GPS: partition, recognition, validation."""

    MenuText = "GPS"
    ToolTip = "Recognise the ISO GPS invariance classes of a part's faces, and annotate them"
    Icon = str(ICONS / "preferences-gps.svg")  # the name that FreeCAD looks for, for the page

    def Initialize(self) -> None:
        """Make commands, menu, toolbar and preferences page; FreeCAD calls it once."""
        from gpswb.gui.commands import GROUPS, register
        from gpswb.gui.source_colours import watch

        FreeCADGui.addLanguagePath(str(FOLDER / "translations"))
        FreeCADGui.updateLocale()
        FreeCADGui.addIconPath(str(ICONS))
        FreeCADGui.addPreferencePage(str(FOLDER / "preferences.ui"), "GPS")
        register()
        watch()
        for title, names in GROUPS:
            self.appendToolbar(title, list(names))
        listed = [name for _, names in GROUPS for name in (*names, "Separator")]
        self.appendMenu("GPS", listed[:-1])

    def GetClassName(self) -> str:
        """What FreeCAD asks for to know that it is written in Python."""
        return "Gui::PythonWorkbench"
