# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of the validation: figures, and the faces that disagree."""

from __future__ import annotations

from typing import Any

from gpswb.gui import compat
from gpswb.gui.compat import QtGui, QtWidgets, translate
from gpswb.gui.icons import icon
from gpswb.gui.panels.show import close_panel
from gpswb.gui.partition_result import effective_result
from gpswb.gui.selection import select_faces


class ValidatePanel:
    """A task panel. While it is open the part is coloured by agreement.

    Args:
        partition: a partition with a result.
    """

    def __init__(self, partition: Any) -> None:
        self.partition = partition
        stored, _ = effective_result(partition)
        self.form = QtWidgets.QWidget()
        self.form.setWindowTitle(translate("GPS", "Validation against CAD"))
        self.form.setWindowIcon(QtGui.QIcon(icon("GPS_Validate")))
        layout = QtWidgets.QVBoxLayout(self.form)
        figures = QtWidgets.QFormLayout()
        figures.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)
        for name, text in figures_of(stored.document):
            value = QtWidgets.QLabel(f"<b>{text}</b>")
            value.setWordWrap(True)
            figures.addRow(name, value)
        layout.addLayout(figures)
        wrong = [face for face in stored.faces if face.disagrees]
        text = translate("GPS", "All faces agree.")
        if wrong:
            text = translate("GPS", "Faces that disagree; a click selects one:")
        layout.addWidget(QtWidgets.QLabel(text))
        self.table = QtWidgets.QTableWidget(len(wrong), 4)
        self.table.setHorizontalHeaderLabels(
            [translate("GPS", name) for name in ("Face", "Surface", "CAD", "Recognised")]
        )
        for row, face in enumerate(wrong):
            cells = (face.name, face.surface, face.true_class, face.invariance_class or "none")
            for column, cell in enumerate(cells):
                self.table.setItem(row, column, QtWidgets.QTableWidgetItem(translate("GPS", cell)))
        self.table.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        self.table.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        self.table.verticalHeader().hide()
        self.table.resizeColumnsToContents()
        self.table.setVisible(bool(wrong))
        self.table.itemSelectionChanged.connect(self._select)
        layout.addWidget(self.table)
        layout.addStretch()
        self._before = partition.ViewObject.ColourBy
        partition.ViewObject.ColourBy = "agreement with CAD"

    def getStandardButtons(self) -> int:
        """FreeCAD asks which buttons to show."""
        return compat.standard_buttons("Close")

    def reject(self) -> bool:
        """Close, and colour as before."""
        self.partition.ViewObject.ColourBy = self._before
        close_panel()
        return True

    def stop(self) -> None:
        """See `show_panel`; nothing runs here."""

    def _select(self) -> None:
        rows = {index.row() for index in self.table.selectedIndexes()}
        select_faces(self.partition, [self.table.item(row, 0).text() for row in sorted(rows)])


def figures_of(document: Any) -> list[tuple[str, str]]:
    """Names and values of the validation's figures, for people."""
    judged = document["validation"]
    if judged is None:
        return []
    right, faces = judged["right_faces"], judged["judged_faces"]
    found, features, regions = judged["found"], judged["features"], judged["regions"]
    of_features = translate("GPS", "{} of {} features, in {} regions")
    return [
        (translate("GPS", "Area accuracy"), percent(judged["area_accuracy"])),
        (
            translate("GPS", "Face accuracy"),
            f"{percent(judged['face_accuracy'])} ({right}/{faces})",
        ),
        (
            translate("GPS", "Region F1"),
            f"{percent(judged['region_f1'])} ({of_features.format(found, features, regions)})",
        ),
    ]


def percent(value: float | None) -> str:
    """A share as per cent, rounded down, so that 100 % means all."""
    if value is None:
        return "–"
    return "100 %" if value >= 1 else f"{int(value * 10000) / 100:.2f} %"
