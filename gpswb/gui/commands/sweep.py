# SPDX-License-Identifier: LGPL-2.1-or-later
"""`GPS_Sweep`: accuracy of a part at several densities."""

from __future__ import annotations

import FreeCADGui

from gpswb.cad.freecad_measured import is_measurement
from gpswb.gui.commands.command import BaseCommand
from gpswb.gui.compat import QT_TRANSLATE_NOOP, translate


class Command(BaseCommand):
    """Open the panel that runs a part at several densities."""

    name = "GPS_Sweep"
    text = QT_TRANSLATE_NOOP("GPS_Sweep", "Sweep density…")
    tooltip = QT_TRANSLATE_NOOP(
        "GPS_Sweep", "Partition the part at several densities and compare the accuracy"
    )
    shortcut = "G, S"

    def why_not(self) -> str:
        from gpswb.gui.selection import chosen_part

        part = chosen_part()
        if part is None:
            return str(translate("GPS", "select a part"))
        if is_measurement(part):
            return str(translate("GPS", "a mesh has no CAD faces"))
        if FreeCADGui.Control.activeDialog():
            return str(translate("GPS", "a task panel is open: close it first"))
        return ""

    def run(self) -> None:
        from gpswb.gui.panels.show import show_panel
        from gpswb.gui.panels.sweep import SweepPanel
        from gpswb.gui.selection import chosen_part

        show_panel(SweepPanel(chosen_part()))
