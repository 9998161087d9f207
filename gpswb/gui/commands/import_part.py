# SPDX-License-Identifier: LGPL-2.1-or-later
"""`GPS_Import`: bring a part into the document."""

from __future__ import annotations

from pathlib import Path

import FreeCAD
import FreeCADGui

from gpswb.gui import compat
from gpswb.gui.commands.command import BaseCommand
from gpswb.gui.compat import QT_TRANSLATE_NOOP, QtWidgets, translate
from gpswb.gui.importing import CLOUDS, MESHES, SUFFIXES, import_part


class Command(BaseCommand):
    """Ask for a file and bring its parts in."""

    name = "GPS_Import"
    text = QT_TRANSLATE_NOOP("GPS_Import", "Import part…")
    tooltip = QT_TRANSLATE_NOOP(
        "GPS_Import", "Bring a part into the document: STEP, BREP, mesh or points"
    )
    shortcut = "G, I"

    def why_not(self) -> str:
        return ""

    def run(self) -> None:
        suffixes = (*SUFFIXES, *MESHES, *CLOUDS)
        patterns = " ".join(f"*{suffix} *{suffix.upper()}" for suffix in suffixes)
        title = translate("GPS_Import", "Import part")
        kinds = translate("GPS_Import", "Parts")
        path, _ = QtWidgets.QFileDialog.getOpenFileName(
            compat.main_window(), title, "", f"{kinds} ({patterns})"
        )
        if path:
            bring_in(Path(path))


def bring_in(path: Path) -> None:
    """Import a file into the active document, or a new one, select its parts, show all.

    Raises:
        InputError: it can't be read, or holds no part.
    """
    document = FreeCAD.ActiveDocument or FreeCAD.newDocument(path.stem)
    document.openTransaction(translate("GPS_Import", "Import part"))
    try:
        parts = import_part(path, document)
    except BaseException:
        document.abortTransaction()
        raise
    document.commitTransaction()
    FreeCADGui.Selection.clearSelection()
    for part in parts:
        FreeCADGui.Selection.addSelection(part)
    FreeCADGui.SendMsgToActiveView("ViewFit")
