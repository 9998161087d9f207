# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colour a part's faces, and give the user's own colours back.

The user's colours are kept in the partition's view while ours are shown. A saved file holds the
user's: they are put back before each save, so that a part is never left in our colours where the
workbench is missing.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import FreeCAD
import FreeCADGui

from gpswb.gui import compat
from gpswb.gui.compat import Colour


def show_colours(view: Any, colours: Sequence[Colour]) -> None:
    """Colour the faces of a partition's source; the first time the user's colours are kept."""
    target = _target(view.Object)
    now = compat.face_colours(target)
    if now is None:
        return
    if not view.UserColours:
        view.UserColours = now
    compat.set_face_colours(target, colours)


def restore_colours(view: Any) -> None:
    """Give a partition's source the user's own colours back, if they were taken."""
    if not view.UserColours:
        return
    target = _target(view.Object)
    if compat.face_colours(target) is not None:
        compat.set_face_colours(target, view.UserColours)
    view.UserColours = []


def _target(obj: Any) -> Any:
    """The view that shows the source's faces: of a body that of its tip."""
    source = obj.Source
    if source is not None and source.isDerivedFrom("PartDesign::Body") and source.Tip is not None:
        source = source.Tip
    return getattr(source, "ViewObject", None)


class _Observer:
    """Keeps our colours out of saved files."""

    def slotStartSaveDocument(self, document: Any, path: str) -> None:
        """Before a save."""
        for view in _views(document):
            restore_colours(view)

    def slotFinishSaveDocument(self, document: Any, path: str) -> None:
        """After it: what is shown is ours again, and the document is still saved."""
        views = _views(document)
        for view in views:
            view.Proxy.show(view)
        if views:
            FreeCADGui.getDocument(document.Name).Modified = False

    def slotFinishRestoreDocument(self, document: Any) -> None:
        """After a file has been opened."""
        for view in _views(document):
            view.Proxy.show(view)


def _views(document: Any) -> list[Any]:
    from gpswb.gui.objects.partition import partitions

    views = [obj.ViewObject for obj in partitions(document)]
    return [view for view in views if view is not None and hasattr(view.Proxy, "show")]


def watch() -> None:
    """Start to keep our colours out of saved files; once is enough."""
    if not _observers:
        _observers.append(_Observer())
        FreeCAD.addDocumentObserver(_observers[0])


_observers: list[_Observer] = []
