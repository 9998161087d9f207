# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that runs a part at several densities: table, and a file of it."""

from __future__ import annotations

import csv
import io
from pathlib import Path
from typing import Any

from gpswb.errors import GpswbError, InputError
from gpswb.gui import compat
from gpswb.gui.compat import QT_TRANSLATE_NOOP, QtCore, QtGui, QtWidgets, say, translate
from gpswb.gui.icons import icon
from gpswb.gui.objects.partition import check_density
from gpswb.gui.panels.show import close_panel
from gpswb.gui.panels.validate import percent
from gpswb.gui.panels.watch import Watch
from gpswb.gui.runs import Run
from gpswb.io.whole import write_whole
from gpswb.sentence import Sentence

_COLUMNS = {
    "density": QT_TRANSLATE_NOOP("GPS", "Density"),
    "triangles": QT_TRANSLATE_NOOP("GPS", "Triangles"),
    "regions": QT_TRANSLATE_NOOP("GPS", "Regions"),
    "area_accuracy": QT_TRANSLATE_NOOP("GPS", "Area"),
    "face_accuracy": QT_TRANSLATE_NOOP("GPS", "Faces"),
    "region_f1": QT_TRANSLATE_NOOP("GPS", "F1"),
    "seconds": QT_TRANSLATE_NOOP("GPS", "s"),
}


class SweepPanel:
    """A task panel.

    Args:
        source: the part.
    """

    def __init__(self, source: Any) -> None:
        self.source = source
        self.rows: list[dict[str, Any]] = []
        self.watch: Watch | None = None
        self.form = QtWidgets.QWidget()
        self.form.setWindowTitle(translate("GPS", "Sweep density"))
        self.form.setWindowIcon(QtGui.QIcon(icon("GPS_Sweep")))
        self.densities = QtWidgets.QLineEdit("coarse; medium; auto")
        self.densities.setToolTip(
            translate("GPS", "Densities in the command line's words, separated by semicolons")
        )
        self.start = QtWidgets.QPushButton(translate("GPS", "Run"))
        self.save = QtWidgets.QPushButton(translate("GPS", "Save table…"))
        self.save.setEnabled(False)
        self.bar = QtWidgets.QProgressBar()
        self.bar.setRange(0, 100)
        self.bar.hide()
        self.message = QtWidgets.QLabel()
        self.message.setWordWrap(True)
        self.message.setTextFormat(QtCore.Qt.PlainText)
        self.table = QtWidgets.QTableWidget(0, len(_COLUMNS))
        self.table.setHorizontalHeaderLabels([translate("GPS", x) for x in _COLUMNS.values()])
        self.table.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        self.table.verticalHeader().hide()
        self.table.resizeColumnsToContents()
        layout = QtWidgets.QVBoxLayout(self.form)
        for widget in (self.densities, self.start, self.bar, self.message, self.table, self.save):
            layout.addWidget(widget)
        self.start.clicked.connect(self.run)
        self.save.clicked.connect(self._save)

    def getStandardButtons(self) -> int:
        """FreeCAD asks which buttons to show."""
        return compat.standard_buttons("Close")

    def reject(self) -> bool:
        """Close; a run that has not ended is cancelled."""
        self.stop()
        close_panel()
        return True

    def stop(self) -> None:
        """See `show_panel`."""
        self._end()

    def run(self) -> None:
        """Start the runs."""
        densities = [text.strip() for text in self.densities.text().split(";") if text.strip()]
        try:
            if not densities:
                raise InputError(Sentence("no density is given"))
            for text in densities:
                check_density(text)
            run = Run("sweep_densities", self.source, densities, "robust")
        except GpswbError as error:
            self.message.setText(say(str(error)))
            return
        self.start.setEnabled(False)
        self.bar.setValue(0)
        self.bar.show()
        self.watch = Watch(run, self._done, self._failed, self._progress)

    def _progress(self, density: str, share: float) -> None:
        self.bar.setValue(int(100 * share))
        self.message.setText(density)

    def _done(self, rows: list[dict[str, Any]]) -> None:
        self._end()
        self.message.clear()
        self.rows = rows
        self.table.setRowCount(len(rows))
        for i, row in enumerate(rows):
            for j, key in enumerate(_COLUMNS):
                value = row[key]
                shares = ("area_accuracy", "face_accuracy", "region_f1")
                text = percent(value) if key in shares else str(value)
                self.table.setItem(i, j, QtWidgets.QTableWidgetItem(text))
        self.table.resizeColumnsToContents()
        self.save.setEnabled(True)

    def _failed(self, why: str) -> None:
        self._end()
        self.message.setText(say(why))

    def _end(self) -> None:
        if self.watch is not None:
            self.watch.stop()
            self.watch = None
        self.start.setEnabled(True)
        self.bar.hide()

    def _save(self) -> None:
        path, _ = QtWidgets.QFileDialog.getSaveFileName(
            compat.main_window(), translate("GPS", "Save table"), "sweep.csv", "CSV (*.csv)"
        )
        if path:
            try:
                write_whole(Path(path), table_text(self.rows))
            except GpswbError as error:
                compat.show_error(str(error))


def table_text(rows: list[dict[str, Any]]) -> str:
    """The rows of a sweep as CSV."""
    file = io.StringIO()
    table = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
    table.writeheader()
    table.writerows(rows)
    return file.getvalue()
