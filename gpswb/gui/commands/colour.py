# SPDX-License-Identifier: LGPL-2.1-or-later
"""`GPS_Colour`: what the colours show, and whether faces or facets have them."""

from __future__ import annotations

from typing import Any

from gpswb.gui.colouring import COLOUR_BY, ColourBy
from gpswb.gui.commands.command import BaseCommand, ResultCommand
from gpswb.gui.compat import QT_TRANSLATE_NOOP
from gpswb.gui.icons import icon

_TEXTS: dict[ColourBy, tuple[str, str]] = {
    "invariance class": (
        QT_TRANSLATE_NOOP("GPS_Colour_0", "By invariance class"),
        QT_TRANSLATE_NOOP("GPS_Colour_0", "The seven classes in the colours of the wheel"),
    ),
    "shape type": (
        QT_TRANSLATE_NOOP("GPS_Colour_1", "By shape type"),
        QT_TRANSLATE_NOOP("GPS_Colour_1", "Cup, rut, saddle, ridge, cap, plane, from curvature"),
    ),
    "initial region": (
        QT_TRANSLATE_NOOP("GPS_Colour_2", "By initial region"),
        QT_TRANSLATE_NOOP("GPS_Colour_2", "What the first step found"),
    ),
    "refined region": (
        QT_TRANSLATE_NOOP("GPS_Colour_3", "By refined region"),
        QT_TRANSLATE_NOOP("GPS_Colour_3", "What the second step made of it"),
    ),
    "agreement with CAD": (
        QT_TRANSLATE_NOOP("GPS_Colour_4", "By agreement with CAD"),
        QT_TRANSLATE_NOOP("GPS_Colour_4", "Where the recognised class is that of the CAD surface"),
    ),
    "constraint state": (
        QT_TRANSLATE_NOOP("GPS_Colour_5", "By constraint state"),
        QT_TRANSLATE_NOOP("GPS_Colour_5", "What the datum system fixes of each feature"),
    ),
}


class _By(ResultCommand):
    """Colour by one thing."""

    beside_panels = True

    def __init__(self, by: ColourBy) -> None:
        self.by = by
        self.name = f"GPS_Colour_{COLOUR_BY.index(by)}"  # type: ignore[misc]
        self.text, self.tooltip = _TEXTS[by]  # type: ignore[misc]
        self.faces = by in ("agreement with CAD", "constraint state")

    @property
    def icon(self) -> str:
        return icon("GPS_Colour")

    def run(self) -> None:
        from gpswb.gui.selection import with_result

        view = with_result().ViewObject
        view.ColourBy = self.by
        view.Visibility = True


class _Facets(_By):
    """Show the mesh with a colour a facet, or the faces again."""

    def __init__(self) -> None:
        self.name = "GPS_Colour_Facets"  # type: ignore[misc]
        self.text = QT_TRANSLATE_NOOP("GPS_Colour_Facets", "On the mesh")  # type: ignore[misc]
        self.tooltip = QT_TRANSLATE_NOOP(  # type: ignore[misc]
            "GPS_Colour_Facets", "Show the mesh with a colour a facet, or the part's faces again"
        )
        self.faces = True

    @property
    def icon(self) -> str:
        return icon("GPS_Facets")

    def run(self) -> None:
        from gpswb.gui.objects.partition_view import FACES, FACETS
        from gpswb.gui.selection import with_result

        view = with_result().ViewObject
        view.Elements = FACES if view.Elements == FACETS else FACETS
        view.Visibility = True


class Command(BaseCommand):
    """A drop-down of the ways to colour."""

    beside_panels = True

    name = "GPS_Colour"
    text = QT_TRANSLATE_NOOP("GPS_Colour", "Colour")
    tooltip = QT_TRANSLATE_NOOP("GPS_Colour", "What the colours show")

    def __init__(self) -> None:
        self.parts = (*(_By(by) for by in COLOUR_BY), _Facets())

    def GetCommands(self) -> tuple[str, ...]:
        """What the drop-down holds."""
        return tuple(part.name for part in self.parts)

    def GetResources(self) -> dict[str, Any]:
        return {**super().GetResources(), "DropDownMenu": True, "Exclusive": False}

    def why_not(self) -> str:
        return self.parts[0].why_not()

    def Activated(self, index: int = 0) -> None:
        self.parts[index].Activated()
