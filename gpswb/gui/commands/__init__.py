# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands, one file each.

A command is listed in `MODULES` and, where it has a button, in `GROUPS`; its file holds a subclass
of `command.Command` called ``Command``.
"""

from __future__ import annotations

import importlib

import FreeCADGui

MODULES: dict[str, str] = {
    "GPS_Import": "import_part",
    "GPS_Partition": "partition",
    "GPS_Validate": "validate",
    "GPS_Sweep": "sweep",
    "GPS_Colour": "colour",
    "GPS_Legend": "legend",
    "GPS_Query": "query",
    "GPS_Datums": "datums",
    "GPS_Annotate": "annotate",
    "GPS_Frames": "frames",
    "GPS_Report": "report",
    "GPS_Export": "export",
}
"""File of each command."""

GROUPS: tuple[tuple[str, tuple[str, ...]], ...] = (
    ("GPS partition", ("GPS_Import", "GPS_Partition", "GPS_Validate", "GPS_Sweep")),
    ("GPS view", ("GPS_Colour", "GPS_Legend", "GPS_Query")),
    ("GPS annotation", ("GPS_Datums", "GPS_Annotate", "GPS_Frames")),
    ("GPS results", ("GPS_Report", "GPS_Export")),
)
"""Toolbars with their buttons; the menu holds the same, with separators between."""


def register() -> None:
    """Make every command known to FreeCAD."""
    for name, module in MODULES.items():
        command = importlib.import_module(f"{__name__}.{module}").Command()
        for sub in command.parts:
            FreeCADGui.addCommand(sub.name, sub)
        FreeCADGui.addCommand(name, command)
