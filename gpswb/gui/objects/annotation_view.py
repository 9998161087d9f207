# SPDX-License-Identifier: LGPL-2.1-or-later
"""How an annotation is seen: its frame beside the part, with a leader to its face."""

from __future__ import annotations

from typing import Any

import numpy as np
from pivy import coin

from gpswb.core.mesh import FloatArray
from gpswb.errors import GpswbError
from gpswb.gui import compat
from gpswb.gui.annotation_record import DatumRecord, SpecificationRecord
from gpswb.gui.compat import translate
from gpswb.gui.frame_axes import axes_of
from gpswb.gui.frame_drag import FrameDrag
from gpswb.gui.frame_nodes import frame_nodes, is_on_the_left
from gpswb.gui.frame_picture import frame_picture
from gpswb.gui.icons import icon
from gpswb.gui.objects.annotation import move_frame, record_of
from gpswb.gui.objects.stateless import Stateless
from gpswb.gui.one_step import one_step

_MODE = "Frame"
_SHOWN = ("Cells", "Anchor", "Normal", "Mark", "View", "Place")


class AnnotationView(Stateless):
    """Behaviour of the view."""

    def __init__(self, view: Any) -> None:
        view.Proxy = self

    def attach(self, view: Any) -> None:
        """Make the display mode."""
        self.obj = view.Object
        self.picture: Any = None
        self.drag = FrameDrag(self._rectangle, self._draw_at, self._move)
        self.drawing = coin.SoSeparator()
        self.root = coin.SoSeparator()
        self.root.addChild(self.drag.node)
        self.root.addChild(self.drawing)
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
        self.picture = None
        if obj.Cells:
            scale = compat.main_window().devicePixelRatioF()
            self.picture = frame_picture(list(obj.Cells), scale)
        self._draw_at(np.array(tuple(obj.Place)), axes_of(obj.View))

    def _draw_at(self, place: FloatArray, axes: FloatArray) -> None:
        self.drawing.removeAllChildren()
        if self.picture is None:
            return
        try:
            datum = isinstance(record_of(self.obj), DatumRecord)
        except GpswbError:
            return
        anchor, normal = (np.array(tuple(v)) for v in (self.obj.Anchor, self.obj.Normal))
        mark = self.obj.Mark if datum else 0.0
        self.drawing.addChild(frame_nodes(self.picture, anchor, normal, place, mark, axes))

    def _rectangle(self) -> tuple[FloatArray, tuple[int, int], bool] | None:
        if self.picture is None:
            return None
        place, anchor = (np.array(tuple(v)) for v in (self.obj.Place, self.obj.Anchor))
        size = self.picture.width(), self.picture.height()
        return place, size, is_on_the_left(place, anchor, axes_of(self.obj.View))

    def _move(self, place: FloatArray, axes: FloatArray) -> None:
        with one_step(self.obj.Document, translate("GPS", "Move frame")):
            move_frame(self.obj, place, axes)

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
