# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a feature is seen: thin geometry in its class's colour."""

from __future__ import annotations

from typing import Any

from gpswb.gui import preferences
from gpswb.gui.icons import class_icon


class FeatureView:
    """Behaviour of the view."""

    def __init__(self, view: Any) -> None:
        view.Proxy = self
        view.LineWidth = 1.0
        view.PointSize = 1.0
        view.DrawStyle = "Dashdot"
        view.Selectable = False  # it must not be in the way of picks on the part's faces

    def attach(self, view: Any) -> None:
        """Remember the object, which the icon needs."""
        self.obj = view.Object

    def recolour(self, view: Any) -> None:
        """Take the colour of the feature's class."""
        rgb = preferences.palette().get(view.Object.Class)
        if rgb is not None:
            # Darker than the faces, on which it would not be seen otherwise.
            colour = tuple(0.6 * value / 255 for value in rgb)
            view.LineColor = view.PointColor = colour

    def getIcon(self) -> str:
        """A dot in the class's colour."""
        return class_icon(self.obj.Class)

    def dumps(self) -> None:
        return None

    def loads(self, state: Any) -> None:
        return None

    __getstate__ = dumps
    __setstate__ = loads
