# SPDX-License-Identifier: LGPL-2.1-or-later
"""Show a task panel, in place of the one that is open.

A panel works on ``source``, ``partition`` or ``obj``, attributes of its own. It has ``reject``,
which closes it as its Close button does, and ``stop``, which ends what it watches and runs and
leaves the document alone: that is called when what it works on is deleted. FreeCAD keeps deleted
objects for undo, and crashes when they are changed there.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import FreeCAD
import FreeCADGui

from gpswb.gui import compat
from gpswb.gui.compat import QtCore, translate

_shown: list[Any] = []
_followers: list[_Follower] = []


def show_panel(panel: Any) -> None:
    """Open a panel; a panel of ours that is open is closed as by its Close button."""
    if _shown and FreeCADGui.Control.activeDialog():
        _shown[0].reject()
    FreeCADGui.Control.showDialog(panel)
    _shown[:] = [panel]
    if not _followers:
        _followers.append(_Follower())
        FreeCAD.addDocumentObserver(_followers[0])


def shown_panel() -> Any:
    """The panel of ours that is open, or None."""
    return _shown[0] if _shown and FreeCADGui.Control.activeDialog() else None


def close_panel() -> None:
    """Close the panel that is open; what it did stays done."""
    FreeCADGui.Control.closeDialog()
    _shown.clear()


class _Follower:
    """Ends the panel whose part, partition or document goes."""

    def slotDeletedObject(self, obj: Any) -> None:
        """FreeCAD is about to delete an object."""
        _leave(lambda each: each is obj)

    def slotDeletedDocument(self, document: Any) -> None:
        """FreeCAD is about to close a document."""
        _leave(lambda each: each.Document is document)


def _leave(gone: Callable[[Any], bool]) -> None:
    panel = shown_panel()
    objects = [getattr(panel, name, None) for name in ("source", "partition", "obj")]
    if panel is None or not any(obj is not None and gone(obj) for obj in objects):
        return
    panel.stop()
    _shown.clear()
    QtCore.QTimer.singleShot(0, FreeCADGui.Control.closeDialog)
    compat.warn(translate("GPS", "the panel is closed: what it worked on is gone"))
