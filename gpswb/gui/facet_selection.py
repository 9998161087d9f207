# SPDX-License-Identifier: LGPL-2.1-or-later
"""Highlight what is selected on shown meshes: FreeCAD does so for faces only."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui

from gpswb.gui.compat import QtCore


def follow_selection() -> None:
    """Start to, once."""
    if not _followers:
        _followers.append(_Follower())
        FreeCADGui.Selection.addObserver(_followers[0])


class _Follower:
    """Looks at the selection when the window is at rest, once for many changes of it."""

    def __init__(self) -> None:
        self.timer = QtCore.QTimer()
        self.timer.setSingleShot(True)
        self.timer.timeout.connect(_highlight)

    def addSelection(self, *_: Any) -> None:
        """FreeCAD tells that the selection has changed."""
        self.timer.start(0)

    removeSelection = setSelection = clearSelection = addSelection


def _highlight() -> None:
    from gpswb.gui.objects.partition import partitions

    document = FreeCAD.ActiveDocument
    for obj in partitions(document) if document is not None else ():
        proxy = obj.ViewObject.Proxy
        if hasattr(proxy, "highlight"):
            proxy.highlight()


_followers: list[_Follower] = []
