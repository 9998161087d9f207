# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading STEP, BREP and FCStd files with OCP."""

from __future__ import annotations

import tempfile
from pathlib import Path

from OCP.BRep import BRep_Builder
from OCP.BRepTools import BRepTools
from OCP.gp import gp_Trsf
from OCP.IFSelect import IFSelect_RetDone
from OCP.STEPControl import STEPControl_Reader
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS_Compound, TopoDS_Shape

from gpswb.cad.fcstd import stored_shapes
from gpswb.cad.ocp import OcpShape
from gpswb.cad.silence import quiet
from gpswb.cad.sniff import Format
from gpswb.cad.units import step_units
from gpswb.errors import InputError

__all__ = ["quiet", "read"]


def read(path: Path, form: Format) -> OcpShape:
    """Read a file; coordinates become mm.

    Raises:
        InputError: the kernel can't read the file, or it holds no face.
    """
    with quiet():
        if form == "step":
            shape, unit, notes = _read_step(path)
        elif form == "brep":
            shape, unit, notes = _read_brep(path, path), "mm", ()
        else:
            shape, unit, notes = _read_fcstd(path), "mm", ()
        if shape is None or shape.IsNull():
            raise InputError(f"{path}: the file holds no shape")
        result = OcpShape(shape, unit, notes)
    if not result.faces:
        raise InputError(f"{path}: the shape has no faces")
    return result


def _read_step(path: Path) -> tuple[TopoDS_Shape | None, str, tuple[str, ...]]:
    reader = STEPControl_Reader()
    if reader.ReadFile(str(path)) != IFSelect_RetDone:
        raise InputError(f"{path}: not a STEP file that the kernel can read")
    names = step_units(path.read_bytes()) or ["mm"]
    notes: tuple[str, ...] = ()
    if len(names) > 1:
        notes = (f"the file uses several length units: {', '.join(names)}",)
    reader.TransferRoots()
    return (reader.OneShape() if reader.NbShapes() else None), names[0], notes


def _read_brep(file: Path, named: Path) -> TopoDS_Shape:
    shape = TopoDS_Shape()
    if not BRepTools.Read_s(shape, str(file), BRep_Builder()):
        raise InputError(f"{named}: not a BREP file that the kernel can read")
    return shape


def _read_fcstd(path: Path) -> TopoDS_Shape:
    builder, compound = BRep_Builder(), TopoDS_Compound()
    builder.MakeCompound(compound)
    shapes = []
    with tempfile.TemporaryDirectory(prefix="gpswb-") as folder:
        for i, stored in enumerate(stored_shapes(path)):
            file = Path(folder) / f"{i}.brep"
            file.write_bytes(stored.brep)
            move = gp_Trsf()
            move.SetValues(*stored.placement[:3].ravel().tolist())
            shapes.append(_read_brep(file, path).Moved(TopLoc_Location(move)))
    for shape in shapes:
        builder.Add(compound, shape)
    return shapes[0] if len(shapes) == 1 else compound
