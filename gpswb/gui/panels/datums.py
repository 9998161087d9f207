# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that edits datum features and their system: pick faces, or take what is suggested."""

from __future__ import annotations

from typing import Any

import FreeCADGui

from gpswb.errors import GpswbError
from gpswb.gps.annotation import Annotation, annotate
from gpswb.gps.explain import explain_feature, explain_lock, explain_whole
from gpswb.gui import compat
from gpswb.gui.compat import QtCore, QtGui, QtWidgets, say, translate
from gpswb.gui.datums import datums_of, set_datums, suggested_datums
from gpswb.gui.icons import icon
from gpswb.gui.one_step import one_step
from gpswb.gui.panels.show import close_panel
from gpswb.gui.part_features import features_of
from gpswb.gui.partition_result import effective_result
from gpswb.gui.present_view import lay_out_first
from gpswb.gui.selection import chosen_faces, select_faces

LETTERS = "ABCDEF"


class DatumsPanel:
    """A task panel. The letter that is pressed takes the faces that are selected.

    Args:
        partition: a partition with a result.
    """

    def __init__(self, partition: Any) -> None:
        self.partition = partition
        present = dict(datums_of(partition))
        letters = [*present, *(letter for letter in LETTERS if letter not in present)]
        self.letters = letters[: max(len(LETTERS), len(present))]
        self.faces = {letter: list(present.get(letter, ())) for letter in self.letters}
        self.system: Annotation | None = None
        self._build()
        first = next((letter for letter in self.letters if not self.faces[letter]), self.letters[0])
        chosen = chosen_faces(partition)
        if chosen and not self.faces[first]:
            self.faces[first] = chosen
        self.active = first
        self.buttons[first].setChecked(True)
        FreeCADGui.Selection.addObserver(self)
        self.refresh()

    def getStandardButtons(self) -> int:
        """FreeCAD asks which buttons to show."""
        return compat.standard_buttons("Ok", "Cancel")

    def accept(self) -> bool:
        """Make them the partition's."""
        chosen = [(letter, faces) for letter, faces in self.faces.items() if faces]
        try:
            with one_step(self.partition.Document, translate("GPS", "Datum system")):
                set_datums(self.partition, chosen, self.notation.text().strip())
                lay_out_first(self.partition)
        except GpswbError as error:
            compat.show_error(str(error))
            return False
        return self.reject()

    def reject(self) -> bool:
        """Close; nothing changes."""
        self.stop()
        FreeCADGui.Selection.clearSelection()  # the faces of a letter are selected, not the user's
        close_panel()
        return True

    def stop(self) -> None:
        """See `show_panel`."""
        FreeCADGui.Selection.removeObserver(self)

    def pick(self, letter: str) -> None:
        """Let a letter take the faces that are selected from now on; its own are selected."""
        self.active = letter
        self.buttons[letter].setChecked(True)
        select_faces(self.partition, self.faces[letter])

    def suggest(self, rank: int) -> None:
        """Take a suggested datum system."""
        suggestions = suggested_datums(self.partition)
        if rank < len(suggestions):
            self.faces = {letter: [] for letter in self.letters}
            self.faces.update({letter: list(faces) for letter, faces in suggestions[rank]})
            self.notation.clear()
            self.pick(self.active)
            self.refresh()

    def addSelection(self, *_: Any) -> None:
        """The selection has changed: the letter that is pressed follows."""
        self.faces[self.active] = chosen_faces(self.partition)
        self.refresh()

    removeSelection = setSelection = addSelection

    def clearSelection(self, *_: Any) -> None:
        """FreeCAD clears the selection before each new one: a letter keeps what it has."""

    # -- the form --

    def _build(self) -> None:
        self.form = QtWidgets.QWidget()
        self.form.setWindowTitle(translate("GPS", "Datum system"))
        self.form.setWindowIcon(QtGui.QIcon(icon("GPS_Datums")))
        layout = QtWidgets.QVBoxLayout(self.form)
        hint = QtWidgets.QLabel(translate("GPS", "Press a letter, then select its faces."))
        hint.setWordWrap(True)
        layout.addWidget(hint)
        grid = QtWidgets.QGridLayout()
        grid.setColumnStretch(1, 1)
        self.buttons: dict[str, Any] = {}
        self.texts: dict[str, Any] = {}
        group = QtWidgets.QButtonGroup(self.form)
        for row, letter in enumerate(self.letters):
            press, text = QtWidgets.QPushButton(letter), QtWidgets.QLabel()
            clear = QtWidgets.QToolButton()
            press.setCheckable(True)
            press.setFixedWidth(40)
            text.setWordWrap(True)
            clear.setText("×")
            clear.setToolTip(translate("GPS", "No faces for this letter"))
            press.clicked.connect(lambda _=False, letter=letter: self.pick(letter))
            clear.clicked.connect(lambda _=False, letter=letter: self._empty(letter))
            group.addButton(press)
            for column, widget in enumerate((press, text, clear)):
                grid.addWidget(widget, row, column)
            self.buttons[letter], self.texts[letter] = press, text
        layout.addLayout(grid)
        self.notation = QtWidgets.QLineEdit(self.partition.DatumSystem)
        self.notation.setToolTip(
            translate("GPS", "A-B is a common datum, A>< only orients; empty: each letter in turn")
        )
        self.notation.textChanged.connect(self.refresh)
        form = QtWidgets.QFormLayout()
        form.addRow(translate("GPS", "Datum system"), self.notation)
        layout.addLayout(form)
        self.suggested = QtWidgets.QPushButton(translate("GPS", "Suggested"))
        self.runner_up = QtWidgets.QPushButton(translate("GPS", "Runner-up"))
        self.suggested.clicked.connect(lambda: self.suggest(0))
        self.runner_up.clicked.connect(lambda: self.suggest(1))
        buttons = QtWidgets.QHBoxLayout()
        buttons.addWidget(self.suggested)
        buttons.addWidget(self.runner_up)
        layout.addLayout(buttons)
        self.text = QtWidgets.QLabel()
        self.text.setWordWrap(True)
        self.text.setTextFormat(QtCore.Qt.PlainText)  # it may quote what the user has typed
        layout.addWidget(self.text)
        layout.addStretch()

    def _empty(self, letter: str) -> None:
        self.faces[letter] = []
        self.pick(letter)
        self.refresh()

    def refresh(self, *_: Any) -> None:
        """Say what each letter locks and what stays free."""
        choices = [(letter, "+".join(faces)) for letter, faces in self.faces.items() if faces]
        self.notation.setPlaceholderText("|".join(letter for letter, _ in choices))
        for text in self.texts.values():
            text.clear()
        if not choices:
            self.text.setText(translate("GPS", "Without a datum nothing is locked."))
            return
        try:
            stored, _ = effective_result(self.partition)
            found = annotate(features_of(stored), choices, notation=self.notation.text().strip())
        except GpswbError as error:
            self.text.setText(say(str(error)))
            return
        assert found.system is not None
        locks = {
            name: lock
            for datum, lock in zip(found.system.datums, found.system.locks, strict=True)
            for name in datum.name.split("-")
        }
        for letter, features in found.letters.items():
            lines = [say(explain_feature(feature)) for feature in features]
            if letter in locks:
                lines.append(say(explain_lock(locks[letter])))
            self.texts[letter].setText("\n".join(lines))
        self.text.setText(say(explain_whole(found.system, found.needed)))
