# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bring a CAD file into a document, with its colours where there is a window."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD

from gpswb.cad.sniff import sniff
from gpswb.errors import InputError
from gpswb.gui import compat
from gpswb.gui.original_file import remember_file

SUFFIXES = (".step", ".stp", ".p21", ".brep", ".brp")


def import_part(path: Path, document: Any) -> list[Any]:
    """Import a STEP or BREP file; the objects that can be partitioned.

    Raises:
        InputError: the file can't be read, or holds no faces.
    """
    form, sha256 = sniff(path)
    before = {obj.Name for obj in document.Objects}
    try:
        if form == "brep":
            import Part

            obj = document.addObject("Part::Feature", "Part")
            obj.Shape = Part.read(str(path))
            obj.Label = path.stem
        elif compat.has_window():
            import ImportGui

            ImportGui.insert(str(path), document.Name)
        else:
            import Import

            Import.insert(str(path), document.Name)
    except (FreeCAD.Base.FreeCADError, OSError, RuntimeError, ValueError) as error:
        reason = str(error).strip().splitlines()[:1] or ["unknown reason"]
        raise InputError(f"{path}: FreeCAD can't read the file ({reason[0]})") from None
    new = [obj for obj in document.Objects if obj.Name not in before]
    document.recompute(new)
    found = [obj for obj in new if obj.isDerivedFrom("Part::Feature") and obj.Shape.Faces]
    if len(found) == 1:  # the name in a STEP file is often that of the program that wrote it
        found[0].Label = path.stem
    if not found:
        raise InputError(f"{path}: the file holds no faces")
    if form == "step":
        for obj in found:
            remember_file(obj, path, sha256)
    return found
