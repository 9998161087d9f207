# SPDX-License-Identifier: LGPL-2.1-or-later
"""Frames of annotations: moved by the mouse, and laid out for any view."""

import FreeCAD
import FreeCADGui
import numpy as np
from pivy import coin
from test_annotation import annotate_all
from window import drag_in_view, picture, settle, steady, view_area

from gpswb.gui.objects.annotation import annotations_of
from gpswb.gui.objects.partition import partitions, run


def framed(partition):
    return [obj for obj in annotations_of(partition) if obj.Cells]


def rectangle(obj):
    """Left, top, right and bottom of a frame in the 3-D view, pixels from its top left."""
    view, area = FreeCADGui.activeDocument().activeView(), view_area()
    width, height = view.getSize()
    seen = view.getCameraNode().getViewVolume(width / height)
    x, y = seen.projectToScreen(coin.SbVec3f(*obj.Place)).getValue()[:2]
    proxy, scale = obj.ViewObject.Proxy, area.devicePixelRatioF()
    _, size, on_the_left = proxy._rectangle()
    left = x * width - (size[0] if on_the_left else 0)
    top = (1 - y) * height - size[1] / 2
    return np.array([left, top, left + size[0], top + size[1]]) / scale


def overlaps(partition):
    """Pairs of frames of which one covers the other."""
    boxes = [rectangle(obj) for obj in framed(partition)]
    return [
        (i, j)
        for i, a in enumerate(boxes)
        for j, b in enumerate(boxes[:i])
        if (np.minimum(a[2:], b[2:]) > np.maximum(a[:2], b[:2])).all()
    ]


def test_a_frame_is_dragged_and_stays_there(block, partition, tmp_path):
    annotate_all(block, partition)
    FreeCADGui.SendMsgToActiveView("ViewFit")
    steady()
    moved = framed(partition)[3]
    others = [tuple(obj.Place) for obj in framed(partition) if obj is not moved]
    left, top, right, bottom = before = rectangle(moved)
    undo = len(block.Document.UndoNames)
    drag_in_view(((left + right) / 2, (top + bottom) / 2), (-40.0, -25.0))
    settle()
    assert np.allclose(rectangle(moved) - before, [-40.0, -25.0] * 2, atol=1.5)
    assert moved.Kept
    assert len(block.Document.UndoNames) == undo + 1
    assert [tuple(obj.Place) for obj in framed(partition) if obj is not moved] == others
    assert FreeCADGui.Selection.getSelectionEx() == []  # what lies behind it wasn't meant
    picture("frame_dragged")
    place = FreeCAD.Vector(moved.Place)
    run(partition)
    block.Document.recompute()
    assert moved.Place.isEqual(place, 1e-6)
    # The part takes it along.
    block.Placement.Base = FreeCAD.Vector(0.0, 0.0, 15.0)
    block.Document.recompute()
    run(partition)
    assert moved.Place.isEqual(place + FreeCAD.Vector(0.0, 0.0, 15.0), 1e-6)
    path = tmp_path / "moved.FCStd"
    name, place = moved.Name, FreeCAD.Vector(moved.Place)
    block.Document.saveAs(str(path))
    FreeCAD.closeDocument(block.Document.Name)
    (again,) = partitions(FreeCAD.openDocument(str(path)))
    settle()
    (found,) = (obj for obj in framed(again) if obj.Name == name)
    assert found.Kept
    assert found.Place.isEqual(place, 1e-6)


def test_a_click_beside_a_frame_or_on_it_moves_nothing(block, partition):
    annotate_all(block, partition)
    FreeCADGui.SendMsgToActiveView("ViewFit")
    steady()
    places = [tuple(obj.Place) for obj in framed(partition)]
    left, top, right, bottom = rectangle(framed(partition)[0])
    drag_in_view((left - 6.0, top - 4.0), (30.0, 10.0))
    drag_in_view(((left + right) / 2, (top + bottom) / 2), (1.0, 1.0))
    settle()
    assert [tuple(obj.Place) for obj in framed(partition)] == places
    assert not any(obj.Kept for obj in framed(partition))


def test_frames_are_laid_out_for_the_view_as_it_is(block, partition):
    annotate_all(block, partition)
    view = FreeCADGui.activeDocument().activeView()
    for name, turn in (
        ("front", view.viewFront),
        ("bottom", view.viewBottom),
        ("rear", view.viewRear),
    ):
        turn()
        FreeCADGui.SendMsgToActiveView("ViewFit")
        steady()
        FreeCADGui.runCommand("GPS_Frames", 0)
        settle()
        picture(f"frames_{name}")
        assert overlaps(partition) == []
        area = view_area()
        for obj in framed(partition):
            assert (rectangle(obj)[:2] >= 0).all()
            assert (rectangle(obj)[2:] <= (area.width(), area.height())).all()
    view.getCameraNode().height = 0.4 * view.getCameraNode().height.getValue()
    settle()
    FreeCADGui.runCommand("GPS_Frames", 0)
    settle()
    assert overlaps(partition) == []
    kept = [tuple(obj.Place) for obj in framed(partition)]
    run(partition)
    assert np.allclose([tuple(obj.Place) for obj in framed(partition)], kept)
    block.Document.undo()
    settle()
    assert not np.allclose([tuple(obj.Place) for obj in framed(partition)], kept)
