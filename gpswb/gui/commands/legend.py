# SPDX-License-Identifier: LGPL-2.1-or-later
"""`GPS_Legend`: what the colours mean."""

from __future__ import annotations

from gpswb.gui.commands.command import ResultCommand
from gpswb.gui.compat import QT_TRANSLATE_NOOP


class Command(ResultCommand):
    """Show the legend, or hide it."""

    name = "GPS_Legend"
    text = QT_TRANSLATE_NOOP("GPS_Legend", "Legend")
    tooltip = QT_TRANSLATE_NOOP(
        "GPS_Legend", "What the colours mean, how many faces have each; a click selects them"
    )
    shortcut = "G, L"
    beside_panels = True

    def run(self) -> None:
        from gpswb.gui.panels.legend import open_legend, show_legend

        legend = open_legend()
        if legend is not None and legend.isVisible():
            legend.hide()
        else:
            show_legend()
