# SPDX-License-Identifier: LGPL-2.1-or-later
"""Show a task panel, in place of the one that is open."""

from __future__ import annotations

from typing import Any

import FreeCADGui

_shown: list[Any] = []


def show_panel(panel: Any) -> None:
    """Open a panel; a panel of ours that is open is closed as by its Close button."""
    if _shown and FreeCADGui.Control.activeDialog():
        _shown[0].reject()
    FreeCADGui.Control.showDialog(panel)
    _shown[:] = [panel]


def shown_panel() -> Any:
    """The panel of ours that is open, or None."""
    return _shown[0] if _shown and FreeCADGui.Control.activeDialog() else None


def close_panel() -> None:
    """Close the panel that is open; what it did stays done."""
    FreeCADGui.Control.closeDialog()
    _shown.clear()
