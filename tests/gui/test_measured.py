# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh in the window: partitioned through the panel, picked, changed, saved."""

import FreeCAD
import FreeCADGui
import Mesh
import pytest
from conftest import block_shape
from test_commands import active
from window import click_in_view, hue_is, picture, pixel_of_face, pixels, settle, wait

from gpswb.gui.objects.feature import features
from gpswb.gui.objects.partition import partitions
from gpswb.gui.panels.legend import show_legend
from gpswb.gui.panels.show import shown_panel
from gpswb.gui.partition_result import effective_result
from gpswb.io.colours import WHEEL

GREEN = (28, 173, 28)
"""What FreeCAD gives to what is selected."""


@pytest.fixture
def scan(document):
    points, facets = block_shape().tessellate(0.05)
    obj = document.addObject("Mesh::Feature", "Scan")
    obj.Mesh = Mesh.Mesh([[points[i] for i in facet] for facet in facets])
    FreeCADGui.activeDocument().activeView().viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    settle()
    return obj


@pytest.fixture
def partition(scan):
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(scan)
    FreeCADGui.runCommand("GPS_Partition", 0)
    settle()
    panel = shown_panel()
    assert "triangles" in panel.part.text()
    assert not panel.density.isEnabled()
    panel.button.click()
    wait(lambda: shown_panel() is None)
    settle()
    (made,) = partitions(scan.Document)
    return made


def names(partition, wanted):
    stored, _ = effective_result(partition)
    return [face.name for face in stored.faces if face.invariance_class == wanted]


def alike(colour, seen):
    """Number of pixels of a hue."""
    return sum(hue_is(rgb, colour) for rgb in seen)


def test_a_mesh_through_the_panel(scan, partition):
    assert sorted(set(partition.Classes)) == ["cylindrical", "planar", "spherical"]
    assert len(features(partition)) == len(partition.Classes) == 8
    assert not scan.ViewObject.Visibility
    seen = pixels("mesh_classes")
    for name in ("planar", "spherical"):
        assert alike(WHEEL[name], seen) > 50, name
    legend = show_legend()
    settle()
    assert legend.wheel.found.counts[:3] == (6, 1, 1)
    picture("mesh")
    # Needs faces of CAD: not to be had, and the tooltip says why.
    missing = {"GPS_Validate", "GPS_Sweep", "GPS_Datums", "GPS_Annotate"}
    assert not active() & missing
    assert active() >= {"GPS_Colour", "GPS_Legend", "GPS_Query", "GPS_Report", "GPS_Export"}
    (action,) = FreeCADGui.Command.get("GPS_Validate").getAction()
    assert "a mesh has no CAD faces" in action.toolTip()
    scan.Document.undo()
    settle()
    assert partitions(scan.Document) == []
    assert scan.ViewObject.Visibility


def test_a_pick_on_the_mesh(scan, partition):
    (dome,) = names(partition, "spherical")
    FreeCADGui.runCommand("GPS_Query", 0)
    settle()
    before = alike(GREEN, pixels("mesh_before"))
    click_in_view(*pixel_of_face(dome))
    wait(lambda: dome in shown_panel().text.text())
    text = shown_panel().text.text()
    assert "spherical" in text
    assert "8.00 mm" in text
    assert "CAD surface" not in text
    picture("mesh_query")
    # What is picked is seen in FreeCAD's own colour.
    assert alike(GREEN, pixels("mesh_picked")) > before + 50
    classes = shown_panel().classes
    classes.setCurrentIndex(classes.findData("complex"))
    classes.activated.emit(classes.currentIndex())
    wait(lambda: shown_panel().change is None)
    assert names(partition, "complex") == [dome]
    shown_panel().reject()


def test_the_legend_selects_and_a_saved_mesh_is_as_it_was(scan, partition, tmp_path):
    legend = show_legend()
    legend.select(0)
    settle()
    (entry,) = FreeCADGui.Selection.getSelectionEx()
    assert sorted(entry.SubElementNames) == sorted(names(partition, "planar"))
    FreeCADGui.Selection.clearSelection()
    path = tmp_path / "mesh.FCStd"
    scan.Document.saveAs(str(path))
    settle()
    assert not scan.ViewObject.Visibility
    FreeCAD.closeDocument(scan.Document.Name)
    document = FreeCAD.openDocument(str(path))
    settle()
    (again,) = partitions(document)
    assert len(again.Classes) == 8
    assert not document.Scan.ViewObject.Visibility
    FreeCADGui.activeDocument().activeView().viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    settle()
    assert alike(WHEEL["spherical"], pixels("mesh_reopened")) > 50
    again.ViewObject.Visibility = False
    settle()
    assert document.Scan.ViewObject.Visibility
