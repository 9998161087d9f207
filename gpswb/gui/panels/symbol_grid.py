# SPDX-License-Identifier: LGPL-2.1-or-later
"""The symbols of ISO 1101 as a grid of buttons that tell recommended, allowed and not allowed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from gpswb.gps.characteristics import RULES
from gpswb.gps.specifications import Specification, Status
from gpswb.gui.compat import QtCore, QtGui, QtWidgets, say, translate
from gpswb.gui.frame_picture import INK, symbol_picture

SIZE = "size"
_COLUMNS = 4
_ICON = 30
_GREY = "#9a9a9a"
_STYLES: dict[Status, str] = {
    # Never by colour alone: a thick frame, a thin one, none.
    "recommended": "border: 3px solid #0072b2; background: #d6ebf7;",
    "allowed": "border: 1px solid #777777; background: #ffffff;",
    "not allowed": "border: none; background: transparent;",
}


class SymbolGrid:
    """A widget, ``form``, with a button a characteristic, and one for the size.

    Args:
        changed: called when another button is chosen.
    """

    def __init__(self, changed: Callable[[], None]) -> None:
        self._changed = changed
        self._rows: dict[str, Specification] = {}
        self._symbols: dict[str, str] = {name: rule.symbol for name, rule in RULES.items()}
        self.form = QtWidgets.QWidget()
        layout = QtWidgets.QVBoxLayout(self.form)
        layout.setContentsMargins(0, 0, 0, 0)
        grid = QtWidgets.QGridLayout()
        grid.setSpacing(4)
        group = QtWidgets.QButtonGroup(self.form)
        self.buttons: dict[str, Any] = {}
        for i, name in enumerate([*self._symbols, SIZE]):
            button = QtWidgets.QToolButton()
            button.setCheckable(True)
            button.setIconSize(QtCore.QSize(_ICON, _ICON))
            button.setSizePolicy(QtWidgets.QSizePolicy.Expanding, QtWidgets.QSizePolicy.Fixed)
            button.clicked.connect(lambda *_: self._changed())
            group.addButton(button)
            grid.addWidget(button, i // _COLUMNS, i % _COLUMNS)
            self.buttons[name] = button
        self.buttons[SIZE].setText("Ø±")
        layout.addLayout(grid)
        hint = QtWidgets.QLabel(
            translate("GPS", "Thick frame: recommended; thin: allowed; none, grey: not allowed.")
        )
        hint.setWordWrap(True)
        layout.addWidget(hint)

    @property
    def chosen(self) -> str:
        """Name of the characteristic that is chosen; empty for none."""
        return next((name for name, button in self.buttons.items() if button.isChecked()), "")

    @property
    def row(self) -> Specification | None:
        """What is known of it; None for none and for the size."""
        return self._rows.get(self.chosen)

    def choose(self, name: str) -> None:
        """Press a button."""
        self.buttons[name].setChecked(True)
        self._changed()

    def show(self, rows: Sequence[Specification], *, has_size: bool) -> None:
        """Show the states of a feature's characteristics; the recommended one is chosen."""
        self._rows = {row.characteristic: row for row in rows}
        for name, button in self.buttons.items():
            if name == SIZE:
                button.setEnabled(has_size)
                status: Status = "allowed" if has_size else "not allowed"
                why = translate("GPS", "size, with deviations or a tolerance class")
                if not has_size:
                    why = translate("GPS", "it is no feature of size")
                _show_state(button, name, status, why)
                continue
            row = self._rows.get(name)
            symbol = self._symbols[name]
            button.setEnabled(row is not None)
            status = row.status if row is not None else "not allowed"
            ink = INK if status != "not allowed" else _GREY
            button.setIcon(QtGui.QIcon(symbol_picture(symbol, _ICON, ink)))
            _show_state(button, name, status, row.reason if row is not None else "")
        for row in rows:
            if row.status == "recommended":
                self.buttons[row.characteristic].setChecked(True)


def _show_state(button: Any, name: str, status: Status, reason: str) -> None:
    button.setProperty("status", status)
    button.setStyleSheet(
        f"QToolButton {{ {_STYLES[status]} padding: 2px; color: black; }}"
        "QToolButton:checked { border: 3px double black; }"
    )
    words = f"{translate('GPS', name)}: {translate('GPS', status)}"
    button.setToolTip(f"{words}. {say(reason)}" if reason else words)
