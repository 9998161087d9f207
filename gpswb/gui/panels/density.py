# SPDX-License-Identifier: LGPL-2.1-or-later
"""Widget for a mesh density: a preset, or a kind with a value."""

from __future__ import annotations

from typing import Any

from gpswb.cad.density import Density
from gpswb.gui.compat import QT_TRANSLATE_NOOP, QtCore, QtWidgets, translate

_CONTEXT = "GPS"
_PRESETS = (
    ("auto", QT_TRANSLATE_NOOP("GPS", "Automatic: follows curvature")),
    ("coarse", QT_TRANSLATE_NOOP("GPS", "Coarse")),
    ("medium", QT_TRANSLATE_NOOP("GPS", "Medium")),
    ("fine", QT_TRANSLATE_NOOP("GPS", "Fine")),
    ("stl", QT_TRANSLATE_NOOP("GPS", "As FreeCAD's STL export")),
)
_VALUES = (
    # rule, text, least, most, decimals, suffix, start
    ("turn", QT_TRANSLATE_NOOP("GPS", "Elements a turn"), 3, 720, 0, "", 36),
    ("edge", QT_TRANSLATE_NOOP("GPS", "Edge length"), 1e-4, 1e6, 4, " mm", 1.0),
    ("deflection", QT_TRANSLATE_NOOP("GPS", "Deflection"), 1e-5, 1e5, 5, " mm", 0.05),
    ("vertices", QT_TRANSLATE_NOOP("GPS", "Vertices"), 4, 2e7, 0, "", 10_000),
    ("triangles", QT_TRANSLATE_NOOP("GPS", "Triangles"), 4, 2e7, 0, "", 20_000),
)


_VALUE_WIDTH = 80
"""Pixels: room for the usual values. Left to itself it has room for the largest, and the panel is
wider than FreeCAD's task view."""


def let_shrink(box: Any) -> None:
    """Let a list be narrower than its longest entry: FreeCAD's task view may be narrow."""
    box.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
    box.setMinimumContentsLength(10)


class DensityWidget(QtWidgets.QWidget):
    """A list of kinds with, where the kind has one, a value beside it."""

    changed = QtCore.Signal()

    def __init__(self, density: str) -> None:
        super().__init__()
        self.kind = QtWidgets.QComboBox()
        self.value = QtWidgets.QDoubleSpinBox()
        self.value.setKeyboardTracking(False)
        self.value.setMinimumWidth(_VALUE_WIDTH)
        let_shrink(self.kind)
        for rule, text in _PRESETS:
            self.kind.addItem(translate(_CONTEXT, text), rule)
        self.kind.insertSeparator(len(_PRESETS))
        for rule, text, *_ in _VALUES:
            self.kind.addItem(translate(_CONTEXT, text), rule)
        layout = QtWidgets.QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.kind, 3)
        layout.addWidget(self.value, 2)
        self.kind.currentIndexChanged.connect(self._kind_changed)
        self.value.valueChanged.connect(self.changed)
        self.set_density(density)

    def density(self) -> str:
        """The density in the command line's words."""
        rule = self.kind.currentData()
        if rule in dict(_PRESETS):
            return str(rule)
        value = self.value.value()
        if rule == "deflection" and value == self._given.value and self._given.rule == rule:
            return str(self._given)  # its angle has no field of its own
        return str(Density(rule, value))

    def set_density(self, text: str) -> None:
        """Show a density.

        Raises:
            ValueError: it isn't valid.
        """
        self._given = Density.parse(text)
        self.kind.setCurrentIndex(self.kind.findData(self._given.rule))
        self._kind_changed()
        if self._given.rule not in dict(_PRESETS):
            self.value.setValue(self._given.value)

    def _kind_changed(self) -> None:
        rule = self.kind.currentData()
        self.value.setVisible(rule not in dict(_PRESETS))
        for name, _, least, most, decimals, suffix, start in _VALUES:
            if name == rule:
                self.value.blockSignals(True)
                self.value.setDecimals(decimals)
                self.value.setRange(least, most)
                self.value.setSuffix(suffix)
                self.value.setValue(start)
                self.value.blockSignals(False)
        self.changed.emit()
