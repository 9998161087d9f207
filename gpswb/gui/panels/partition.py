# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that partitions a part: density, mode, count of triangles, run, cancel."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import FreeCAD
import FreeCADGui

from gpswb.cad.freecad_measured import is_measurement
from gpswb.errors import GpswbError, InputError
from gpswb.gui import compat, preferences
from gpswb.gui.compat import QT_TRANSLATE_NOOP, QtCore, QtWidgets, say, translate
from gpswb.gui.objects.partition import (
    AS_READ,
    check_density,
    finish_run,
    make_partition,
    start_run,
    usable_source,
)
from gpswb.gui.panels.density import DensityWidget, let_shrink
from gpswb.gui.panels.show import close_panel
from gpswb.gui.panels.watch import Change, Watch
from gpswb.gui.runs import Run

_MODES = {
    "robust": QT_TRANSLATE_NOOP("GPS", "Robust: consensus of vertex positions"),
    "corrected": QT_TRANSLATE_NOOP("GPS", "Corrected: the paper's flow, errors mended"),
    "paper": QT_TRANSLATE_NOOP("GPS", "Paper: as printed"),
}
_STAGES = {
    "read": QT_TRANSLATE_NOOP("GPS", "Reading the shape"),
    "tessellate": QT_TRANSLATE_NOOP("GPS", "Meshing"),
    "curvature": QT_TRANSLATE_NOOP("GPS", "Curvature and shape types"),
    "initial": QT_TRANSLATE_NOOP("GPS", "Initial regions"),
    "refine": QT_TRANSLATE_NOOP("GPS", "Refined regions"),
    "recognise": QT_TRANSLATE_NOOP("GPS", "Recognition"),
    "store": QT_TRANSLATE_NOOP("GPS", "Storing the result"),
}
_ORDER = tuple(_STAGES)
_COUNT_DELAY_MS = 400
"""After the last change of the density, before the shape is meshed to count its triangles."""


