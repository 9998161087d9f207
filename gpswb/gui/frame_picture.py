# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tolerance indicators, datum feature symbols and characteristics as pictures, by Qt's painter."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil
from typing import Any

from gpswb.gui.compat import QtCore, QtGui
from gpswb.gui.symbols import SYMBOLS

HEIGHT = 26
"""Of a frame, in pixels of a screen at 96 dots an inch: letters as high as the window's own."""
_SYMBOL = 0.62
"""Height of a symbol, of the frame's."""
_PAD = 7
_CIRCLED = {"Ⓜ": "M", "Ⓛ": "L", "Ⓡ": "R"}
INK, PAPER = "#000000", "#ffffff"


def frame_picture(cells: Sequence[str], scale: float = 1.0, ink: str = INK) -> Any:
    """A QImage of a frame: compartments for a specification or a datum letter, plain for a size.

    Args:
        cells: what stands beside the frame (``4×``, ``UF``), then the characteristic's symbol,
            where there are such.
        scale: pixels of the screen a pixel at 96 dots an inch.
    """
    font = _font(HEIGHT * 0.58)
    metrics = QtGui.QFontMetricsF(font)
    widths = [_width(cell, metrics) for cell in cells]
    symbol = next((i for i, cell in enumerate(cells) if cell in SYMBOLS), None)
    first = 0 if symbol is None and cells[0].isalpha() else symbol
    size = (ceil(sum(widths)) + 2, HEIGHT + 2)
    image = QtGui.QImage(int(size[0] * scale), int(size[1] * scale), QtGui.QImage.Format_RGBA8888)
    image.fill(QtGui.QColor(PAPER))
    painter = QtGui.QPainter(image)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    painter.scale(scale, scale)
    painter.translate(1, 1)
    painter.setPen(_pen(ink, 1.4))
    painter.setFont(font)
    x = 0.0
    for i, (cell, width) in enumerate(zip(cells, widths, strict=True)):
        box = QtCore.QRectF(x, 0, width, HEIGHT)
        if cell in SYMBOLS:
            draw_symbol(painter, cell, box, ink)
        else:
            _text(painter, cell, box, metrics)
        if first is not None and i >= first:
            painter.drawRect(box)
        x += width
    painter.end()
    return image


def symbol_picture(symbol: str, size: int, ink: str = INK) -> Any:
    """A QPixmap of a characteristic's symbol alone, on nothing."""
    pixmap = QtGui.QPixmap(size, size)
    pixmap.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(pixmap)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    draw_symbol(painter, symbol, QtCore.QRectF(0, 0, size, size), ink)
    painter.end()
    return pixmap


def draw_symbol(painter: Any, symbol: str, box: Any, ink: str) -> None:
    """Draw a symbol amid a box."""
    side = _SYMBOL * box.height()
    left, bottom = box.center().x() - side / 2, box.center().y() + side / 2

    def polygon(points: Sequence[tuple[float, float]]) -> Any:
        return QtGui.QPolygonF(
            [QtCore.QPointF(left + side * x, bottom - side * y) for x, y in points]
        )

    painter.save()
    painter.setPen(_pen(ink, max(1.4, side / 11)))
    painter.setBrush(QtCore.Qt.NoBrush)
    for line in SYMBOLS[symbol].lines:
        painter.drawPolyline(polygon(line))
    painter.setPen(_pen(ink, 0.5))
    painter.setBrush(QtGui.QColor(ink))
    for area in SYMBOLS[symbol].filled:
        painter.drawPolygon(polygon(area))
    painter.restore()


def _text(painter: Any, text: str, box: Any, metrics: Any) -> None:
    """Text with circled modifiers, which no font is sure to have."""
    x = box.left() + (box.width() - _advance(text, metrics)) / 2
    base = box.center().y() + (metrics.ascent() - metrics.descent()) / 2
    radius = 0.36 * HEIGHT
    for char in text:
        if char in _CIRCLED:
            middle = QtCore.QPointF(x + radius, box.center().y())
            painter.drawEllipse(middle, radius, radius)
            painter.save()
            painter.setFont(_font(HEIGHT * 0.46))
            square = QtCore.QRectF(x, middle.y() - radius, 2 * radius, 2 * radius)
            painter.drawText(square, QtCore.Qt.AlignCenter, _CIRCLED[char])
            painter.restore()
        else:
            painter.drawText(QtCore.QPointF(x, base), char)
        x += _advance(char, metrics)


def _advance(text: str, metrics: Any) -> float:
    return sum(
        0.72 * HEIGHT if char in _CIRCLED else float(metrics.horizontalAdvance(char))
        for char in text
    )


def _width(cell: str, metrics: Any) -> float:
    """Of a compartment: a square at least."""
    if cell in SYMBOLS:
        return float(HEIGHT)
    return max(float(HEIGHT), _advance(cell, metrics) + 2 * _PAD)


def _font(pixels: float) -> Any:
    font = QtGui.QFont("Sans")
    font.setPixelSize(round(pixels))
    return font


def _pen(ink: str, width: float) -> Any:
    pen = QtGui.QPen(QtGui.QColor(ink), width)
    pen.setCapStyle(QtCore.Qt.RoundCap)
    pen.setJoinStyle(QtCore.Qt.MiterJoin)
    return pen
