# SPDX-License-Identifier: LGPL-2.1-or-later
"""Datums and specifications through their panels; frames in the 3-D view."""

import FreeCAD
import FreeCADGui
import numpy as np
from window import PICTURES, click_in_view, picture, pixel_of_face, settle

from gpswb.gps.characteristics import RULES
from gpswb.gui.compat import QtGui
from gpswb.gui.datums import set_datums
from gpswb.gui.frame_picture import frame_picture, symbol_picture
from gpswb.gui.objects.annotation import annotations_of
from gpswb.gui.objects.partition import partitions
from gpswb.gui.panels.show import shown_panel
from gpswb.gui.specifications import add_specification
from gpswb.gui.symbols import SYMBOLS

# The block's faces in TopExp order would be an assumption: they are found by what they are.


def faces(part):
    found = {}
    for i, face in enumerate(part.Shape.Faces):
        box = face.BoundBox
        flat = [axis for axis in "XYZ" if getattr(box, f"{axis}Length") < 1e-6]
        kind = type(face.Surface).__name__
        key = f"{flat[0].lower()}{getattr(box, f'{flat[0]}Min'):.0f}" if flat else kind
        found[key] = f"Face{i + 1}"
    return found


def open_panel(command):
    FreeCADGui.runCommand(command, 0)
    settle()
    return shown_panel()


def labels(partition):
    return [obj.Label for obj in annotations_of(partition)]


def select(part, *names):
    FreeCADGui.Selection.clearSelection()
    for name in names:
        FreeCADGui.Selection.addSelection(part.Document.Name, part.Name, name)
    settle(0.1)


def test_datum_system_through_the_panel(block, partition):
    at = faces(block)
    FreeCADGui.Selection.clearSelection()
    panel = open_panel("GPS_Datums")
    assert "Without a datum" in panel.text.text()
    select(block, at["z0"])
    assert "locks one translation and two rotations" in panel.texts["A"].text()
    panel.buttons["B"].click()
    click_in_view(*pixel_of_face(at["x44"]))
    settle()
    assert panel.faces["B"] == [at["x44"]]
    assert "translation along Y stays free" in panel.text.text()
    panel.buttons["C"].click()
    select(block, at["Cylinder"])
    assert "complete" in panel.text.text()
    assert "stays free" not in panel.text.text()
    picture("datums")
    panel.accept()
    settle()
    assert labels(partition) == ["Datum A", "Datum B", "Datum C", "Datum system A|B|C"]
    block.Document.undo()
    settle()
    assert labels(partition) == []
    block.Document.redo()
    settle()
    assert len(labels(partition)) == 4
    panel = open_panel("GPS_Datums")
    panel.suggested.click()
    assert [letter for letter, chosen in panel.faces.items() if chosen] == ["A", "B", "C"]
    panel.notation.setText("A|D")
    assert "datum D" in panel.text.text()
    panel.reject()
    assert partition.DatumSystem == "A|B|C"


def test_only_what_is_permitted_is_offered(block, partition):
    at = faces(block)
    set_datums(partition, [("A", [at["z0"]]), ("B", [at["x0"]]), ("C", [at["y0"]])])
    select(block, at["Cylinder"])
    panel = open_panel("GPS_Annotate")
    buttons = panel.grid.buttons
    state = {name: button.property("status") for name, button in buttons.items()}
    assert state["position"] == "recommended"
    assert state["cylindricity"] == "allowed"
    assert state["flatness"] == "not allowed"
    assert "it isn't flat" in buttons["flatness"].toolTip()
    assert panel.grid.chosen == "position"
    buttons["flatness"].click()
    assert "not allowed" in panel.reason.text()
    assert not panel.button.isEnabled()
    buttons["position"].click()
    assert panel.datums.text() == "A|B|C"
    assert panel.value.text() == "?"
    panel.value.setText("wide")
    assert "not a number" in panel.message.text()
    panel.value.setText("0.2")
    panel.modifiers["M"].setChecked(True)
    picture("annotate")
    before = len(block.Document.UndoNames)
    panel.button.click()
    settle()
    assert len(block.Document.UndoNames) == before + 1
    spec = annotations_of(partition)[-1]
    assert list(spec.Cells) == ["⌖", "Ø0.2 Ⓜ", "A", "B", "C"]
    buttons["size"].click()
    panel.fit.setText("H7")
    panel.button.click()
    assert list(annotations_of(partition)[-1].Cells) == ["Ø12 H7"]
    panel.reject()
    # A double click edits it.
    spec.ViewObject.Proxy.doubleClicked(spec.ViewObject)
    settle()
    panel = shown_panel()
    assert (panel.value.text(), panel.modifiers["M"].isChecked()) == ("0.2", True)
    panel.value.setText("0.05")
    panel.button.click()
    settle()
    assert list(spec.Cells) == ["⌖", "Ø0.05 Ⓜ", "A", "B", "C"]


