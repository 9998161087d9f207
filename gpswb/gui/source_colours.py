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

from gpswb.gui import compat, preferences
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
            view.Proxy.give_back(view)

    def slotFinishSaveDocument(self, document: Any, path: str) -> None:
        """After it: what is shown is ours again."""
        for view in _views(document):
            view.Proxy.show(view)

    def slotActivateDocument(self, document: Any) -> None:
        """A file has been opened, or another document is at work: its views are complete now."""
        for view in _views(document):
            if view.Proxy.found is None:
                view.Proxy.show(view)


def _views(document: Any) -> list[Any]:
    from gpswb.gui.objects.partition import partitions

    views = [obj.ViewObject for obj in partitions(document)]
    return [view for view in views if view is not None and hasattr(view.Proxy, "show")]


class _Palette:
    """Shows a palette as soon as it is chosen."""

    def onChange(self, group: Any, name: str) -> None:
        """FreeCAD tells that a preference has changed."""
        if name == "Palette":
            for document in FreeCAD.listDocuments().values():
                for view in _views(document):
                    view.Proxy.show(view)


def watch() -> None:
    """Start to keep our colours out of saved files and to follow the preferences, once."""
    if not _observers:
        documents, palette, group = _Observer(), _Palette(), FreeCAD.ParamGet(preferences.PATH)
        FreeCAD.addDocumentObserver(documents)
        group.Attach(palette)
        _observers.extend([documents, palette, group])


_observers: list[Any] = []
