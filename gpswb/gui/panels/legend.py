# SPDX-License-Identifier: LGPL-2.1-or-later
"""The legend: the shape colour wheel with counts and names; a click selects the faces."""

from __future__ import annotations

import math
from typing import Any

import FreeCADGui

from gpswb.gui import compat
from gpswb.gui.colouring import Colouring
from gpswb.gui.compat import QtCore, QtGui, QtWidgets, translate
from gpswb.gui.partition_result import effective_result
from gpswb.gui.selection import chosen_partition, select_faces

_OUTER, _INNER = 0.95, 0.45
"""Radii of the ring, of half the widget's smaller side."""


class Wheel(QtWidgets.QWidget):
    """A ring of sectors, with their counts in them."""

    clicked = QtCore.Signal(int)

    def __init__(self) -> None:
        super().__init__()
        self.found: Colouring | None = None
        self.setMinimumHeight(150)
        self.setSizePolicy(QtWidgets.QSizePolicy.Expanding, QtWidgets.QSizePolicy.Fixed)

    def paintEvent(self, event: Any) -> None:
        """Draw the sectors."""
        if self.found is None or not self.found.names:
            return
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        centre, radius = self._place()
        names, counts = self.found.names, self.found.counts
        angle = 360 / len(names)
        for i, count in enumerate(counts):
            path = QtGui.QPainterPath()
            start = 90 - angle * i
            outer, inner = (
                QtCore.QRectF(
                    centre.x() - r * radius, centre.y() - r * radius, 2 * r * radius, 2 * r * radius
                )
                for r in (_OUTER, _INNER)
            )
            path.arcMoveTo(outer, start)
            path.arcTo(outer, start, -angle)
            path.arcTo(inner, start - angle, angle)
            path.closeSubpath()
            colour = _colour(self.found, i)
            if not count:
                colour.setAlphaF(0.3)
            painter.fillPath(path, colour)
            painter.setPen(QtGui.QPen(self.palette().window().color(), 2))
            painter.drawPath(path)
            if count:
                painter.setPen(_readable_on(colour))
                middle = math.radians(angle * (i + 0.5))
                r = radius * (_OUTER + _INNER) / 2
                at = QtCore.QPointF(
                    centre.x() + r * math.sin(middle), centre.y() - r * math.cos(middle)
                )
                box = QtCore.QRectF(at.x() - 20, at.y() - 10, 40, 20)
                painter.drawText(box, QtCore.Qt.AlignCenter, str(count))

    def mousePressEvent(self, event: Any) -> None:
        """Say which sector was clicked."""
        if self.found is None or not self.found.names:
            return
        centre, radius = self._place()
        x, y = event.pos().x() - centre.x(), event.pos().y() - centre.y()
        if _INNER * radius <= math.hypot(x, y) <= _OUTER * radius:
            turn = math.atan2(x, -y) / (2 * math.pi) % 1.0
            self.clicked.emit(int(turn * len(self.found.names)))

    def _place(self) -> tuple[Any, float]:
        box = self.rect()
        return QtCore.QPointF(box.center()), min(box.width(), box.height()) / 2


class Legend(QtWidgets.QDockWidget):
    """A dock with the wheel, and a row for each colour with its name and count."""

    def __init__(self, parent: Any) -> None:
        super().__init__(translate("GPS", "GPS legend"), parent)
        self.setObjectName("GpsLegend")
        self.title = QtWidgets.QLabel()
        self.title.setWordWrap(True)
        self.wheel = Wheel()
        self.rows = QtWidgets.QListWidget()
        self.rows.setIconSize(QtCore.QSize(18, 18))
        inside = QtWidgets.QWidget()
        layout = QtWidgets.QVBoxLayout(inside)
        for widget in (self.title, self.wheel, self.rows):
            layout.addWidget(widget)
        self.setWidget(inside)
        self.wheel.clicked.connect(self.select)
        self.rows.itemClicked.connect(lambda item: self.select(self.rows.row(item)))

    def refresh(self) -> None:
        """Show the colours of the partition that is shown."""
        partition = chosen_partition()
        proxy = partition.ViewObject.Proxy if partition is not None else None
        found = getattr(proxy, "found", None)  # a document that is being opened has no proxy yet
        self.wheel.found = found
        self.rows.clear()
        if found is None:
            self.title.setText(translate("GPS", "No partition is shown."))
        else:
            by = translate("GPS", partition.ViewObject.ColourBy)
            self.title.setText(f"<b>{by}</b>")
            if not found.names:
                text = translate("GPS", "{} regions; colours only tell neighbours apart.")
                regions = len(found.palette) - 1
                self.title.setText(f"<b>{by}</b><br>{text.format(regions)}")
            for i, (name, count) in enumerate(zip(found.names, found.counts, strict=True)):
                swatch = QtGui.QPixmap(18, 18)
                swatch.fill(_colour(found, i))
                text = f"{translate('GPS', name)}: {count}"
                item = QtWidgets.QListWidgetItem(QtGui.QIcon(swatch), text)
                if not count:
                    item.setForeground(
                        self.palette().brush(QtGui.QPalette.Disabled, QtGui.QPalette.Text)
                    )
                self.rows.addItem(item)
        self.wheel.setVisible(found is not None and bool(found.names))
        self.wheel.update()

    def select(self, label: int) -> None:
        """Select the faces of a colour."""
        partition = chosen_partition()
        if partition is not None and self.wheel.found is not None:
            faces = effective_result(partition)[0].faces
            chosen = (self.wheel.found.of_face == label).nonzero()[0]
            select_faces(partition, [faces[i].name for i in chosen])


def show_legend() -> Legend:
    """Open the legend, once, and bring it up to date."""
    legend = open_legend()
    if legend is None:
        window = compat.main_window()
        legend = Legend(window)
        window.addDockWidget(QtCore.Qt.RightDockWidgetArea, legend)
        FreeCADGui.addDocumentObserver(_Follow())
    legend.show()
    legend.refresh()
    return legend


def open_legend() -> Legend | None:
    """The legend, if it was ever opened."""
    found = compat.main_window().findChild(QtWidgets.QDockWidget, "GpsLegend")
    return found if isinstance(found, Legend) else None


def refresh_legend() -> None:
    """Bring the legend up to date, if it is seen."""
    legend = open_legend()
    if legend is not None and legend.isVisible():
        legend.refresh()


class _Follow:
    """Brings the legend up to date when another document comes to the front."""

    def slotActivateDocument(self, document: Any) -> None:
        """FreeCAD tells that a document is active now."""
        QtCore.QTimer.singleShot(0, refresh_legend)

    slotDeletedDocument = slotDeletedObject = slotActivateDocument


def _colour(found: Colouring, label: int) -> Any:
    return QtGui.QColor.fromRgbF(*found.palette[label].tolist())


def _readable_on(colour: Any) -> Any:
    """Black or white, by the colour's luminance."""
    bright = 0.299 * colour.redF() + 0.587 * colour.greenF() + 0.114 * colour.blueF() > 0.5
    return QtGui.QColor(QtCore.Qt.black if bright else QtCore.Qt.white)
