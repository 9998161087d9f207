# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colours of a STEP file's faces as OCCT reads them."""

from pathlib import Path

from OCP.Quantity import Quantity_Color, Quantity_TypeOfColor
from OCP.STEPCAFControl import STEPCAFControl_Reader
from OCP.TCollection import TCollection_ExtendedString
from OCP.TDocStd import TDocStd_Document
from OCP.TopAbs import TopAbs_FACE
from OCP.TopExp import TopExp
from OCP.TopTools import TopTools_IndexedMapOfShape
from OCP.XCAFApp import XCAFApp_Application
from OCP.XCAFDoc import XCAFDoc_ColorSurf, XCAFDoc_DocumentTool


def colours_of_faces(path: Path) -> list[tuple[int, ...] | None]:
    """Red, green and blue, 0 to 255, of each face in order; None for a face without a colour."""
    document = TDocStd_Document(TCollection_ExtendedString("coloured"))
    XCAFApp_Application.GetApplication_s().NewDocument(
        TCollection_ExtendedString("MDTV-XCAF"), document
    )
    reader = STEPCAFControl_Reader()
    reader.SetColorMode(True)
    reader.ReadFile(str(path))
    assert reader.Transfer(document)
    faces = TopTools_IndexedMapOfShape()
    TopExp.MapShapes_s(reader.ChangeReader().OneShape(), TopAbs_FACE, faces)
    tool, found = XCAFDoc_DocumentTool.ColorTool_s(document.Main()), []
    for i in range(1, faces.Extent() + 1):
        colour = Quantity_Color()
        if tool.GetColor(faces.FindKey(i), XCAFDoc_ColorSurf, colour):
            values = colour.Values(Quantity_TypeOfColor.Quantity_TOC_sRGB)
            found.append(tuple(round(255 * value) for value in values))
        else:
            found.append(None)
    return found
