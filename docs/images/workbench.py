# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pictures of the window in these pages, of the example bracket:

    sh tests/gui/run.sh build/window docs/images/workbench.py

They are left in build/window/pictures.
"""

import sys
from pathlib import Path

import FreeCAD
import FreeCADGui

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "gui"))

from window_job import start  # noqa: E402


def show():
    """Go through the workbench as a user does, and take a picture at each stop."""
    from conftest import arrange
    from window import click_in_view, picture, pixel_of_face, settle, wait

    from gpswb.gui.commands.import_part import bring_in
    from gpswb.gui.objects.partition import partitions
    from gpswb.gui.panels.show import shown_panel

    arrange()
    bring_in(ROOT / "build" / "examples" / "bracket.step")
    view = FreeCADGui.activeDocument().activeView()
    view.viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    FreeCADGui.runCommand("GPS_Partition", 0)
    panel = shown_panel()
    wait(lambda: "(" in panel.count.text(), 300)
    FreeCADGui.Selection.clearSelection()
    panel.accept()
    wait(lambda: panel.bar.value() > 40 or shown_panel() is None, 300)
    picture("panel")
    wait(lambda: shown_panel() is None, 600)
    FreeCADGui.SendMsgToActiveView("ViewFit")
    settle(1.0)
    picture("coloured")
    (partition,) = partitions(FreeCAD.ActiveDocument)
    for feature in partition.Group:
        feature.ViewObject.Visibility = False
    FreeCADGui.runCommand("GPS_Query", 0)
    settle()
    cone = next(f for f in partition.Group if f.Surface == "cone")
    click_in_view(*pixel_of_face(cone.Faces[0][1][0]))
    settle(3.0)  # the panel grows with its text, by and by
    picture("query")
    shown_panel().reject()
    annotate(partition)
    FreeCADGui.runCommand("GPS_Legend", 0)  # makes room
    FreeCADGui.SendMsgToActiveView("ViewFit")
    settle(1.0)
    FreeCADGui.runCommand("GPS_Frames", 0)
    FreeCADGui.Selection.clearSelection()
    settle(1.0)
    picture("annotations")
    for annotation in partition.Group:
        annotation.ViewObject.Visibility = False
    partition.ViewObject.FacetEdges = True
    partition.ViewObject.Elements = "Facets"
    partition.ViewObject.ColourBy = "shape type"
    settle()
    picture("mesh")


def annotate(partition):
    """Datums of the base, its side and the bore; what the bracket's drawing might say."""
    from gpswb.gui.datums import set_datums
    from gpswb.gui.part_features import features_of
    from gpswb.gui.partition_result import effective_result
    from gpswb.gui.specifications import add_specification

    table = features_of(effective_result(partition)[0])
    faces = {feature.name: list(feature.faces) for feature in table.features}
    set_datums(partition, [("A", ["Face31"]), ("B", ["Face22"]), ("C", faces["Hole 1"])])
    for name, *words in (
        ("Plane 1", "flatness", 0.05),
        ("Plane 3", "perpendicularity", 0.1, "A"),
        ("Hole 1", "position", 0.1, "A|B"),
        ("Shaft 1", "circular run-out", 0.04, "C"),
        ("Torus 1", "surface profile", "?", "A|B|C"),
        ("Cone 1", "circular run-out", 0.08, "C"),
    ):
        add_specification(partition, faces[name], *words)
    holes, slot = faces["Hole pattern 1"], faces["Slot 2"]
    add_specification(partition, holes, "position", 0.2, "A|B|C", modifiers="M")
    add_specification(partition, slot, "size", "", upper=0.1, lower=-0.05)
    add_specification(partition, faces["Hole 1"], "size", "", fit="H7")


start(show)
