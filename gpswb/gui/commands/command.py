# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every command shares."""

from __future__ import annotations

from typing import Any, ClassVar

import FreeCADGui

from gpswb.cad.freecad_measured import is_measurement
from gpswb.errors import GpswbError
from gpswb.gui import compat
from gpswb.gui.compat import translate
from gpswb.gui.icons import icon


class BaseCommand:
    """A command of FreeCAD's window.

    Attributes:
        name: FreeCAD's name of it, also the context of its translated texts.
        text, tooltip: English; FreeCAD translates them.
        shortcut: keys, or none.
        beside_panels: whether it can also run while a task panel is open.
        parts: the commands that a drop-down command is made of.
    """

    name: ClassVar[str]
    text: ClassVar[str]
    tooltip: ClassVar[str]
    shortcut: ClassVar[str] = ""
    beside_panels: ClassVar[bool] = False
    parts: tuple[BaseCommand, ...] = ()
    _told = ""

    @property
    def icon(self) -> str:
        """Path of the icon."""
        return icon(self.name)

    def GetResources(self) -> dict[str, Any]:
        """What the button and the menu entry say."""
        found = {"Pixmap": self.icon, "MenuText": self.text, "ToolTip": self.tooltip}
        if self.shortcut:
            found["Accel"] = self.shortcut
        if self.beside_panels:
            found["CmdType"] = "AlterDoc,Alter3DView,AlterSelection,ForEdit"
        return found

    def IsActive(self) -> bool:
        """Whether it can run now; the tooltip says why it can't."""
        reason = self.why_not()
        if reason != self._told:
            self._told = reason
            self._explain(reason)
        return not reason

    def why_not(self) -> str:
        """Why it can't run now; empty where it can."""
        raise NotImplementedError

    def _explain(self, reason: str) -> None:
        found = FreeCADGui.Command.get(self.name)
        for action in found.getAction() if found is not None else ():
            plain = translate(self.name, self.tooltip)
            action.setToolTip(f"{plain}\n({reason})" if reason else plain)
            action.setStatusTip(action.toolTip().replace("\n", " "))

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


class ResultCommand(BaseCommand):
    """A command on the result of the chosen partition.

    Attributes:
        faces: whether it takes a part with faces: what was measured has none.
    """

    faces: bool = False

    def why_not(self) -> str:
        from gpswb.gui.selection import with_result

        partition = with_result()
        if partition is None:
            return str(translate("GPS", "partition a part first, or select one of the partitions"))
        if self.faces and is_measurement(partition.Source):
            return str(translate("GPS", "a mesh has no CAD faces"))
        return ""