def annotate_all(block, partition):
    at = faces(block)
    set_datums(partition, [("A", [at["z0"]]), ("B", [at["x44"]]), ("C", [at["y0"]])])
    for name, *words in (
        ("z20", "parallelism", 0.05, "A"),
        ("z0", "flatness", 0.02),
        ("Cylinder", "position", 0.2, "A|B|C"),
        ("y0", "perpendicularity", 0.1, "A|B"),
        ("Sphere", "surface profile", "?", "A|B|C"),
    ):
        add_specification(partition, [at[name]], *words)
    add_specification(partition, [at["Cylinder"]], "size", "", upper="0.02", lower="-0.1")
    settle()


def test_frames_in_the_view(block, partition):
    view = FreeCADGui.activeDocument().activeView()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    settle()
    height = view.getCameraNode().height.getValue()
    empty = ink_in_view("frames_none")
    annotate_all(block, partition)
    FreeCADGui.Selection.clearSelection()
    picture("frames")
    full = ink_in_view("frames_view")
    assert full > empty + 1000
    # They take no part in fitting the view, and keep their size when it is zoomed.
    FreeCADGui.SendMsgToActiveView("ViewFit")
    settle()
    assert view.getCameraNode().height.getValue() == height
    for obj in annotations_of(partition):
        obj.ViewObject.Visibility = False
    settle()
    assert abs(ink_in_view("frames_hidden") - empty) < 100


def test_delete_save_and_reopen(block, partition, tmp_path):
    annotate_all(block, partition)
    flat = next(o for o in annotations_of(partition) if o.Label.startswith("Datum B"))
    select_object(flat)
    FreeCADGui.runCommand("Std_Delete", 0)
    settle()
    system = next(o for o in annotations_of(partition) if o.Label.startswith("Datum system"))
    assert system.Status == "can't be placed"
    assert "B=" not in partition.Datums
    block.Document.undo()
    settle()
    assert system.Status == "complete"
    assert "B=" in partition.Datums
    path = tmp_path / "annotated.FCStd"
    block.Document.saveAs(str(path))
    FreeCADGui.SendMsgToActiveView("ViewFit")
    settle()
    shown = ink_in_view("frames_saved")
    cells = [list(o.Cells) for o in annotations_of(partition)]
    FreeCAD.closeDocument(block.Document.Name)
    document = FreeCAD.openDocument(str(path))
    settle()
    (again,) = partitions(document)
    assert [list(o.Cells) for o in annotations_of(again)] == cells
    FreeCADGui.activeDocument().activeView().viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    settle()
    assert abs(ink_in_view("frames_reopened") - shown) < 0.1 * shown


def select_object(obj):
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(obj)
    settle(0.1)


def test_every_characteristic_has_a_symbol_of_its_own():
    assert {rule.symbol for rule in RULES.values()} == set(SYMBOLS)
    seen = [bytes(symbol_picture(each, 40).toImage().constBits()) for each in SYMBOLS]
    assert len(set(seen)) == len(SYMBOLS)
    rows = [frame_picture([each, "Ø0.15 Ⓜ", "A-B", "C"], 2.0) for each in SYMBOLS]
    sheet = QtGui.QImage(
        max(row.width() for row in rows), sum(r.height() + 6 for r in rows), rows[0].format()
    )
    sheet.fill(QtGui.QColor("#88aacc"))
    painter = QtGui.QPainter(sheet)
    top = 0
    for row in rows:
        painter.drawImage(0, top, row)
        top += row.height() + 6
    painter.end()
    assert sheet.save(str(PICTURES / "symbols.png"))


def ink_in_view(name):
    """Number of black pixels in a picture of the 3-D view."""
    path = PICTURES / f"{name}.png"
    FreeCADGui.activeDocument().activeView().saveImage(str(path), 900, 640, "White")
    image = QtGui.QImage(str(path)).convertToFormat(QtGui.QImage.Format_RGBA8888)
    rgb = np.frombuffer(bytes(image.constBits()), dtype=np.uint8).reshape(-1, 4)[:, :3]
    return int((rgb.max(axis=1) < 60).sum())
