# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every command shares."""

from __future__ import annotations

from typing import Any, ClassVar

from gpswb.errors import GpswbError
from gpswb.gui import compat
from gpswb.gui.icons import icon


class BaseCommand:
    """A command of FreeCAD's window.

    Attributes:
        name: FreeCAD's name of it, also the context of its translated texts.
        text, tooltip: English; FreeCAD translates them.
        shortcut: keys, or none.
        parts: the commands that a drop-down command is made of.
    """

    name: ClassVar[str]
    text: ClassVar[str]
    tooltip: ClassVar[str]
    shortcut: ClassVar[str] = ""
    parts: tuple[BaseCommand, ...] = ()

    @property
    def icon(self) -> str:
        """Path of the icon."""
        return icon(self.name)

    def GetResources(self) -> dict[str, Any]:
        """What the button and the menu entry say."""
        found = {"Pixmap": self.icon, "MenuText": self.text, "ToolTip": self.tooltip}
        return {**found, "Accel": self.shortcut} if self.shortcut else found

    def IsActive(self) -> bool:
        """Whether it can run now."""
        raise NotImplementedError

    def Activated(self, index: int = 0) -> None:
        """Run it; an error that the user can cause is shown as one line."""
        try:
            self.run()
        except GpswbError as error:
            compat.show_error(str(error))

    def run(self) -> None:
        """Do it.

        Raises:
            GpswbError: it can't be done.
        """
        raise NotImplementedError
