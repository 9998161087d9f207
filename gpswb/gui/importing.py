# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bring a part into a document: CAD, with its colours where there is a window, or a scan."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD

from gpswb.cad.freecad_measured import is_measurement
from gpswb.cad.sniff import sniff
from gpswb.errors import InputError
from gpswb.gui import compat
from gpswb.gui.original_file import remember_file
from gpswb.sentence import Sentence

SUFFIXES = (".step", ".stp", ".p21", ".brep", ".brp")
MESHES, CLOUDS = (".stl", ".ply", ".obj", ".off"), (".asc", ".xyz", ".pcd")
"""What FreeCAD's modules Mesh and Points read, of what was measured."""


def import_part(path: Path, document: Any) -> list[Any]:
    """Import a STEP or BREP file, a mesh or points; the objects that can be partitioned.

    Raises:
        InputError: the file can't be read, or holds nothing to partition.
    """
    suffix = path.suffix.lower()
    form, sha256 = ("", "") if suffix in (*MESHES, *CLOUDS) else sniff(path)
    before = {obj.Name for obj in document.Objects}
    try:
        if suffix in MESHES:
            import Mesh

            Mesh.insert(str(path), document.Name)
        elif suffix in CLOUDS:
            import Points

            Points.insert(str(path), document.Name)
        elif form == "brep":
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
        reason = [*str(error).strip().splitlines(), "–"][0]
        raise InputError(
            Sentence("{path}: FreeCAD can't read the file ({reason})", path=path, reason=reason)
        ) from None
    new = [obj for obj in document.Objects if obj.Name not in before]
    document.recompute(new)
    found = [obj for obj in new if _usable(obj)]
    if len(found) == 1:  # the name in a STEP file is often that of the program that wrote it
        found[0].Label = path.stem
    if not found:
        if form:
            raise InputError(Sentence("{path}: the file holds no faces", path=path))
        raise InputError(Sentence("{path}: the file holds nothing to partition", path=path))
    if form == "step":
        for obj in found:
            remember_file(obj, path, sha256)
    return found


def _usable(obj: Any) -> bool:
    if is_measurement(obj):
        return bool(obj.Mesh.CountFacets if hasattr(obj, "Mesh") else obj.Points.CountPoints)
    return bool(obj.isDerivedFrom("Part::Feature") and obj.Shape.Faces)
