# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a feature is seen: as thin geometry, with the symbol of its class in the tree."""

from __future__ import annotations

from typing import Any

from gpswb.gui.icons import class_icon
from gpswb.gui.objects.stateless import Stateless


class FeatureView(Stateless):
    """Behaviour of the view."""

    def __init__(self, view: Any) -> None:
        view.Proxy = self
        view.LineWidth = 2.0
        view.LineColor = (0.0, 0.0, 0.0)  # as on a drawing; the icon has the class's colour
        view.PointSize = 1.0
        view.DrawStyle = "Dashdot"
        view.Selectable = False  # it must not be in the way of picks on the part's faces

    def attach(self, view: Any) -> None:
        """Remember the object, which the icon needs."""
        self.obj = view.Object

    def getIcon(self) -> str:
        """A dot in the class's colour."""
        return class_icon(self.obj.Class)
