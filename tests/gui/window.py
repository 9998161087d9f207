# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user's hands and eyes: wait, click, look."""

import os
import time
from pathlib import Path

import FreeCAD
import FreeCADGui

from gpswb.gui.compat import QtCore, QtGui, QtWidgets

PICTURES = Path(os.environ["GPSWB_GUI_PICTURES"])


def wait(until, timeout=60.0):
    """Let the window live until something is true."""
    end = time.monotonic() + timeout
    while not until():
        assert time.monotonic() < end, "waited in vain"
        QtWidgets.QApplication.processEvents()
        time.sleep(0.005)


def settle(seconds=0.3):
    """Let the window live for a while."""
    end = time.monotonic() + seconds
    wait(lambda: time.monotonic() > end)


def button(panel_or_window, text):
    """The button that says ``text``, if it is seen."""
    found = [
        each
        for each in FreeCADGui.getMainWindow().findChildren(QtWidgets.QPushButton)
        if each.text().replace("&", "") == text and each.isVisible()
    ]
    assert found, f"no button {text!r}"
    return found[0]


def steady():
    """Wait until panels and docks that have just opened no longer change the view's size."""
    size = None
    while size != view_area().size():
        size = view_area().size()
        settle(0.7)


def view_area():
    """The widget of the 3-D view that takes the mouse."""
    area = FreeCADGui.getMainWindow().findChild(QtWidgets.QMdiArea)
    return area.activeSubWindow().findChild(QtWidgets.QGraphicsView).viewport()


def click_in_view(x, y):
    """Press and release the left mouse button at a pixel of the 3-D view, origin at its top."""
    drag_in_view((x, y))


def drag_in_view(start, *steps):
    """Press the left mouse button at a pixel, move by each of the steps, and let go."""
    area = view_area()
    place = QtCore.QPointF(*start)
    left, none = QtCore.Qt.LeftButton, QtCore.Qt.NoButton
    move = QtCore.QEvent.MouseMove
    events = [(move, place, none, none), (QtCore.QEvent.MouseButtonPress, place, left, left)]
    for step in steps:
        for _ in range(4):
            place = place + QtCore.QPointF(*step) / 4
            events.append((move, place, none, left))
    events.append((QtCore.QEvent.MouseButtonRelease, place, left, none))
    for kind, at, pressed, held in events:
        event = QtGui.QMouseEvent(kind, at, pressed, held, QtCore.Qt.NoModifier)
        QtWidgets.QApplication.sendEvent(area, event)
        settle(0.05)


def pixel_of_face(name):
    """A pixel of the 3-D view (origin at its top) amid those under which a face is seen."""
    steady()
    view, area = FreeCADGui.activeDocument().activeView(), view_area()
    scale = area.devicePixelRatioF()
    seen = []
    for y in range(5, area.height(), 10):
        for x in range(5, area.width(), 10):
            info = view.getObjectInfo((int(x * scale), int((area.height() - 1 - y) * scale)))
            if info and info.get("Component") == name:
                seen.append((x, y))
    assert seen, f"{name} isn't seen"
    return seen[len(seen) // 2]


def pixels(name="view"):
    """The colours of the 3-D view, as a set of (red, green, blue)."""
    path = PICTURES / f"{name}.png"
    FreeCADGui.activeDocument().activeView().saveImage(str(path), 400, 300, "White")
    image = QtGui.QImage(str(path))
    return [
        QtGui.QColor(image.pixel(x, y)).getRgb()[:3]
        for y in range(0, image.height(), 2)
        for x in range(0, image.width(), 2)
    ]


def picture(name):
    """A picture of the whole window as the user sees it; ``grab`` would leave the view blank."""
    settle()
    window = FreeCADGui.getMainWindow()
    PICTURES.mkdir(parents=True, exist_ok=True)
    assert window.screen().grabWindow(window.winId()).save(str(PICTURES / f"{name}.png"))


def objects(document=None):
    """Names of a document's objects."""
    return [obj.Name for obj in (document or FreeCAD.ActiveDocument).Objects]


def hue_is(pixel, colour):
    """Whether a pixel has a colour's hue: what is lit from the side is darker."""
    top = max(pixel)
    if top < 60 or max(pixel) - min(pixel) < 40:
        return False
    a = [value / top for value in pixel]
    b = [value / max(colour) for value in colour]
    return all(abs(x - y) < 0.25 for x, y in zip(a, b, strict=True))
