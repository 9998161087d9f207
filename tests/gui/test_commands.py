# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands are there, can be run when they can do something, and do it."""

import json
from pathlib import Path

import FreeCAD
import FreeCADGui
import ImportGui
import Part
from test_partition_panel import rgb, true_classes
from window import button, click_in_view, picture, settle, steady, wait

import gpswb
from gpswb.gui.commands import GROUPS, MODULES
from gpswb.gui.commands.import_part import bring_in
from gpswb.gui.compat import QtCore, QtGui, QtWidgets, face_colours, show_error
from gpswb.gui.exports import export
from gpswb.gui.importing import import_part
from gpswb.gui.objects.partition import make_partition
from gpswb.gui.panels.show import shown_panel
from gpswb.io.colours import WHEEL
from gpswb.sentence import Sentence

NEED_RESULT = {"GPS_Validate", "GPS_Legend", "GPS_Query", "GPS_Report", "GPS_Export"}


def active():
    return {name for name in MODULES if FreeCADGui.Command.get(name).isActive()}


def test_commands_are_active_only_when_they_can_run(document):
    assert active() == {"GPS_Import"}
    part = document.addObject("Part::Feature", "Box")
    part.Shape = Part.makeBox(1.0, 2.0, 3.0)
    assert active() == {"GPS_Import", "GPS_Partition", "GPS_Sweep"}
    make_partition(part, density="coarse")
    assert active() >= {"GPS_Import", "GPS_Partition", "GPS_Sweep", "GPS_Colour", *NEED_RESULT}


def test_menu_toolbars_and_icons():
    window = FreeCADGui.getMainWindow()
    (menu,) = (a for a in window.menuBar().actions() if a.text().replace("&", "") == "GPS")
    shown = [a.text().replace("&", "") for a in menu.menu().actions() if not a.isSeparator()]
    assert shown[:2] == ["Import part…", "Partition…"]
    assert len(shown) == sum(len(names) for _, names in GROUPS)
    bars = {bar.windowTitle() for bar in window.findChildren(QtWidgets.QToolBar)}
    assert bars >= {title for title, _ in GROUPS}
    icons = Path(gpswb.__file__).parents[1] / "icons"
    for name in MODULES:
        info = FreeCADGui.Command.get(name).getInfo()
        assert info["toolTip"]
        path = icons / f"{name}.svg"
        assert path.stat().st_size <= 10_000
        assert not QtGui.QIcon(str(path)).pixmap(24, 24).isNull()


def test_import_a_step_file_and_take_it_back(document, tmp_path):
    path = tmp_path / "two.step"
    hole = Part.makeCylinder(2.0, 10.0)
    Part.makeBox(10.0, 10.0, 10.0).cut(hole).exportStep(str(path))
    bring_in(path)
    settle()
    (part,) = FreeCADGui.Selection.getSelection()
    assert part.Label == "two"
    assert FreeCADGui.Command.get("GPS_Partition").isActive()
    document.undo()
    assert document.Objects == []


def test_the_user_knows_better(block, partition):
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.runCommand("GPS_Query", 0)
    panel = shown_panel()
    planes = [f"Face{i + 1}" for i, name in enumerate(true_classes(block)) if name == "planar"]
    for name in planes[:2]:
        FreeCADGui.Selection.addSelection(block.Document.Name, block.Name, name)
    settle()
    before, count = list(partition.Classes), len(partition.Group)
    panel.merge.click()
    wait(lambda: panel.change is None)
    assert len(partition.Group) == count - 1
    assert partition.Classes[int(planes[0][4:]) - 1] == "prismatic"
    panel.classes.setCurrentIndex(panel.classes.findData("complex"))
    panel.classes.activated.emit(panel.classes.currentIndex())
    wait(lambda: panel.change is None)
    assert partition.Classes[int(planes[1][4:]) - 1] == "complex"
    block.Document.undo()
    block.Document.undo()
    settle()
    assert list(partition.Classes) == before
    assert len(partition.Group) == count
    assert not partition.Overrides


