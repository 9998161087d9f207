# SPDX-License-Identifier: LGPL-2.1-or-later
"""`GPS_Frames`: lay the frames out for the view as it is."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui
import numpy as np
from pivy import coin

from gpswb.core.mesh import FloatArray
from gpswb.gui import compat
from gpswb.gui.commands.command import ResultCommand
from gpswb.gui.compat import QT_TRANSLATE_NOOP, translate
from gpswb.gui.frame_axes import axes_of
from gpswb.gui.frame_picture import HEIGHT
from gpswb.gui.frame_places import FrameView

_WITH_GAP = 1.5
"""Row of frames, of a frame's height."""


class Command(ResultCommand):
    """Put the frames of a partition beside its part as the 3-D view shows it."""

    name = "GPS_Frames"
    text = QT_TRANSLATE_NOOP("GPS_Frames", "Place frames")
    tooltip = QT_TRANSLATE_NOOP(
        "GPS_Frames", "Lay the frames out beside the part as this view shows it, none over another"
    )
    shortcut = "G, F"
    faces = True

    def why_not(self) -> str:
        from gpswb.gui.objects.annotation import annotations_of
        from gpswb.gui.selection import with_result

        reason = super().why_not()
        if not reason and not (annotations_of(with_result()) and _camera() is not None):
            return str(translate("GPS", "there are no frames in this view"))
        return reason

    def run(self) -> None:
        from gpswb.gui.annotation_state import place_frames
        from gpswb.gui.one_step import one_step
        from gpswb.gui.selection import with_result

        partition = with_result()
        with one_step(partition.Document, translate("GPS_Frames", "Place frames")):
            place_frames(partition, _present_view(np.array(partition.Source.Shape.BoundBox.Center)))


def _present_view(middle: FloatArray) -> FrameView:
    """The active 3-D view, as it shows what is at the depth of a point (3,)."""
    view = FreeCADGui.activeDocument().activeView()
    axes = axes_of(FreeCAD.Placement(FreeCAD.Vector(), view.getCameraOrientation()))
    width, height = view.getSize()
    volume = _camera().getViewVolume(width / height)

    def seen(place: FloatArray) -> FloatArray:
        """Right and up in the window, of its width and height."""
        share = volume.projectToScreen(coin.SbVec3f(*place.tolist())).getValue()
        # A window that is higher than wide shows more than the camera's own volume.
        found: FloatArray = (np.array(share[:2]) - 0.5) * min(1.0, width / height)
        return found

    at = seen(middle)
    size = 1.0 / np.array([seen(middle + axes[0])[0] - at[0], seen(middle + axes[1])[1] - at[1]])
    row = _WITH_GAP * HEIGHT * compat.main_window().devicePixelRatioF() / height * size[1]
    return FrameView(axes, row, size[0], size[1], -(at * size) @ axes[:2])


def _camera() -> Any:
    """The camera of the active 3-D view; None where another window is active."""
    document = FreeCADGui.activeDocument()
    camera = getattr(document and document.activeView(), "getCameraNode", None)
    return camera() if camera is not None else None
