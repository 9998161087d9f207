# SPDX-License-Identifier: LGPL-2.1-or-later
"""`GPS_Datums`: datum features and their system."""

from __future__ import annotations

from gpswb.gui.commands.command import ResultCommand
from gpswb.gui.compat import QT_TRANSLATE_NOOP


class Command(ResultCommand):
    """Open the panel of the datum system."""

    name = "GPS_Datums"
    text = QT_TRANSLATE_NOOP("GPS_Datums", "Datum system…")
    tooltip = QT_TRANSLATE_NOOP(
        "GPS_Datums", "Choose datum features, or take the suggested ones: what each letter locks"
    )
    shortcut = "G, D"
    faces = True

    def run(self) -> None:
        from gpswb.gui.panels.datums import DatumsPanel
        from gpswb.gui.panels.show import show_panel
        from gpswb.gui.selection import with_result

        show_panel(DatumsPanel(with_result()))
