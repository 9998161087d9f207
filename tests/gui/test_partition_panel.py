# SPDX-License-Identifier: LGPL-2.1-or-later
"""Partition through the task panel, as a user does."""

import json

import FreeCAD
import FreeCADGui
import pytest
from window import objects, picture, settle, wait

from gpswb.gui.compat import face_colours
from gpswb.gui.objects.partition import partitions
from gpswb.gui.panels.show import shown_panel
from gpswb.io.colours import WHEEL

CLASS_OF = {"Plane": "planar", "Cylinder": "cylindrical", "Sphere": "spherical"}


def true_classes(part):
    return [CLASS_OF[type(face.Surface).__name__] for face in part.Shape.Faces]


def rgb(colours):
    return [tuple(round(255 * value) for value in colour[:3]) for colour in colours]


def open_panel():
    FreeCADGui.runCommand("GPS_Partition", 0)
    settle()
    return shown_panel()


def run_through_panel(part):
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(part)
    panel = open_panel()
    panel.button.click()
    wait(lambda: shown_panel() is None)
    (partition,) = partitions(part.Document)
    settle()
    return partition


def test_partition_and_undo_in_one_step(block):
    before, colours = objects(), face_colours(block.ViewObject)
    partition = run_through_panel(block)

    classes = true_classes(block)
    assert list(partition.Classes) == classes
    assert rgb(face_colours(block.ViewObject)) == [WHEEL[name] for name in classes]
    assert json.loads(partition.Result)["schema"] == "gpswb-result/1"
    faces = [name for feature in partition.Group for _, subs in feature.Faces for name in subs]
    assert sorted(faces) == sorted(f"Face{i + 1}" for i in range(len(classes)))
    hole = next(feature for feature in partition.Group if feature.Class == "cylindrical")
    assert float(hole.Radius) == pytest.approx(6.0)
    assert hole.Shape.Edges
    picture("partitioned")

    assert len(block.Document.UndoNames) == 1
    block.Document.undo()
    settle()
    assert objects() == before
    assert face_colours(block.ViewObject) == colours
    block.Document.redo()
    settle()
    assert list(partitions(block.Document)[0].Classes) == classes
    assert rgb(face_colours(block.ViewObject)) == [WHEEL[name] for name in classes]


def test_count_of_triangles_is_that_of_the_run(block):
    FreeCADGui.Selection.addSelection(block)
    panel = open_panel()
    wait(lambda: "(" in panel.count.text())
    told = int("".join(c for c in panel.count.text().split("(")[0] if c.isdigit()))
    picture("panel")
    panel.button.click()
    wait(lambda: shown_panel() is None)
    (partition,) = partitions(block.Document)
    assert partition.Triangles == told


def test_cancel_leaves_nothing(block, tmp_path, monkeypatch):
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    before, colours = objects(), face_colours(block.ViewObject)
    FreeCADGui.Selection.addSelection(block)
    panel = open_panel()
    panel.density.set_density("triangles=400000")
    panel.button.click()
    wait(lambda: panel.bar.isVisible() and panel.change.run.progress is not None)
    process = panel.change.run._job._process
    picture("running")
    panel.reject()
    settle()
    assert process.poll() is not None
    assert shown_panel() is None
    assert objects() == before
    assert face_colours(block.ViewObject) == colours
    assert not block.Document.UndoNames
    assert list(tmp_path.iterdir()) == []


def test_a_crash_of_the_kernel_is_one_line_in_the_panel(block):
    FreeCADGui.Selection.addSelection(block)
    panel = open_panel()
    panel.button.click()
    panel.change.run._job._process.send_signal(11)
    wait(lambda: "crashed" in panel.message.text())
    assert panel.inputs.isEnabled()
    assert partitions(block.Document) == []


def test_pick_the_part_while_the_panel_is_open(block):
    import Part

    other = block.Document.addObject("Part::Feature", "Other")
    other.Shape = Part.makeSphere(5.0)
    FreeCADGui.Selection.clearSelection()
    panel = open_panel()
    assert panel.source is None
    assert not panel.button.isEnabled()
    FreeCADGui.Selection.addSelection(other)
    settle()
    assert panel.source is other
    assert panel.button.isEnabled()


@pytest.mark.parametrize("what", ["part", "document"])
def test_what_it_works_on_goes_while_it_runs(block, what):
    FreeCADGui.Selection.addSelection(block)
    panel = open_panel()
    panel.button.click()
    run = panel.change.run
    settle(0.5)
    assert run.running
    document = block.Document
    if what == "part":
        document.openTransaction("Delete")
        document.removeObject(block.Name)
        document.commitTransaction()
    else:
        FreeCAD.closeDocument(document.Name)
    settle()
    assert shown_panel() is None
    assert FreeCADGui.Control.activeDialog() is False
    assert not run.running
    if what == "part":
        assert objects(document) == []
        document.undo()
        settle()
        assert objects(document) == ["Block"]


def test_a_partition_goes_while_it_is_asked_about(block, partition):
    FreeCADGui.runCommand("GPS_Query", 0)
    settle()
    assert shown_panel() is not None
    block.Document.openTransaction("Delete")
    block.Document.removeObject(partition.Name)
    block.Document.commitTransaction()
    settle()
    assert shown_panel() is None
    FreeCADGui.Selection.addSelection(block.Document.Name, block.Name, "Face1")
    settle()
