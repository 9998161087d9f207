# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that puts specifications on features: what may be said, and why the rest may not."""

from __future__ import annotations

from html import escape
from typing import Any

import FreeCADGui

from gpswb.errors import GpswbError
from gpswb.gps.explain import explain_feature
from gpswb.gps.gps_feature import GpsFeature
from gpswb.gps.specifications import Specification
from gpswb.gps.specified import specify
from gpswb.gui import compat
from gpswb.gui.annotation import annotation_of
from gpswb.gui.annotation_record import SpecificationRecord
from gpswb.gui.compat import QtCore, QtGui, QtWidgets, say, translate
from gpswb.gui.frame_picture import frame_picture
from gpswb.gui.icons import icon
from gpswb.gui.objects.annotation import record_of
from gpswb.gui.one_step import one_step
from gpswb.gui.panels.density import let_shrink
from gpswb.gui.panels.show import close_panel
from gpswb.gui.panels.symbol_grid import SIZE, SymbolGrid
from gpswb.gui.part_features import features_at
from gpswb.gui.partition_result import effective_result
from gpswb.gui.present_view import lay_out_first
from gpswb.gui.selection import chosen_faces, select_faces
from gpswb.gui.specifications import set_specification
from gpswb.io.specification_file import specification_row

_MODIFIERS = ("M", "L", "R")


