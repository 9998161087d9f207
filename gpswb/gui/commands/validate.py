# SPDX-License-Identifier: LGPL-2.1-or-later
"""`GPS_Validate`: how far the recognition agrees with the CAD surfaces."""

from __future__ import annotations

from gpswb.gui.commands.command import ResultCommand
from gpswb.gui.compat import QT_TRANSLATE_NOOP


class Command(ResultCommand):
    """Open the panel with the figures and the faces that disagree."""

    name = "GPS_Validate"
    text = QT_TRANSLATE_NOOP("GPS_Validate", "Validate")
    tooltip = QT_TRANSLATE_NOOP(
        "GPS_Validate", "Compare the recognised classes with those of the CAD surfaces"
    )
    shortcut = "G, V"
    faces = True

    def run(self) -> None:
        from gpswb.gui.panels.show import show_panel
        from gpswb.gui.panels.validate import ValidatePanel
        from gpswb.gui.selection import with_result

        show_panel(ValidatePanel(with_result()))
