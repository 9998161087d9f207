# SPDX-License-Identifier: LGPL-2.1-or-later
"""`GPS_Export`: write a partition as a file."""

from __future__ import annotations

from pathlib import Path

from gpswb.gui import compat
from gpswb.gui.commands.command import ResultCommand
from gpswb.gui.compat import QT_TRANSLATE_NOOP, QtWidgets, translate


class Command(ResultCommand):
    """Ask for a file, and write what its suffix says."""

    name = "GPS_Export"
    text = QT_TRANSLATE_NOOP("GPS_Export", "Export…")
    tooltip = QT_TRANSLATE_NOOP(
        "GPS_Export", "Write result, faces, GPS features, report or mesh as a file"
    )
    shortcut = "G, E"

    def run(self) -> None:
        from gpswb.gui.exports import export, formats_of
        from gpswb.gui.selection import with_result

        partition = with_result()
        kinds = {
            f"{translate('GPS', kind)} (*{suffix})": suffix
            for suffix, kind in formats_of(partition).items()
        }
        path, kind = QtWidgets.QFileDialog.getSaveFileName(
            compat.main_window(), translate("GPS", "Export"), "", ";;".join(kinds)
        )
        if not path:
            return
        suffix = kinds[kind]
        said = export(partition, Path(path if path.lower().endswith(suffix) else path + suffix))
        if said:
            compat.show_note(said)
