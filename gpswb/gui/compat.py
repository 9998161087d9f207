# SPDX-License-Identifier: LGPL-2.1-or-later
"""What differs between FreeCAD 0.20 and 1.x, and with and without a window; nothing else does."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import FreeCAD

from gpswb.sentence import Sentence

if FreeCAD.GuiUp:
    from PySide import QtCore, QtGui

    try:
        from PySide import QtWidgets
    except ImportError:  # FreeCAD's PySide has the widgets in QtGui where it wraps Qt 5
        QtWidgets = QtGui
else:  # a script has no Qt, and needs none
    QtCore = QtGui = QtWidgets = None

__all__ = ["QtCore", "QtGui", "QtWidgets"]

Colour = tuple[float, float, float]
"""Red, green and blue, 0 to 1. No alpha: versions differ on whether it is opacity."""

translate = FreeCAD.Qt.translate
"""Look a text up in the installed translation: ``translate(context, text)``."""


def QT_TRANSLATE_NOOP(context: str, text: str) -> str:
    """Mark a text for translation by whoever shows it: FreeCAD does so for commands."""
    return text


def say(text: str) -> str:
    """A sentence in the user's language; any other text as it is."""
    if not isinstance(text, Sentence):
        return text
    return text.said(lambda template: str(translate("GPS", template)))


def main_window() -> Any:
    """FreeCAD's window."""
    import FreeCADGui

    return FreeCADGui.getMainWindow()


def show_error(text: str) -> None:
    """One line that the user can't miss; in the report view, too."""
    FreeCAD.Console.PrintError(f"GPS: {say(text)}\n")
    _box(QtWidgets.QMessageBox.Warning, say(text)).exec_()


def show_note(text: str) -> None:
    """What there is to know of something that was done, for the user to read or to pass over."""
    FreeCAD.Console.PrintMessage(f"GPS: {say(text)}\n")
    _box(QtWidgets.QMessageBox.Information, say(text)).open()  # goes on at once


def _box(icon: Any, text: str) -> Any:
    box = QtWidgets.QMessageBox(main_window())
    box.setIcon(icon)
    box.setWindowTitle("GPS")
    box.setTextFormat(QtCore.Qt.PlainText)  # it may hold the name of a file
    box.setText(text)
    box.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    return box


def standard_buttons(*names: str) -> int:
    """What a task panel's ``getStandardButtons`` gives, by names of Qt's standard buttons."""
    box = QtWidgets.QDialogButtonBox
    return sum(int(getattr(box, name)) for name in names)


def has_window() -> bool:
    """Whether FreeCAD runs with its window."""
    return bool(FreeCAD.GuiUp)


def warn(text: str) -> None:
    """Say it in FreeCAD's report view."""
    FreeCAD.Console.PrintWarning(f"GPS: {say(text)}\n")


def selection_colour() -> Colour:
    """The colour that FreeCAD gives what is selected, a preference of the user's."""
    group = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/View")
    packed = group.GetUnsigned("SelectionColor", 0x1CAD1CFF)
    return ((packed >> 24) / 255, (packed >> 16 & 255) / 255, (packed >> 8 & 255) / 255)


def face_colours(view: Any) -> list[tuple[float, ...]] | None:
    """Colours of a shape's faces (one, or one a face); None where a view has none."""
    colours = getattr(view, "DiffuseColor", None)
    return [tuple(colour) for colour in colours] if colours else None


def set_face_colours(view: Any, colours: Sequence[Sequence[float]]) -> None:
    """Colour a shape's faces; what `face_colours` gave is taken back as it was."""
    view.DiffuseColor = [tuple(colour) for colour in colours]


def add_group(obj: Any) -> None:
    """Let an object hold others, in the tree too, also where this workbench is missing."""
    if not obj.hasExtension("App::GroupExtension"):
        obj.addExtension("App::GroupExtensionPython")


def add_group_view(view: Any) -> None:
    """The view's half of `add_group`."""
    if not view.hasExtension("Gui::ViewProviderGroupExtension"):
        view.addExtension("Gui::ViewProviderGroupExtensionPython")
