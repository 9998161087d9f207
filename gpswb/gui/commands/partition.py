# SPDX-License-Identifier: LGPL-2.1-or-later
"""`GPS_Partition`: open the panel that partitions a part."""

from __future__ import annotations

import FreeCAD
import FreeCADGui

from gpswb.gui.commands.command import BaseCommand
from gpswb.gui.compat import QT_TRANSLATE_NOOP, translate


class Command(BaseCommand):
    """Partition the selected part, or run the selected partition again."""

    name = "GPS_Partition"
    text = QT_TRANSLATE_NOOP("GPS_Partition", "Partition…")
    tooltip = QT_TRANSLATE_NOOP(
        "GPS_Partition",
        "Mesh a part, divide the mesh into regions and recognise the invariance class of each",
    )
    shortcut = "G, P"

    def why_not(self) -> str:
        from gpswb.gui.selection import parts

        document = FreeCAD.ActiveDocument
        if document is None or not parts(document):
            return str(translate("GPS", "there is no part: import one"))
        if FreeCADGui.Control.activeDialog():
            return str(translate("GPS", "a task panel is open: close it first"))
        return ""

    def run(self) -> None:
        from gpswb.gui.objects.partition import is_partition
        from gpswb.gui.panels.partition import PartitionPanel
        from gpswb.gui.panels.show import show_panel
        from gpswb.gui.selection import chosen_part

        chosen = [obj for obj in FreeCADGui.Selection.getSelection() if is_partition(obj)]
        if chosen:
            show_panel(PartitionPanel(partition=chosen[0]))
        else:
            show_panel(PartitionPanel(source=chosen_part()))