class AnnotatePanel:
    """A task panel that follows the selection, or edits one specification.

    Args:
        partition: a partition with a result.
        obj: the specification to change; None adds new ones.
    """

    def __init__(self, partition: Any, obj: Any = None) -> None:
        self.partition = partition
        self.obj = obj
        self.annotation = annotation_of(partition)
        self.found: list[GpsFeature] = []
        self._build()
        if obj is not None:
            self._load(obj)
        FreeCADGui.Selection.addObserver(self)
        self.refresh()

    def getStandardButtons(self) -> int:
        """FreeCAD asks which buttons to show."""
        return compat.standard_buttons("Close")

    def reject(self) -> bool:
        """Close."""
        self.stop()
        close_panel()
        return True

    def stop(self) -> None:
        """See `show_panel`."""
        FreeCADGui.Selection.removeObserver(self)

    @property
    def feature(self) -> GpsFeature | None:
        """The feature that the specification is for."""
        index = self.features.currentIndex()
        return self.found[index] if 0 <= index < len(self.found) else None

    def refresh(self, *_: Any) -> None:
        """Offer the features of the faces that are selected."""
        faces = chosen_faces(self.partition)
        stored, _ = effective_result(self.partition)
        new = features_at(stored, faces) if faces else []
        if [f.id for f in new] == [f.id for f in self.found] and self.features.count():
            return
        self.found = new
        self.features.blockSignals(True)
        self.features.clear()
        for feature in new:
            self.features.addItem(say(explain_feature(feature)))
        if not new:
            self.features.addItem(translate("GPS", "Select a face of the part."))
        self.features.blockSignals(False)
        self._show_feature()

    addSelection = removeSelection = setSelection = clearSelection = refresh

    def apply(self) -> None:
        """Put the specification on the feature, or change it, as one step to undo."""
        feature = self.feature
        if feature is None:
            return
        try:
            with one_step(self.partition.Document, translate("GPS", "Specification")):
                set_specification(self.partition, self.obj, feature.faces, **self.words())
                lay_out_first(self.partition)
        except GpswbError as error:
            compat.show_error(str(error))
            return
        if self.obj is not None:
            self.reject()
            return
        self.annotation = annotation_of(self.partition)
        self._preview()

    def words(self) -> dict[str, str]:
        """What the form says, by the names of the table of specifications."""
        name = self.grid.chosen
        if name == SIZE:
            fields = {"upper": self.upper, "lower": self.lower, "fit": self.fit}
            return {"characteristic": name, **{k: f.text().strip() for k, f in fields.items()}}
        given = "".join(m for m, box in self.modifiers.items() if box.isChecked())
        return {
            "characteristic": name,
            "value": self.value.text().strip() or "?",
            "datums": self.datums.text().strip(),
            "modifiers": given,
        }

    # -- the form --

    def _build(self) -> None:
        self.form = QtWidgets.QWidget()
        self.form.setWindowTitle(translate("GPS", "Specification"))
        self.form.setWindowIcon(QtGui.QIcon(icon("GPS_Annotate")))
        layout = QtWidgets.QVBoxLayout(self.form)
        self.features = QtWidgets.QComboBox()
        let_shrink(self.features)
        self.features.currentIndexChanged.connect(self._show_feature)
        self.grid = SymbolGrid(self._show_characteristic)
        self.reason = QtWidgets.QLabel()
        self.reason.setWordWrap(True)
        self.value = QtWidgets.QLineEdit("?")
        self.value.setToolTip(translate("GPS", "Width or diameter of the zone, mm; ? is open"))
        self.datums = QtWidgets.QLineEdit()
        self.upper, self.lower, self.fit = (QtWidgets.QLineEdit() for _ in range(3))
        self.upper.setPlaceholderText("?")
        self.lower.setPlaceholderText("?")
        self.fit.setPlaceholderText("H7")
        self.modifiers = {name: QtWidgets.QCheckBox(name) for name in _MODIFIERS}
        boxes = QtWidgets.QHBoxLayout()
        for box in self.modifiers.values():
            boxes.addWidget(box)
            box.toggled.connect(self._preview)
        self.boxes = QtWidgets.QWidget()
        self.boxes.setLayout(boxes)
        boxes.setContentsMargins(0, 0, 0, 0)
        self.rows = QtWidgets.QFormLayout()
        for text, field in (
            (translate("GPS", "Value"), self.value),
            (translate("GPS", "Modifiers"), self.boxes),
            (translate("GPS", "Datums"), self.datums),
            (translate("GPS", "Upper deviation"), self.upper),
            (translate("GPS", "Lower deviation"), self.lower),
            (translate("GPS", "Tolerance class"), self.fit),
        ):
            self.rows.addRow(text, field)
        for field in (self.value, self.datums, self.upper, self.lower, self.fit):
            field.textChanged.connect(self._preview)
        self.preview = QtWidgets.QLabel()
        self.preview.setMinimumHeight(34)
        self.message = QtWidgets.QLabel()
        self.message.setWordWrap(True)
        self.message.setTextFormat(QtCore.Qt.PlainText)  # it may quote what the user has typed
        new = self.obj is None
        self.button = QtWidgets.QPushButton(
            translate("GPS", "Add") if new else translate("GPS", "Change")
        )
        self.button.clicked.connect(self.apply)
        for each in (self.features, self.grid.form, self.reason):
            layout.addWidget(each)
        layout.addLayout(self.rows)
        for each in (self.preview, self.message, self.button):
            layout.addWidget(each)
        layout.addStretch()

    def _load(self, obj: Any) -> None:
        """Show a specification that is there."""
        record = record_of(obj)
        assert isinstance(record, SpecificationRecord)
        select_faces(self.partition, [name for _, names in obj.Faces for name in names])
        self.refresh()
        self.grid.choose(record.words["characteristic"])
        given = record.words["modifiers"].upper()
        for name, box in self.modifiers.items():
            box.setChecked(name in given)
        self.value.setText(record.words["value"] or "?")
        for key in ("datums", "upper", "lower", "fit"):
            getattr(self, key).setText(record.words[key])

    def _show_feature(self, *_: Any) -> None:
        feature = self.feature
        rows = self.annotation.permitted[feature.id] if feature is not None else ()
        self.grid.show(rows, has_size=feature is not None and feature.size is not None)
        self._show_characteristic()

    def _show_characteristic(self) -> None:
        """A symbol was chosen: say why, and fill in what belongs to it."""
        name, row = self.grid.chosen, self.grid.row
        sized = name == SIZE
        shown = {
            self.value: not sized,
            self.boxes: not sized and row is not None and bool(row.modifiers),
            self.datums: not sized and row is not None and row.datum != "none",
            **dict.fromkeys((self.upper, self.lower, self.fit), sized),
        }
        for field, visible in shown.items():
            field.setVisible(visible)
            self.rows.labelForField(field).setVisible(visible)
        self.datums.setText(row.datums if row is not None else "")
        if not shown[self.boxes]:
            for box in self.modifiers.values():
                box.setChecked(False)
        self.reason.setText(_said(row) if row is not None else "")
        self._preview()

    def _preview(self, *_: Any) -> None:
        """Show the frame as it would be, or why it can't."""
        self.preview.clear()
        self.message.clear()
        self.button.setEnabled(False)
        feature, row = self.feature, self.grid.row
        if feature is None or (row is None and self.grid.chosen != SIZE):
            return
        try:
            choice = {"feature": feature.name, **self.words()}
            wanted = specification_row(translate("GPS", "Specification"), choice)
            (said,) = specify([wanted], self.annotation.table, self.annotation.letters)
        except GpswbError as error:
            self.message.setText(say(str(error)))
            return
        picture = frame_picture(said.cells, self.form.devicePixelRatioF())
        pixmap = QtGui.QPixmap.fromImage(picture)
        pixmap.setDevicePixelRatio(self.form.devicePixelRatioF())
        self.preview.setPixmap(pixmap)
        remark = getattr(said, "remark", "")
        self.message.setText(say(remark))
        self.button.setEnabled(not remark)


def _said(row: Specification) -> str:
    """A characteristic with its state and the reason, and the zone where it may be used."""
    name, status = translate("GPS", row.characteristic), translate("GPS", row.status)
    lines = [f"<b>{escape(name)}</b>: {escape(status)}", escape(say(row.reason))]
    if row.status != "not allowed":
        lines.append(f"{translate('GPS', 'Zone')}: {escape(say(row.zone))}")
    return "<br>".join(lines)
