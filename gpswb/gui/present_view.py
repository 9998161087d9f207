# SPDX-License-Identifier: LGPL-2.1-or-later
"""The active 3-D view as frames are laid out for it."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui
import numpy as np
from pivy import coin

from gpswb.core.mesh import FloatArray
from gpswb.gui import compat
from gpswb.gui.annotation_state import place_frames
from gpswb.gui.frame_axes import axes_of
from gpswb.gui.frame_picture import HEIGHT
from gpswb.gui.frame_places import FrameView
from gpswb.gui.objects.annotation import annotations_of

_WITH_GAP = 1.5
"""Row of frames, of a frame's height."""


def lay_out(partition: Any) -> None:
    """Lay the frames of a partition out for the active 3-D view, which there must be."""
    place_frames(partition, _present_view(np.array(partition.Source.Shape.BoundBox.Center)))


def lay_out_first(partition: Any) -> None:
    """The same where its frames were never laid out: in a view that shows a part of the part, or
    it from elsewhere, they might be out of sight."""
    new = not partition.FrameRow > 0 and annotations_of(partition)
    if new and camera() is not None:
        lay_out(partition)


def _present_view(middle: FloatArray) -> FrameView:
    """The active 3-D view, as it shows what is at the depth of a point (3,)."""
    view = FreeCADGui.activeDocument().activeView()
    axes = axes_of(FreeCAD.Placement(FreeCAD.Vector(), view.getCameraOrientation()))
    width, height = view.getSize()
    volume = camera().getViewVolume(width / height)

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


def camera() -> Any:
    """The camera of the active 3-D view; None where another window is active."""
    document = FreeCADGui.activeDocument()
    camera = getattr(document and document.activeView(), "getCameraNode", None)
    return camera() if camera is not None else None
