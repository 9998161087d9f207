# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tell a partition that its mesh or points have changed: FreeCAD tells only of shapes."""

from __future__ import annotations

from typing import Any

import FreeCAD

from gpswb.cad.freecad_measured import is_measurement


def follow_measurements() -> None:
    """Start to, once."""
    if not _observers:
        _observers.append(_Observer())
        FreeCAD.addDocumentObserver(_observers[0])


class _Observer:
    def slotChangedObject(self, obj: Any, name: str) -> None:
        """A property of an object has changed: FreeCAD takes a mesh for a result, not an input."""
        if name not in ("Mesh", "Points") or obj.Document.Restoring or not is_measurement(obj):
            return
        from gpswb.gui.objects.partition import is_partition

        for user in obj.InList:
            if is_partition(user):
                user.touch()


_observers: list[_Observer] = []
