# SPDX-License-Identifier: LGPL-2.1-or-later
"""PMI of a STEP file through OCCT's own reader (OCP only).

It knows nothing of our writer, so that what was written can be read back and compared. It leaves
out what some systems write (see `gpswb.io.ap242.read_pmi`). Native code on a user's file: call it
in a guarded child process.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from OCP.IFSelect import IFSelect_RetDone
from OCP.STEPCAFControl import STEPCAFControl_Reader
from OCP.TCollection import TCollection_ExtendedString
from OCP.TDF import TDF_AttributeIterator, TDF_Label, TDF_LabelSequence
from OCP.TDocStd import TDocStd_Document
from OCP.TopAbs import TopAbs_FACE
from OCP.TopExp import TopExp
from OCP.TopTools import TopTools_IndexedMapOfShape
from OCP.XCAFApp import XCAFApp_Application
from OCP.XCAFDoc import (
    XCAFDoc_Datum,
    XCAFDoc_Dimension,
    XCAFDoc_DimTolTool,
    XCAFDoc_DocumentTool,
    XCAFDoc_GeomTolerance,
)

from gpswb.cad.pmi import Pmi, PmiDatum, PmiSize, PmiTolerance, in_order
from gpswb.cad.silence import quiet
from gpswb.errors import InputError

_CHARACTERISTICS = {
    "Straightness": "straightness",
    "Flatness": "flatness",
    "CircularityOrRoundness": "roundness",
    "Cylindricity": "cylindricity",
    "ProfileOfLine": "line profile",
    "ProfileOfSurface": "surface profile",
    "Parallelism": "parallelism",
    "Perpendicularity": "perpendicularity",
    "Angularity": "angularity",
    "Position": "position",
    "Concentricity": "concentricity",
    "Coaxiality": "coaxiality",
    "Symmetry": "symmetry",
    "CircularRunout": "circular run-out",
    "TotalRunout": "total run-out",
}
_PREFIX = {"Diameter": "Ø", "SphericalDiameter": "SØ"}
_MATERIAL = {"M": "Ⓜ", "L": "Ⓛ"}
_MODIFIERS = {
    "Common_Zone": "CZ",
    "Maximum_Material_Requirement": "Ⓜ",
    "Least_Material_Requirement": "Ⓛ",
    "Reciprocity_Requirement": "Ⓡ",
}
_SIZES = {
    "Size_Diameter": "diameter",
    "Size_SphericalDiameter": "spherical diameter",
    "Size_Radius": "radius",
    "Size_SphericalRadius": "spherical radius",
    "Size_Thickness": "thickness",
    "Size_Angular": "angle",
}

FIT = "with a tolerance class"
"""Stands for the class: the binding does not tell which."""


def read_pmi_ocp(path: Path) -> Pmi:
    """Datums, tolerances and sizes as OCCT reads them, on faces named in TopExp order.

    Raises:
        InputError: the kernel can't read the file.
    """
    with quiet():
        document = TDocStd_Document(TCollection_ExtendedString("pmi"))
        XCAFApp_Application.GetApplication_s().NewDocument(
            TCollection_ExtendedString("MDTV-XCAF"), document
        )
        reader = STEPCAFControl_Reader()
        reader.SetGDTMode(True)
        for off in (reader.SetColorMode, reader.SetNameMode, reader.SetLayerMode):
            off(False)
        if reader.ReadFile(str(path)) != IFSelect_RetDone or not reader.Transfer(document):
            raise InputError(f"{path}: not a STEP file that the kernel can read")
        labels = _Labels(document, reader.ChangeReader().OneShape())
        datums: dict[str, PmiDatum] = {}
        for label, each in labels.of("GetDatumLabels", XCAFDoc_Datum):
            letter = each.GetName().ToCString()
            faces, _ = labels.faces(label)
            known = datums.get(letter, PmiDatum(letter, ()))
            datums[letter] = PmiDatum(
                letter,
                in_order({*known.faces, *faces}),
                known.target or each.IsDatumTarget(),
            )
        tolerances = [
            _tolerance(labels, label, each)
            for label, each in labels.of("GetGeomToleranceLabels", XCAFDoc_GeomTolerance)
        ]
        sizes = [
            _size(labels, label, each)
            for label, each in labels.of("GetDimensionLabels", XCAFDoc_Dimension)
            if _last(each.GetType(), "DimensionType_") in _SIZES
        ]
    return Pmi(tuple(datums[k] for k in sorted(datums)), tuple(tolerances), tuple(sizes))


class _Labels:
    """Labels of the document's PMI and the faces that they refer to."""

    def __init__(self, document: Any, shape: Any) -> None:
        self._tool = XCAFDoc_DocumentTool.DimTolTool_s(document.Main())
        self._shapes = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
        faces = _faces(shape)
        self._names: dict[Any, list[str]] = {}
        for i, face in enumerate(faces, start=1):
            self._names.setdefault(face.TShape(), []).append(f"Face{i}")

    def of(self, getter: str, kind: Any) -> Iterator[tuple[TDF_Label, Any]]:
        """Labels that a getter of the tool lists, with their objects."""
        sequence = TDF_LabelSequence()
        getattr(self._tool, getter)(sequence)
        for label in _each(sequence):
            attribute = _attribute(label, kind)
            if attribute is not None:
                yield label, attribute.GetObject()

    def faces(self, label: TDF_Label) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """Faces that a label refers to, first and second reference."""
        first, second = TDF_LabelSequence(), TDF_LabelSequence()
        XCAFDoc_DimTolTool.GetRefShapeLabel_s(label, first, second)
        return self._named(first), self._named(second)

    def _named(self, labels: TDF_LabelSequence) -> tuple[str, ...]:
        found: set[str] = set()
        for label in _each(labels):
            for face in _faces(self._shapes.GetShape_s(label)):
                found.update(self._names.get(face.TShape(), ()))
        return in_order(found)


