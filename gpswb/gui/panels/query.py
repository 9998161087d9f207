# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that says what was recognised on a face, and takes what the user knows better."""

from __future__ import annotations

from html import escape
from typing import Any

import FreeCADGui

from gpswb.core.invariance import CLASSES
from gpswb.errors import GpswbError
from gpswb.gui import compat
from gpswb.gui.compat import QtGui, QtWidgets, say, translate
from gpswb.gui.face_text import face_rows, ranking_rows
from gpswb.gui.icons import class_icon, icon
from gpswb.gui.objects.partition import finish_change, start_change, with_override
from gpswb.gui.overrides import Action
from gpswb.gui.panels.density import let_shrink
from gpswb.gui.panels.show import close_panel
from gpswb.gui.panels.watch import Change
from gpswb.gui.partition_result import effective_result
from gpswb.gui.runs import Run
from gpswb.gui.selection import chosen_faces


class QueryPanel:
    """A task panel that follows the selection.

    Args:
        partition: a partition with a result.
    """

    def __init__(self, partition: Any) -> None:
        self.partition = partition
        self.change: Change | None = None
        self.form = QtWidgets.QWidget()
        self.form.setWindowTitle(translate("GPS", "Query face"))
        self.form.setWindowIcon(QtGui.QIcon(icon("GPS_Query")))
        self.text = QtWidgets.QLabel()
        self.text.setWordWrap(True)
        self.text.setTextFormat(compat.QtCore.Qt.RichText)
        self.text.setTextInteractionFlags(compat.QtCore.Qt.TextSelectableByMouse)
        self.merge = QtWidgets.QPushButton(translate("GPS", "Merge regions"))
        self.split = QtWidgets.QPushButton(translate("GPS", "Split into faces"))
        self.clear = QtWidgets.QPushButton(translate("GPS", "As recognised"))
        self.classes = QtWidgets.QComboBox()
        let_shrink(self.classes)
        self.classes.addItem(translate("GPS", "Change class …"), None)
        for name in CLASSES:
            self.classes.addItem(QtGui.QIcon(class_icon(name)), translate("GPS", name), name)
        self.bar = QtWidgets.QProgressBar()
        self.bar.setTextVisible(False)
        self.cancel = QtWidgets.QPushButton(translate("GPS", "Cancel"))
        self.working = QtWidgets.QWidget()
        self.working.hide()
        row = QtWidgets.QHBoxLayout(self.working)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self.bar)
        row.addWidget(self.cancel)
        better = QtWidgets.QGroupBox(translate("GPS", "You know better"))
        grid = QtWidgets.QGridLayout(better)
        grid.addWidget(self.merge, 0, 0)
        grid.addWidget(self.split, 0, 1)
        grid.addWidget(self.classes, 1, 0)
        grid.addWidget(self.clear, 1, 1)
        grid.addWidget(self.working, 2, 0, 1, 2)
        layout = QtWidgets.QVBoxLayout(self.form)
        layout.addWidget(self.text)
        layout.addStretch()
        layout.addWidget(better)
        self.merge.clicked.connect(lambda: self._override("merge"))
        self.split.clicked.connect(lambda: self._override("split"))
        self.clear.clicked.connect(lambda: self._start("", None))
        self.cancel.clicked.connect(self._cancel)
        self.classes.activated.connect(lambda _: self._override("class"))
        FreeCADGui.Selection.addObserver(self)
        self.refresh()

    def getStandardButtons(self) -> int:
        """FreeCAD asks which buttons to show."""
        return compat.standard_buttons("Close")

    def reject(self) -> bool:
        """Close; a change that isn't done is cancelled."""
        if self.change is not None:
            self.change.cancel()
        self.stop()
        close_panel()
        return True

    def stop(self) -> None:
        """See `show_panel`."""
        if self.change is not None:
            self.change.stop()
            self.change = None
        FreeCADGui.Selection.removeObserver(self)

    def refresh(self, *_: Any) -> None:
        """Say what is known of the face that was clicked last."""
        faces = chosen_faces(self.partition)
        if self.change is None:
            for button in (self.merge, self.split, self.classes):
                button.setEnabled(bool(faces))
            self.merge.setEnabled(len(faces) > 1)
            self.clear.setEnabled(bool(self.partition.Overrides))
        if not faces:
            self.text.setText(translate("GPS", "Click a face of the part."))
            return
        try:
            self.text.setText(self._page(faces))
        except GpswbError as error:
            self.text.setText(escape(say(str(error))))

    addSelection = removeSelection = setSelection = clearSelection = refresh

    def _page(self, faces: list[str]) -> str:
        stored, _ = effective_result(self.partition)
        name = faces[-1]
        rows = "".join(
            f"<tr><td style='padding-right:8px'>{escape(key)}</td><td>{escape(value)}</td></tr>"
            for key, value in face_rows(stored, name)
        )
        ranking = "".join(
            f"<tr><td>{i}.</td><td style='padding:0 8px'>{escape(translate('GPS', key))}</td>"
            f"<td align='right'>{value:.1f}</td></tr>"
            for i, (key, value) in enumerate(ranking_rows(stored, name), 1)
        )
        others = ""
        if len(faces) > 1:
            more = translate("GPS", "{} faces are selected; this is the last.").format(len(faces))
            others = f"<p>{escape(more)}</p>"
        title = translate("GPS", "Ranking by log-likelihood")
        how = translate("GPS", "Nested classes rank close: the simplest that fits is taken.")
        return (
            f"<h3>{escape(name)}</h3>{others}<table>{rows}</table>"
            f"<h4>{escape(title)}</h4><table>{ranking}</table><p><i>{escape(how)}</i></p>"
        )

    # -- what the user knows better --

    def _override(self, action: Action) -> None:
        given = self.classes.currentData() if action == "class" else None
        self.classes.setCurrentIndex(0)
        if action == "class" and given is None:
            return
        try:
            wanted = with_override(self.partition, action, chosen_faces(self.partition), given)
        except GpswbError as error:
            compat.show_error(str(error))
            return
        self._start(wanted, start_change(self.partition, wanted))

    def _start(self, wanted: str, run: Run | None) -> None:
        """Fit the regions beside the window, then change the document as one step to undo."""
        self._changing(True)
        self.change = Change(
            run,
            self.partition.Document,
            translate("GPS", "Change regions"),
            lambda described: finish_change(self.partition, wanted, described or ""),
            self._end,
            self._failed,
            self._progress,
        )

    def _progress(self, stage: str, share: float) -> None:
        self.bar.setRange(0, 100 if stage == "recognise" and share else 0)
        self.bar.setValue(int(100 * share))

    def _cancel(self) -> None:
        if self.change is not None:
            self.change.cancel()
        self._end()

    def _failed(self, why: str) -> None:
        self._end()
        compat.show_error(why)

    def _end(self) -> None:
        self.change = None
        self._changing(False)
        self.refresh()

    def _changing(self, yes: bool) -> None:
        self.working.setVisible(yes)
        self.bar.setRange(0, 0)
        for each in (self.merge, self.split, self.classes, self.clear):
            each.setEnabled(not yes)
