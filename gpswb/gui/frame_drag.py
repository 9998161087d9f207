# SPDX-License-Identifier: LGPL-2.1-or-later
"""Move a frame in the 3-D view with the left mouse button.

A node of the scene graph, so that it works in every view. Navigation styles that turn the view with
the left button take the mouse before it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from pivy import coin

from gpswb.core.mesh import FloatArray

_LEAST = 3
"""Pixels: less is a click, not a move."""


class FrameDrag:
    """Behaviour of the mouse on one frame.

    Args:
        rectangle: gives the frame's place (3,), its size in pixels, and whether its right edge (not
            its left one) is there; None where there is no frame.
        shown: is called with a new place and the view's axes (3, 3) while the frame is moved.
        moved: the same, once, when it is let go.
    """

    def __init__(
        self,
        rectangle: Callable[[], tuple[FloatArray, tuple[int, int], bool] | None],
        shown: Callable[[FloatArray, FloatArray], None],
        moved: Callable[[FloatArray, FloatArray], None],
    ) -> None:
        self._rectangle, self._shown, self._moved = rectangle, shown, moved
        self._held: _Held | None = None
        self.node = coin.SoEventCallback()
        for kind, act in (
            (coin.SoMouseButtonEvent, self._button),
            (coin.SoLocation2Event, self._location),
        ):
            self.node.addEventCallback(kind.getClassTypeId(), act)

    def _button(self, _: Any, node: Any) -> None:
        event = node.getEvent()
        if event.getButton() != coin.SoMouseButtonEvent.BUTTON1:
            return
        if event.getState() == coin.SoButtonEvent.UP:
            self._let_go(node)
        elif not (event.wasShiftDown() or event.wasCtrlDown() or event.wasAltDown()):
            self._take(node)

    def _take(self, node: Any) -> None:
        found = self._rectangle()
        if found is None:
            return
        place, (width, height), on_the_left = found
        action = node.getAction()
        held = _Held(action, place, _position(node))
        x, y = held.start - held.pixel_of(place)
        if on_the_left:
            x += width
        if 0 <= x <= width and abs(y) <= height / 2:
            self._held = held
            node.grabEvents()
            node.setHandled()

    def _location(self, _: Any, node: Any) -> None:
        if self._held is not None:
            node.setHandled()
            place = self._held.place_at(_position(node))
            if place is not None:
                self._shown(place, self._held.axes)

    def _let_go(self, node: Any) -> None:
        held, self._held = self._held, None
        if held is None:
            return
        node.releaseEvents()
        place = held.place_at(_position(node))
        if place is not None:
            node.setHandled()
            self._moved(place, held.axes)


class _Held:
    """A frame that was taken at a pixel ``start``: the view as it was then."""

    def __init__(self, action: Any, place: FloatArray, start: FloatArray) -> None:
        volume = coin.SoViewVolumeElement.get(action.getState())
        self.matrix = np.array(volume.getMatrix().getValue())
        self.size = np.array(action.getViewportRegion().getViewportSizePixels().getValue())
        self.place, self.start = place, start
        self._far = False
        towards = -np.array(volume.getProjectionDirection().getValue())
        up = np.array(volume.getViewUp().getValue())
        self.axes = np.array([np.cross(up, towards), up, towards])

    def pixel_of(self, place: FloatArray) -> FloatArray:
        """(2,) where a place is seen, from the lower left."""
        *across, _, w = np.append(place, 1.0) @ self.matrix
        pixel: FloatArray = (np.array(across) / w + 1.0) / 2.0 * self.size
        return pixel

    def place_at(self, pixel: FloatArray) -> FloatArray | None:
        """The place (3,) of the frame with the mouse at a pixel; None as long as it is a click."""
        step = pixel - self.start
        self._far = self._far or float(np.abs(step).max()) > _LEAST
        if not self._far:
            return None
        across = np.array([self.pixel_of(self.place + axis) for axis in self.axes[:2]])
        per_mm = across - self.pixel_of(self.place)
        found: FloatArray = self.place + np.linalg.solve(per_mm.T, step) @ self.axes[:2]
        return found


def _position(node: Any) -> FloatArray:
    return np.array(node.getEvent().getPosition().getValue(), dtype=np.float64)