class PartitionPanel:
    """A task panel; see FreeCAD's ``Gui.Control.showDialog``.

    The count of triangles is no estimate: the shape is meshed beside the window, as a run would.

    Args:
        source: the part; None lets the user pick one.
        partition: run this one again.
    """

    def __init__(self, source: Any = None, partition: Any = None) -> None:
        self.partition = partition
        self.source = partition.Source if partition else source
        self.change: Change | None = None
        self._made: Any = None
        self._count: Watch | None = None
        self._build(partition)
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._start_count)
        FreeCADGui.Selection.addObserver(self)
        self._show_source()

    # -- what FreeCAD asks for --

    def getStandardButtons(self) -> int:
        return compat.standard_buttons("Ok", "Cancel")

    def modifyStandardButtons(self, box: Any) -> None:
        """FreeCAD hands over its button box."""
        self.button = box.button(QtWidgets.QDialogButtonBox.Ok)
        self.button.setText(translate("GPS", "Partition"))
        self._show_source()

    def accept(self) -> bool:
        """Start the run; the panel closes when it has ended well."""
        if self.change is None and self.source is not None:
            self._start()
        return False

    def reject(self) -> bool:
        """Cancel: nothing of a run that has not ended is left."""
        if self.change is not None:
            self.change.cancel()
        self.stop()
        close_panel()
        return True

    def stop(self) -> None:
        """See `show_panel`."""
        self._stop_count()
        FreeCADGui.Selection.removeObserver(self)
        if self.change is not None:
            self.change.stop()
            self.change = None

    def addSelection(self, document: str, name: str, sub: str, point: Any) -> None:
        """The user has clicked something: take it as the part, if it is one."""
        if self.partition is not None or self.change is not None:
            return
        obj = FreeCAD.getDocument(document).getObject(name)
        try:
            self.source = usable_source(obj)
        except InputError:
            return
        self._show_source()

    # -- the form --

    def _build(self, partition: Any) -> None:
        self.form = QtWidgets.QWidget()
        self.form.setWindowTitle(translate("GPS", "Partition"))
        self.form.setWindowIcon(compat.QtGui.QIcon(_icon()))
        self.part = QtWidgets.QLabel()
        self.part.setWordWrap(True)
        self.density = DensityWidget(
            partition.Density
            if partition and partition.Density != AS_READ
            else preferences.default_density()
        )
        self.mode = QtWidgets.QComboBox()
        let_shrink(self.mode)
        for mode, text in _MODES.items():
            self.mode.addItem(translate("GPS", text), mode)
        mode = partition.Mode if partition else preferences.default_mode()
        self.mode.setCurrentIndex(self.mode.findData(mode))
        self.count = QtWidgets.QLabel()
        self.count.setWordWrap(True)
        self.count.setTextFormat(QtCore.Qt.PlainText)
        self.bar = QtWidgets.QProgressBar()
        self.bar.setRange(0, 100)
        self.message = QtWidgets.QLabel()
        self.message.setWordWrap(True)
        self.inputs = QtWidgets.QWidget()
        rows = QtWidgets.QFormLayout(self.inputs)
        rows.setContentsMargins(0, 0, 0, 0)
        rows.addRow(translate("GPS", "Part"), self.part)
        rows.addRow(translate("GPS", "Density"), self.density)
        rows.addRow(translate("GPS", "Triangles"), self.count)
        rows.addRow(translate("GPS", "Mode"), self.mode)
        layout = QtWidgets.QVBoxLayout(self.form)
        layout.addWidget(self.inputs)
        layout.addWidget(self.bar)
        layout.addWidget(self.message)
        layout.addStretch()
        self.bar.hide()
        self.density.changed.connect(self._density_changed)

    def _show_source(self) -> None:
        if self.source is None:
            self.part.setText(translate("GPS", "click a part in the 3-D view or the tree"))
        else:
            self.part.setText(f"<b>{_plain(self.source.Label)}</b>, {_size(self.source)}")
            self.density.setEnabled(not is_measurement(self.source))
        if hasattr(self, "button"):
            self.button.setEnabled(self.source is not None)
        self._density_changed()

    # -- the count of triangles --

    def _density_changed(self) -> None:
        self._stop_count()
        if self.source is not None and is_measurement(self.source):
            self.count.setText(translate("GPS", "as measured"))
            return
        self.count.setText("…" if self.source is not None else "")
        if self.source is not None and hasattr(self, "_timer"):
            self._timer.start(_COUNT_DELAY_MS)

    def _start_count(self) -> None:
        try:
            check_density(self.density.density())
            run = Run("count_triangles", self.source, self.density.density())
        except GpswbError as error:
            self.count.setText(say(str(error)))
            return
        self.count.setText(translate("GPS", "counting …"))
        self._count = Watch(run, self._counted, self._not_counted)

    def _counted(self, found: dict[str, Any]) -> None:
        self._stop_count()
        self.count.setText(f"{found['triangles']:,} ({found['mesher']})".replace(",", "\u202f"))

    def _not_counted(self, why: str) -> None:
        self._stop_count()
        self.count.setText(say(why))

    def _stop_count(self) -> None:
        if hasattr(self, "_timer"):
            self._timer.stop()
        if self._count is not None:
            self._count.stop()
            self._count = None

    # -- the run --

    def _start(self) -> None:
        self._stop_count()
        self.message.clear()
        overrides = self.partition.Overrides if self.partition is not None else ""
        density, mode = self.density.density(), self.mode.currentData()
        try:
            run = start_run(self.source, density, mode, overrides)
        except GpswbError as error:
            self._failed(str(error))
            return
        self.inputs.setEnabled(False)
        self.button.setEnabled(False)
        self.bar.setValue(0)
        self.bar.show()

        def put(found: dict[str, Any]) -> Iterator[None]:
            obj = self.partition
            if obj is None:
                obj = self._made = make_partition(self.source, density, mode, compute=False)
            else:
                if obj.Density != AS_READ:
                    obj.Density = density
                obj.Mode = mode
            yield from finish_run(obj, found, run.folder / "labels.npz")

        self.change = Change(
            run,
            self.source.Document,
            translate("GPS", "Partition"),
            put,
            self._stored,
            self._failed,
            self._progress,
        )

    def _progress(self, stage: str, share: float) -> None:
        if stage == Change.CHANGING:
            self.bar.setRange(0, 0)
            self.message.setText(translate("GPS", "Storing the result"))
        elif stage in _ORDER:
            step = 100 / len(_ORDER)
            self.bar.setValue(int(step * (_ORDER.index(stage) + share)))
            self.message.setText(translate("GPS", _STAGES[stage]))

    def _stored(self) -> None:
        from gpswb.gui.panels.legend import show_legend

        self.change = None
        FreeCADGui.Selection.removeObserver(self)
        close_panel()
        FreeCADGui.Selection.clearSelection()  # a selected part hides its colours
        obj = self.partition or self._made
        FreeCADGui.getDocument(obj.Document.Name).toggleTreeItem(obj, 2)  # open it in the tree
        show_legend()

    def _failed(self, why: str) -> None:
        self.change = None
        self.bar.hide()
        self.bar.setRange(0, 100)
        self.inputs.setEnabled(True)
        self.button.setEnabled(True)
        self.message.setText(f"<span style='color:#c00000'>{_plain(say(why))}</span>")


def _size(source: Any) -> str:
    """How many faces, triangles or points a part has."""
    if source.isDerivedFrom("Mesh::Feature"):
        text, count = translate("GPS", "{} triangles"), source.Mesh.CountFacets
    elif source.isDerivedFrom("Points::Feature"):
        text, count = translate("GPS", "{} points"), source.Points.CountPoints
    else:
        text, count = translate("GPS", "{} faces"), len(source.Shape.Faces)
    return str(text.format(f"{count:,}".replace(",", "\u202f")))


def _plain(text: str) -> str:
    """A text that stands for itself where a label reads HTML."""
    return text.replace("&", "&amp;").replace("<", "&lt;")


def _icon() -> str:
    from gpswb.gui.icons import icon

    return icon("GPS_Partition")
