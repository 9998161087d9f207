# SPDX-License-Identifier: LGPL-2.1-or-later
"""`GPS_Frames`: lay the frames out for the view as it is."""

from __future__ import annotations

from typing import Any

import FreeCADGui
import numpy as np
from pivy import coin

from gpswb.gui import compat
from gpswb.gui.commands.command import BaseCommand
from gpswb.gui.compat import QT_TRANSLATE_NOOP, translate

_WITH_GAP = 1.5
"""Row of frames, of a frame's height."""


class Command(BaseCommand):
    """Put the frames of a partition beside its part as the 3-D view shows it."""

    name = "GPS_Frames"
    text = QT_TRANSLATE_NOOP("GPS_Frames", "Place frames")
    tooltip = QT_TRANSLATE_NOOP(
        "GPS_Frames", "Lay the frames out beside the part as this view shows it, none over another"
    )
    shortcut = "G, F"

    def IsActive(self) -> bool:
        from gpswb.gui.objects.annotation import annotations_of
        from gpswb.gui.selection import with_result

        partition = with_result()
        return partition is not None and bool(annotations_of(partition)) and _camera() is not None

    def run(self) -> None:
        from gpswb.gui.annotation_state import place_frames
        from gpswb.gui.frame_picture import HEIGHT
        from gpswb.gui.one_step import one_step
        from gpswb.gui.selection import with_result

        partition = with_result()
        view = FreeCADGui.activeDocument().activeView()
        middle = partition.Source.Shape.BoundBox.Center
        width, height = view.getSize()
        volume = _camera().getViewVolume(width / height)
        up = np.array(volume.getViewUp().getValue())
        ends = (np.array(middle) + end * up for end in (0.0, 1.0))
        low, high = (volume.projectToScreen(coin.SbVec3f(*end.tolist())).getValue() for end in ends)
        # A window that is higher than wide shows more than the camera's own height.
        shown = max(1.0, height / width) / (high[1] - low[1])
        row = _WITH_GAP * HEIGHT * compat.main_window().devicePixelRatioF() / height * shown
        with one_step(partition.Document, translate("GPS_Frames", "Place frames")):
            place_frames(partition, view.getCameraOrientation(), row, shown)


def _camera() -> Any:
    """The camera of the active 3-D view; None where another window is active."""
    document = FreeCADGui.activeDocument()
    camera = getattr(document and document.activeView(), "getCameraNode", None)
    return camera() if camera is not None else None