def test_validate_shows_where_it_disagrees(block, partition):
    result = json.loads(partition.Result)
    result["faces"][2]["true_class"] = "complex"
    partition.Result = json.dumps(result)
    FreeCADGui.runCommand("GPS_Validate", 0)
    settle()
    panel = shown_panel()
    picture("validate")
    assert partition.ViewObject.ColourBy == "agreement with CAD"
    assert panel.table.rowCount() == 1
    panel.table.selectRow(0)
    (chosen,) = FreeCADGui.Selection.getSelectionEx()
    assert chosen.SubElementNames == ("Face3",)
    panel.reject()
    assert partition.ViewObject.ColourBy == "invariance class"


def test_sweep(block):
    FreeCADGui.Selection.addSelection(block)
    FreeCADGui.runCommand("GPS_Sweep", 0)
    settle()
    panel = shown_panel()
    panel.densities.setText("coarse; silly")
    button(panel, "Run").click()
    assert "silly" in panel.message.text()
    panel.densities.setText("coarse; medium")
    button(panel, "Run").click()
    wait(lambda: panel.table.rowCount() == 2)
    picture("sweep")
    cells = [panel.table.item(0, column).text() for column in range(5)]
    assert cells[0] == "coarse"
    assert cells[3:] == ["100 %", "100 %"]
    coarse, medium = (int(panel.table.item(row, 1).text()) for row in range(2))
    assert medium > 2 * coarse


def test_report_and_export(block, partition, tmp_path, monkeypatch):
    opened = []
    monkeypatch.setattr(QtGui.QDesktopServices, "openUrl", opened.append)
    block.Document.saveAs(str(tmp_path / "part.FCStd"))
    FreeCADGui.runCommand("GPS_Report", 0)
    assert opened[0].toLocalFile() == str(tmp_path / "Block-report.html")
    assert "gpswb-result/1" in (tmp_path / "Block-report.html").read_text(encoding="utf-8")
    chosen = (str(tmp_path / "out"), "Faces (*.csv)")
    monkeypatch.setattr(QtWidgets.QFileDialog, "getSaveFileName", lambda *_: chosen)
    FreeCADGui.runCommand("GPS_Export", 0)
    assert (tmp_path / "out.csv").read_text(encoding="utf-8").startswith("face,class")


def test_a_pick_on_the_mesh_means_the_face(block, partition):
    FreeCADGui.Selection.clearSelection()
    partition.ViewObject.Elements = "Facets"
    FreeCADGui.runCommand("GPS_Query", 0)
    steady()
    view = FreeCADGui.activeDocument().activeView()
    width, height = view.getSize()
    seen = view.getObjectInfo((width // 2, height // 2))
    assert seen["Object"] == partition.Name
    assert block.Shape.getElement(seen["Component"]).isInside(
        FreeCAD.Vector(seen["x"], seen["y"], seen["z"]), 0.1, True
    )
    click_in_view(width // 2, height - 1 - height // 2)
    settle()
    assert seen["Component"] in shown_panel().text.text()
    picture("query_mesh")


def test_coloured_step_of_a_part_that_has_colours(block, partition, tmp_path):
    """Every face comes back in the colour of its class, whatever colours the part's file has."""
    given, written = tmp_path / "given.step", tmp_path / "part.coloured.step"
    partition.ViewObject.Visibility = False  # the user's own colours are back
    ImportGui.export([block], str(given))
    assert given.read_text("latin-1").count("COLOUR_RGB") >= 2
    (part,) = import_part(given, block.Document)
    own = make_partition(part, "auto", "robust")
    export(own, written)
    (again,) = import_part(written, block.Document)
    expected = [WHEEL[name] for name in true_classes(again)]
    assert rgb(face_colours(again.ViewObject)) == expected
    assert "Face7 " in written.read_text("latin-1")


def test_an_error_is_shown_as_it_is(document):
    told = []

    def look():
        box = QtWidgets.QApplication.activeModalWidget()
        told.extend([box.text(), box.textFormat() == QtCore.Qt.PlainText])
        picture("error")
        box.close()

    QtCore.QTimer.singleShot(300, look)
    show_error(Sentence("{path}: no such file", path="<b>&.step"))
    assert told == ["<b>&.step: no such file", True]
