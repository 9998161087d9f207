# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading STEP, BREP and FCStd files with FreeCAD's Part module."""

from __future__ import annotations

import re
import tempfile
from pathlib import Path
from typing import Any

import FreeCAD
import Part

from gpswb.cad.fcstd import stored_shapes
from gpswb.cad.freecad_part import FreecadShape
from gpswb.cad.silence import quiet
from gpswb.cad.sniff import Format
from gpswb.cad.units import step_units
from gpswb.errors import InputError


def read(path: Path, form: Format) -> FreecadShape:
    """Read a file; coordinates become mm.

    Raises:
        InputError: FreeCAD can't read the file, or it holds no face with a surface.
    """
    unit = "mm"
    notes: tuple[str, ...] = ()
    if form == "step":
        names = step_units(path.read_bytes()) or ["mm"]
        unit = names[0]
        if len(names) > 1:
            notes = (f"the file uses several length units: {', '.join(names)}",)
        shape = _part_read(path, path)
    elif form == "brep":
        shape = _read_brep(path.read_bytes(), path)
    else:
        shape = _read_fcstd(path)
    if shape.isNull():
        raise InputError(f"{path}: the file holds no shape")
    if not shape.Faces:
        raise InputError(f"{path}: the shape has no faces")
    bare = _without_surface(shape)
    if len(bare) == len(shape.Faces):
        raise InputError(
            f"{path}: none of its {len(bare)} faces has a surface, only a triangulation, which "
            "FreeCAD doesn't hand out: use --kernel ocp"
        )
    return FreecadShape(shape, unit, notes, bare)


def _part_read(file: Path, named: Path) -> Any:
    try:
        with quiet():
            return Part.read(str(file))
    except (Part.OCCError, FreeCAD.Base.FreeCADError, OSError, RuntimeError, ValueError) as error:
        reason = str(error).strip().splitlines()[:1] or ["unknown reason"]
        raise InputError(f"{named}: FreeCAD can't read the file ({reason[0]})") from None


def _read_brep(text: bytes, named: Path) -> Any:
    # FreeCAD goes by the suffix, and knows only this one.
    with tempfile.TemporaryDirectory(prefix="gpswb-") as folder:
        file = Path(folder) / "shape.brep"
        file.write_bytes(text)
        return _part_read(file, named)


def _read_fcstd(path: Path) -> Any:
    parts = []
    for stored in stored_shapes(path):
        shape = _read_brep(stored.brep, path)
        matrix = FreeCAD.Matrix(*stored.placement.ravel().tolist())
        shape.Placement = FreeCAD.Placement(matrix).multiply(shape.Placement)
        parts.append(shape)
    return parts[0] if len(parts) == 1 else Part.makeCompound(parts)


def _without_surface(shape: Any) -> set[int]:
    """Faces without a surface; asking such a face for it would crash FreeCAD."""
    pattern = re.compile(r"^Fa\s+[01]\s+\S+\s+0\s+\d+", re.MULTILINE)
    if not pattern.search(shape.exportBrepToString()):
        return set()
    return {i for i, face in enumerate(shape.Faces) if pattern.search(face.exportBrepToString())}
