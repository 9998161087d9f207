# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is seen: colours, legend, picks; and that the user's own colours come back."""

import FreeCAD
import FreeCADGui
from conftest import own_colours
from test_partition_panel import rgb, true_classes
from window import click_in_view, hue_is, picture, pixel_of_face, pixels, settle, wait

from gpswb.gui.colouring import COLOUR_BY
from gpswb.gui.compat import face_colours
from gpswb.gui.objects.partition import partitions
from gpswb.gui.panels.legend import show_legend
from gpswb.gui.panels.show import shown_panel
from gpswb.io.colours import SAFE, WHEEL


def is_coloured(part):
    return rgb(face_colours(part.ViewObject)) == [WHEEL[name] for name in true_classes(part)]


def has_own_colours(part):
    return rgb(face_colours(part.ViewObject)) == rgb(own_colours(part))


def test_own_colours_come_back_on_hide_and_delete(block, partition):
    assert is_coloured(block)
    partition.ViewObject.Visibility = False
    assert has_own_colours(block)
    partition.ViewObject.Visibility = True
    assert is_coloured(block)
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(partition)
    FreeCADGui.runCommand("Std_Delete", 0)
    settle()
    assert has_own_colours(block)
    assert [obj.Name for obj in block.Document.Objects] == ["Block"]


def test_save_and_reopen(block, partition, tmp_path):
    path = tmp_path / "saved.FCStd"
    show_legend()
    partition.ViewObject.ColourBy = "agreement with CAD"
    block.Document.saveAs(str(path))
    FreeCADGui.runCommand("Std_Save", 0)
    settle()
    assert not FreeCADGui.activeDocument().Modified
    classes, shown = list(partition.Classes), rgb(face_colours(block.ViewObject))
    FreeCAD.closeDocument(block.Document.Name)
    document = FreeCAD.openDocument(str(path))
    settle()
    (again,) = partitions(document)
    assert list(again.Classes) == classes
    assert again.Status == "up to date"
    assert len(again.Group) == len(classes)
    assert again.ViewObject.ColourBy == "agreement with CAD"
    assert rgb(face_colours(again.Source.ViewObject)) == shown
    again.ViewObject.Visibility = False
    assert has_own_colours(again.Source)


def test_features_are_hidden_one_by_one_or_all_with_the_partition(block, partition):
    first, second, *_ = partition.Group
    first.ViewObject.Visibility = False
    settle(0.1)
    assert not first.ViewObject.Visibility
    assert second.ViewObject.Visibility
    partition.ViewObject.ColourBy = "refined region"
    assert not first.ViewObject.Visibility
    partition.ViewObject.Visibility = False
    assert not second.ViewObject.Visibility


def test_every_way_to_colour(block, partition):
    count = len(block.Shape.Faces)
    for by in COLOUR_BY:
        partition.ViewObject.ColourBy = by
        settle(0.1)
        colours = rgb(face_colours(block.ViewObject))
        assert len(colours) == count
        found = partition.ViewObject.Proxy.found
        assert [tuple(round(255 * v) for v in c) for c in found.face_colours] == colours
        if found.names:
            assert sum(found.counts) == count
    partition.ViewObject.ColourBy = "refined region"
    assert len(set(rgb(face_colours(block.ViewObject)))) == count


def test_mesh_with_a_colour_a_facet(block, partition):
    FreeCADGui.Selection.clearSelection()
    partition.ViewObject.Elements = "Facets"
    settle()
    assert not block.ViewObject.Visibility
    assert has_own_colours(block)
    # Lit facets are darker or paler than their colour, but keep its hue.
    seen = pixels("facets")
    picture("facets_window")
    for name in ("planar", "spherical"):
        r, g, b = WHEEL[name]
        alike = [p for p in seen if hue_is(p, (r, g, b))]
        assert len(alike) > 50, name
    partition.ViewObject.FacetEdges = True
    settle()
    edged = pixels("facet_edges")
    assert sum(max(p) < 60 for p in edged) > sum(max(p) < 60 for p in seen) + 50
    # Edges are dark only: they bring no colour that wasn't there.
    for other in ("cylindrical", "revolute", "prismatic", "helical"):
        count = sum(hue_is(p, WHEEL[other]) for p in seen)
        assert sum(hue_is(p, WHEEL[other]) for p in edged) <= count + 10, other
    partition.ViewObject.Elements = "Faces"
    settle()
    assert block.ViewObject.Visibility
    assert is_coloured(block)


def test_query_by_a_real_pick(block, partition):
    name = f"Face{true_classes(block).index('spherical') + 1}"
    FreeCADGui.Selection.clearSelection()
    query_panel()
    click_in_view(*pixel_of_face(name))
    settle()
    text = shown_panel().text.text()
    assert name in text
    assert "spherical" in text
    assert "8.00 mm" in text
    picture("query")


def test_a_class_by_hand_is_one_step_to_undo(block, partition):
    classes = true_classes(block)
    name = f"Face{classes.index('spherical') + 1}"
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(block, name)
    panel = query_panel()
    choose_class(panel, "complex")
    process = panel.change.run._job._process
    assert process.poll() is None
    assert panel.cancel.isVisible()
    assert not panel.classes.isEnabled()
    picture("class_by_hand")
    panel.cancel.click()
    assert process.poll() is not None
    assert list(partition.Classes) == classes
    assert not block.Document.UndoNames

    choose_class(panel, "complex")
    wait(lambda: panel.change is None)
    changed = [c if c != "spherical" else "complex" for c in classes]
    assert list(partition.Classes) == changed
    assert "complex" in panel.text.text()
    assert len(block.Document.UndoNames) == 1
    panel.clear.click()
    wait(lambda: panel.change is None)
    assert list(partition.Classes) == classes
    block.Document.undo()
    settle()
    assert list(partition.Classes) == changed
    assert rgb(face_colours(block.ViewObject)) == [WHEEL[each] for each in changed]
    block.Document.undo()
    settle()
    assert list(partition.Classes) == classes
    assert is_coloured(block)


def query_panel():
    FreeCADGui.runCommand("GPS_Query", 0)
    settle()
    return shown_panel()


def choose_class(panel, name):
    panel.classes.setCurrentIndex(panel.classes.findData(name))
    panel.classes.activated.emit(panel.classes.currentIndex())


def test_the_legend_counts_and_selects(block, partition):
    legend = show_legend()
    settle()
    assert legend.rows.item(0).text() == "planar: 6"
    legend.select(1)
    (chosen,) = FreeCADGui.Selection.getSelectionEx()
    assert chosen.Object is block
    classes = true_classes(block)
    assert [classes[int(name[4:]) - 1] for name in chosen.SubElementNames] == ["cylindrical"]


def test_palette_for_colour_blind_eyes(block, partition):
    group = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/GPS")
    group.SetInt("Palette", 1)
    try:
        settle()
        expected = [SAFE[name] for name in true_classes(block)]
        assert rgb(face_colours(block.ViewObject)) == expected
    finally:
        group.RemInt("Palette")
    settle()
    assert is_coloured(block)
