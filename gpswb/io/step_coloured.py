# SPDX-License-Identifier: LGPL-2.1-or-later
"""STEP with faces named and coloured by class (OCP only)."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from OCP.IFSelect import IFSelect_RetDone
from OCP.Interface import Interface_Static
from OCP.Quantity import Quantity_Color, Quantity_TypeOfColor
from OCP.STEPCAFControl import STEPCAFControl_Reader, STEPCAFControl_Writer
from OCP.STEPControl import STEPControl_AsIs
from OCP.TCollection import TCollection_ExtendedString
from OCP.TDataStd import TDataStd_Name
from OCP.TDF import TDF_Label, TDF_LabelSequence
from OCP.TDocStd import TDocStd_Document
from OCP.TopAbs import TopAbs_FACE
from OCP.TopExp import TopExp
from OCP.TopLoc import TopLoc_Location
from OCP.TopTools import TopTools_IndexedMapOfShape
from OCP.XCAFApp import XCAFApp_Application
from OCP.XCAFDoc import XCAFDoc_ColorSurf, XCAFDoc_DocumentTool

from gpswb.cad.silence import quiet
from gpswb.core.invariance import InvarianceClass
from gpswb.errors import InputError, OutputError
from gpswb.io.colours import NONE, WHEEL


def write_coloured_step(
    path: Path, source: Path, classes: Mapping[str, InvarianceClass], names: Mapping[str, str]
) -> None:
    """Write a STEP file's shape again, its faces coloured by class and named.

    Args:
        source: the STEP file.
        classes: class of each face, by the face's name (``Face1`` ...); the others become grey.
        names: text after the face's name: ``Face1 planar Plane 2``.

    Raises:
        InputError: the kernel can't read the file.
        OutputError: the kernel can't write it.
    """
    with quiet():
        document = TDocStd_Document(TCollection_ExtendedString("coloured"))
        application = XCAFApp_Application.GetApplication_s()
        application.NewDocument(TCollection_ExtendedString("MDTV-XCAF"), document)
        reader = STEPCAFControl_Reader()
        reader.SetColorMode(False)
        if reader.ReadFile(str(source)) != IFSelect_RetDone or not reader.Transfer(document):
            raise InputError(f"{source}: not a STEP file that the kernel can read")
        faces = TopTools_IndexedMapOfShape()
        TopExp.MapShapes_s(reader.ChangeReader().OneShape(), TopAbs_FACE, faces)
        shapes = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
        colours = XCAFDoc_DocumentTool.ColorTool_s(document.Main())
        shades = {name: _colour(rgb) for name, rgb in WHEEL.items()}
        done: set[Any] = set()
        for i in range(1, faces.Extent() + 1):
            name, face = f"Face{i}", faces.FindKey(i)
            # The occurrences of a part share its faces: the first one names them.
            label = None if face.TShape() in done else _label(shapes, face)
            if label is None:
                continue
            done.add(face.TShape())
            found = classes.get(name)
            shade = shades[found] if found is not None else _colour(NONE)
            colours.SetColor(label, shade, XCAFDoc_ColorSurf)
            words = [name, found or "no class", names.get(name, "")]
            text = TCollection_ExtendedString(" ".join(word for word in words if word), True)
            TDataStd_Name.Set_s(label, text)
        writer = STEPCAFControl_Writer()
        # Names of faces are written only if this is asked for.
        Interface_Static.SetIVal_s("write.stepcaf.subshapes.name", 1)
        ready = writer.Transfer(document, STEPControl_AsIs)
        if not ready or writer.Write(str(path)) != IFSelect_RetDone:
            raise OutputError(f"the kernel can't write {path.name}")


def _label(shapes: Any, face: Any) -> Any:
    """The label of a face in the part that it belongs to; None if it has none."""
    parts = TDF_LabelSequence()
    shapes.GetShapes(parts)
    plain = face.Located(TopLoc_Location())
    for i in range(1, parts.Length() + 1):
        part = parts.Value(i)
        if shapes.IsSimpleShape_s(part) and shapes.IsSubShape(part, plain):
            label = TDF_Label()
            shapes.AddSubShape(part, plain, label)
            return None if label.IsNull() else label
    return None


def _colour(rgb: tuple[int, int, int]) -> Quantity_Color:
    red, green, blue = (value / 255.0 for value in rgb)
    return Quantity_Color(red, green, blue, Quantity_TypeOfColor.Quantity_TOC_sRGB)
