# SPDX-License-Identifier: LGPL-2.1-or-later
"""`GPS_Query`: click a face and read what was recognised on it."""

from __future__ import annotations

from gpswb.gui.commands.command import ResultCommand
from gpswb.gui.compat import QT_TRANSLATE_NOOP


class Command(ResultCommand):
    """Open the panel that follows the picks."""

    name = "GPS_Query"
    text = QT_TRANSLATE_NOOP("GPS_Query", "Query face")
    tooltip = QT_TRANSLATE_NOOP(
        "GPS_Query",
        "Click a face: its class, situation feature, intrinsic values, agreement and ranking",
    )
    shortcut = "G, Q"

    def run(self) -> None:
        from gpswb.gui.panels.query import QueryPanel
        from gpswb.gui.panels.show import show_panel
        from gpswb.gui.selection import with_result

        show_panel(QueryPanel(with_result()))
