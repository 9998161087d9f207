# SPDX-License-Identifier: LGPL-2.1-or-later
"""`GPS_Report`: the report of a partition, in the browser."""

from __future__ import annotations

from pathlib import Path

import FreeCAD

from gpswb.gui.commands.command import ResultCommand
from gpswb.gui.compat import QT_TRANSLATE_NOOP, QtCore, QtGui


class Command(ResultCommand):
    """Write the report beside the document, and open it."""

    name = "GPS_Report"
    text = QT_TRANSLATE_NOOP("GPS_Report", "Report")
    tooltip = QT_TRANSLATE_NOOP(
        "GPS_Report", "Write the report (one page, no network) and open it in the browser"
    )
    shortcut = "G, R"

    def run(self) -> None:
        from gpswb.gui.exports import export
        from gpswb.gui.selection import with_result

        partition = with_result()
        path = report_path(partition.Document, partition.Source.Label)
        export(partition, path)
        FreeCAD.Console.PrintMessage(f"GPS: wrote {path}\n")
        QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(str(path)))


def report_path(document: object, label: str) -> Path:
    """Beside the document; where it isn't saved yet, among FreeCAD's temporary files."""
    file = getattr(document, "FileName", "")
    folder = Path(file).parent if file else Path(FreeCAD.getTempPath())
    plain = "".join(c if c.isalnum() or c in "-_. " else "_" for c in label)
    return folder / f"{plain or 'part'}-report.html"
