# SPDX-License-Identifier: LGPL-2.1-or-later
"""How an annotation is seen: its frame beside the part, with a leader to its face."""

from __future__ import annotations

from typing import Any

import numpy as np
from pivy import coin

from gpswb.errors import GpswbError
from gpswb.gui import compat
from gpswb.gui.annotation_record import DatumRecord, SpecificationRecord
from gpswb.gui.frame_nodes import frame_nodes
from gpswb.gui.frame_picture import frame_picture
from gpswb.gui.icons import icon
from gpswb.gui.objects.annotation import record_of
from gpswb.gui.objects.stateless import Stateless

_MODE = "Frame"
_SHOWN = ("Cells", "Anchor", "Normal", "Mark", "Place")


class AnnotationView(Stateless):
    """Behaviour of the view."""

    def __init__(self, view: Any) -> None:
        view.Proxy = self

    def attach(self, view: Any) -> None:
        """Make the display mode."""
        self.obj = view.Object
        self.root = coin.SoSeparator()
        view.addDisplayMode(self.root, _MODE)

    def getDisplayModes(self, view: Any) -> list[str]:
        return [_MODE]

    def getDefaultDisplayMode(self) -> str:
        return _MODE

    def setDisplayMode(self, mode: str) -> str:
        return mode

    def updateData(self, obj: Any, name: str) -> None:
        """Follow the object: ``Place`` is the last property that is set."""
        if name in _SHOWN and all(hasattr(obj, each) for each in _SHOWN):
            self.draw(obj)

    def draw(self, obj: Any) -> None:
        """Draw the frame anew."""
        self.root.removeAllChildren()
        if not obj.Cells:
            return
        try:
            datum = isinstance(record_of(obj), DatumRecord)
        except GpswbError:
            return
        scale = compat.main_window().devicePixelRatioF()
        anchor, normal, place = (
            np.array(tuple(vector)) for vector in (obj.Anchor, obj.Normal, obj.Place)
        )
        picture = frame_picture(list(obj.Cells), scale)
        self.root.addChild(frame_nodes(picture, anchor, normal, place, obj.Mark if datum else 0.0))

    def doubleClicked(self, view: Any) -> bool:
        """Edit it."""
        from gpswb.gui.panels.annotate import AnnotatePanel
        from gpswb.gui.panels.datums import DatumsPanel
        from gpswb.gui.panels.show import show_panel

        partition = partition_of(self.obj)
        if partition is None:
            return False
        if isinstance(record_of(self.obj), SpecificationRecord):
            show_panel(AnnotatePanel(partition, self.obj))
        else:
            show_panel(DatumsPanel(partition))
        return True

    def onDelete(self, view: Any, subelements: Any) -> bool:
        """What refers to it has to say so; within the step that deletes it."""
        from gpswb.gui.annotation_state import refresh_annotations

        partition = partition_of(self.obj)
        if partition is not None:
            refresh_annotations(partition, without=self.obj)
        return True

    def getIcon(self) -> str:
        """The sign of its kind."""
        try:
            specified = isinstance(record_of(self.obj), SpecificationRecord)
        except GpswbError:
            specified = True
        return icon("GPS_Annotate" if specified else "GPS_Datums")


def partition_of(obj: Any) -> Any:
    """The partition that holds an annotation; None if it was taken out of it."""
    from gpswb.gui.objects.partition import is_partition

    return next((parent for parent in obj.InList if is_partition(parent)), None)
