# SPDX-License-Identifier: LGPL-2.1-or-later
"""`GPS_Annotate`: put specifications on features."""

from __future__ import annotations

from gpswb.gui.commands.command import ResultCommand
from gpswb.gui.compat import QT_TRANSLATE_NOOP


class Command(ResultCommand):
    """Open the panel with the symbols that a feature may carry."""

    name = "GPS_Annotate"
    text = QT_TRANSLATE_NOOP("GPS_Annotate", "Specification…")
    tooltip = QT_TRANSLATE_NOOP(
        "GPS_Annotate",
        "Put a specification on a feature: what ISO 1101 permits there, and why not the rest",
    )
    shortcut = "G, A"
    faces = True

    def run(self) -> None:
        from gpswb.gui.panels.annotate import AnnotatePanel
        from gpswb.gui.panels.show import show_panel
        from gpswb.gui.selection import with_result

        show_panel(AnnotatePanel(with_result()))