def _tolerance(labels: _Labels, label: TDF_Label, each: Any) -> PmiTolerance:
    references = TDF_LabelSequence()
    XCAFDoc_DimTolTool.GetDatumWithObjectOfTolerLabels_s(label, references)
    cells: dict[int, list[str]] = {}
    for reference in _each(references):
        attribute = _attribute(reference, XCAFDoc_Datum)
        if attribute is None:
            continue
        datum = attribute.GetObject()
        orients = any(_last(m, "Modif_") == "Orientation" for m in datum.GetModifiers())
        name = datum.GetName().ToCString() + ("><" if orients else "")
        cell = cells.setdefault(datum.GetPosition(), [])
        if name not in cell:
            cell.append(name)
    section = "|".join("-".join(cells[position]) for position in sorted(cells))
    modifiers = [_MATERIAL.get(_last(each.GetMaterialRequirementModifier(), "Modif_"), "")]
    modifiers += [
        _MODIFIERS.get(_last(m, "Modif_"), _last(m, "Modif_")) for m in each.GetModifiers()
    ]
    name = each.GetSemanticName()
    return PmiTolerance(
        name=name.ToCString() if name is not None else "",
        characteristic=_CHARACTERISTICS.get(_last(each.GetType(), "Type_"), ""),
        value=float(each.GetValue()) or None,
        prefix=_PREFIX.get(_last(each.GetTypeOfValue(), "Value_"), ""),
        modifiers=tuple(m for m in modifiers if m),
        datums=section,
        faces=labels.faces(label)[0],
    )


def _size(labels: _Labels, label: TDF_Label, each: Any) -> PmiSize:
    lower = upper = None
    if each.IsDimWithPlusMinusTolerance():
        # OCCT keeps the amount of the lower deviation only.
        lower, upper = -float(each.GetLowerTolValue()), float(each.GetUpperTolValue())
    faces, others = labels.faces(label)
    return PmiSize(
        kind=_SIZES[_last(each.GetType(), "DimensionType_")],
        nominal=float(each.GetValue()) or None,
        lower=lower,
        upper=upper,
        fit=FIT if each.IsDimWithClassOfTolerance() else "",
        faces=in_order({*faces, *others}),
    )


def _faces(shape: Any) -> list[Any]:
    faces = TopTools_IndexedMapOfShape()
    if not shape.IsNull():
        TopExp.MapShapes_s(shape, TopAbs_FACE, faces)
    return [faces.FindKey(i) for i in range(1, faces.Extent() + 1)]


def _each(labels: TDF_LabelSequence) -> Iterator[TDF_Label]:
    for i in range(1, labels.Length() + 1):
        yield labels.Value(i)


def _attribute(label: TDF_Label, kind: Callable[..., Any]) -> Any:
    attributes = TDF_AttributeIterator(label)
    while attributes.More():
        value = attributes.Value()
        if isinstance(value, kind):  # type: ignore[arg-type]
            return value
        attributes.Next()
    return None


def _last(value: Any, after: str) -> str:
    return str(value).split(".")[-1].split(after)[-1]
