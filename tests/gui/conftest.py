# SPDX-License-Identifier: LGPL-2.1-or-later
"""A window with the workbench active and one part in it."""

import sys

import FreeCAD
import FreeCADGui
import Part
import pytest
from window import settle

from gpswb.gui.compat import QtCore, QtWidgets
from gpswb.gui.objects.partition import finish_run, make_partition, start_run
from gpswb.gui.panels.show import shown_panel


@pytest.fixture(scope="session", autouse=True)
def _window():
    arrange()


def arrange():
    """The window as a user might have it, with the workbench active."""
    window = FreeCADGui.getMainWindow()
    window.setGeometry(0, 0, 1280, 800)
    FreeCADGui.activateWorkbench("GpsWorkbench")
    docks = {dock.objectName(): dock for dock in window.findChildren(QtWidgets.QDockWidget)}
    for name in ("Python console", "Report view"):
        if name in docks:
            docks[name].hide()
    if "Combo View" in docks:
        window.resizeDocks([docks["Combo View"]], [320], QtCore.Qt.Horizontal)
    settle()


@pytest.fixture(autouse=True)
def errors_of_slots(monkeypatch):
    """What Qt calls can't raise into a test: an error there is printed, and fails the test here."""
    raised = []
    monkeypatch.setattr(sys, "excepthook", lambda *error: raised.append(error))
    yield
    assert raised == []


@pytest.fixture
def document():
    made = FreeCAD.newDocument("Test")
    made.UndoMode = 1
    settle(0.1)
    yield made
    if shown_panel() is not None:
        shown_panel().reject()
    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)
    settle(0.1)


@pytest.fixture
def block(document):
    """A block with a hole and a dome, its faces in colours of the user's."""
    part = document.addObject("Part::Feature", "Block")
    part.Shape = block_shape()
    document.recompute()
    part.ViewObject.DiffuseColor = own_colours(part)
    FreeCADGui.activeDocument().activeView().viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    settle()
    return part


@pytest.fixture(scope="session")
def found():
    """What a run on the block finds, once for all tests that are not about running."""
    document = FreeCAD.newDocument("Once")
    part = document.addObject("Part::Feature", "Block")
    part.Shape = block_shape()
    work = start_run(part, "auto", "robust")
    yield work.result(), work.folder / "labels.npz"
    work.close()


@pytest.fixture
def partition(found, block):
    made = make_partition(block, "auto", "robust", compute=False)
    for _ in finish_run(made, *found):
        pass
    settle()
    return made


def block_shape():
    hole = Part.makeCylinder(6.0, 20.0, FreeCAD.Vector(12.0, 15.0, 0.0))
    dome = Part.makeSphere(8.0, FreeCAD.Vector(32.0, 15.0, 20.0))
    return Part.makeBox(44.0, 30.0, 20.0).cut(hole).fuse(dome)


def own_colours(part):
    count = len(part.Shape.Faces)
    return [(0.2, 0.4 + 0.5 * i / count, 0.8) for i in range(count)]
