# SPDX-License-Identifier: LGPL-2.1-or-later
"""PMI appended to STEP files and read back by OCCT: ``python benchmarks/pmi_round_trip.py FILES``;
``--docs FILE.md`` renews the figures in a document.

For each file: faces found in the text against the names that OCCT gives them (the face entities
are renamed in a copy, which the matching never sees), then datums, tolerances and sizes of every
kind on its faces, written, read back by our reader and by OCCT's, and the original text compared.
"""

from __future__ import annotations

import argparse
import re
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from docs_section import renew
from OCP.Interface import Interface_Static
from OCP.STEPCAFControl import STEPCAFControl_Reader
from OCP.TCollection import TCollection_ExtendedString
from OCP.TDataStd import TDataStd_Name
from OCP.TDF import TDF_AttributeIterator, TDF_LabelSequence
from OCP.TDocStd import TDocStd_Document
from OCP.TopAbs import TopAbs_FACE
from OCP.TopExp import TopExp
from OCP.TopTools import TopTools_IndexedMapOfShape
from OCP.XCAFApp import XCAFApp_Application
from OCP.XCAFDoc import XCAFDoc_DocumentTool, XCAFDoc_ShapeTool

from gpswb.cad.density import Density
from gpswb.cad.pmi_read import read_pmi_ocp
from gpswb.cad.read import read_solid
from gpswb.cad.silence import quiet
from gpswb.cad.solid import Solid
from gpswb.errors import GpswbError
from gpswb.gps.datum_system import Datum
from gpswb.gps.gps_feature import GpsFeature, Size
from gpswb.gps.specified import GeometricalTolerance, SizeTolerance, Specified
from gpswb.io.ap242.compare import differences
from gpswb.io.ap242.match import FaceEntity, match_faces
from gpswb.io.ap242.part21 import Part21
from gpswb.io.ap242.read_pmi import read_pmi
from gpswb.io.ap242.structure import shapes_of
from gpswb.io.ap242.write import read_text, write_ap242

_NAME = re.compile(r"((?:ADVANCED_FACE|FACE_SURFACE)\s*\(\s*)(?:'(?:[^']|'')*'|\$)")


def say(line: str) -> None:
    sys.stdout.write(line + "\n")
    sys.stdout.flush()


def named_by_occt(file: Part21, directory: Path) -> dict[str, int]:
    """Entity of each face, told by names that OCCT carries from the text to its shapes."""
    text, pieces, at = file.text, [], 0
    for number in sorted(file.of("ADVANCED_FACE", "FACE_SURFACE")):
        body = file.body(number)
        start = text.find(body, at)
        if start >= 0 and re.match(r"\s*(ADVANCED_FACE|FACE_SURFACE)", body):
            renamed = _NAME.sub(lambda m, n=number: f"{m[1]}'GF{n}'", body, count=1)
            pieces += [text[at:start], renamed]
            at = start + len(body)
    path = directory / "named.step"
    path.write_bytes("".join([*pieces, text[at:]]).encode("latin-1"))
    document = TDocStd_Document(TCollection_ExtendedString("x"))
    XCAFApp_Application.GetApplication_s().NewDocument(
        TCollection_ExtendedString("MDTV-XCAF"), document
    )
    with quiet():
        reader = STEPCAFControl_Reader()
        Interface_Static.SetIVal_s("read.stepcaf.subshapes.name", 1)
        reader.ReadFile(str(path))
        reader.Transfer(document)
    tool = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    numbers = {}
    for label in _labels(tool.GetShapes):
        for sub in _labels(lambda found, own=label: XCAFDoc_ShapeTool.GetSubShapes_s(own, found)):
            name = _name(sub)
            if name.startswith("GF"):
                for face in _faces(XCAFDoc_ShapeTool.GetShape_s(sub)):
                    numbers[face.TShape()] = int(name[2:])
    faces = _faces(reader.ChangeReader().OneShape())
    known = [(f"Face{i}", numbers.get(face.TShape())) for i, face in enumerate(faces, start=1)]
    return {name: number for name, number in known if number is not None}


def _labels(fill) -> Iterator:
    sequence = TDF_LabelSequence()
    fill(sequence)
    for i in range(1, sequence.Length() + 1):
        yield sequence.Value(i)


def _name(label) -> str:
    attributes = TDF_AttributeIterator(label)
    while attributes.More():
        if isinstance(attributes.Value(), TDataStd_Name):
            return attributes.Value().Get().ToExtString()
        attributes.Next()
    return ""


def _faces(shape) -> list:
    faces = TopTools_IndexedMapOfShape()
    TopExp.MapShapes_s(shape, TopAbs_FACE, faces)
    return [faces.FindKey(i) for i in range(1, faces.Extent() + 1)]


def some_pmi(
    solid: Solid, faces: list[str], taken: set[str]
) -> tuple[dict[str, tuple[GpsFeature, ...]], list[Specified]]:
    """Datums and tolerances of every kind on the faces given; the letters taken are left out."""
    features = [_feature(i, faces[k : k + n]) for i, (k, n) in enumerate(_spans(len(faces)))]
    free = [c for c in "ABCXYZUVWQ" if c not in taken][:3]
    letters = {c: (features[i],) for i, c in enumerate(free)}
    a, b, c = ((Datum(letter, letters[letter]),) for letter in free)
    common = (Datum(f"{free[0]}-{free[1]}", (features[0], features[1])),)
    orients = (Datum(free[0], letters[free[0]], orientation_only=True),)

    def tolerance(i, name, value, datums=(), modifiers=(), prefix=""):
        return GeometricalTolerance(
            features[i % len(features)], name, value, datums, modifiers, prefix
        )

    return letters, [
        tolerance(0, "flatness", 0.05),
        tolerance(1, "straightness", 0.02),
        tolerance(2, "roundness", 0.01),
        tolerance(3, "cylindricity", 0.015),
        tolerance(4, "line profile", 0.4, (*a, *b, *c)),
        tolerance(5, "surface profile", 0.25, (*common, *c)),
        tolerance(0, "parallelism", 0.1, b),
        tolerance(1, "perpendicularity", 0.03, orients),
        tolerance(2, "angularity", 0.06, (*a, *b)),
        tolerance(3, "position", 0.2, (*a, *b, *c), ("Ⓜ",), "Ø"),
        tolerance(4, "position", 0.3, (*a, *b), ("Ⓛ",), "SØ"),
        tolerance(5, "coaxiality", 0.04, b, (), "Ø"),
        tolerance(0, "symmetry", 0.12, c),
        tolerance(1, "circular run-out", 0.01, common),
        tolerance(2, "total run-out", 0.02, common),
        tolerance(3, "concentricity", 0.07, a, (), "Ø"),
        SizeTolerance(features[3], -0.1, 0.02),
        SizeTolerance(features[4], 0.01, 0.03),
        SizeTolerance(features[5], -0.03, -0.01),
        SizeTolerance(features[2], None, None, "H7"),
    ]


def _spans(count: int) -> list[tuple[int, int]]:
    """Six features of one, two or three faces each, from all over the shape."""
    step = max(count // 6, 1)
    return [(i * step % count, 1 + i % 3 if step > 3 else 1) for i in range(6)]


def _feature(i: int, faces: list[str]) -> GpsFeature:
    name = f"Feature {i} 'quoted' \\ ä ⌀ <b>"
    kind = "width" if i == 4 else "diameter"
    return GpsFeature(
        i, name, "integral", "planar", "plane", (), {}, {}, Size(kind, 12.5 + i), "neither", "",
        (), tuple(faces), 1.0,
    )  # fmt: skip


def untouched(before: Part21, after: Part21) -> bool:
    """Whether all of the original stands in the new text, but for FILE_SCHEMA."""
    start, stop = before.schema
    rest = after.text[after.schema[1] :]
    kept = before.text[stop : before.data_end], before.text[before.data_end :]
    return (
        after.text[: after.schema[0]] == before.text[:start]
        and rest.startswith(kept[0])
        and rest.endswith(kept[1])
    )


def one(path: Path, directory: Path) -> tuple[bool, str]:
    """Whether all of one file is equal, and a line of a table."""
    solid = read_solid(path, Density("stl"))
    file = read_text(path)
    shapes = shapes_of(file)
    found: dict[str, FaceEntity] = match_faces(file, shapes, solid.mesh, solid.facemap)
    names = named_by_occt(file, directory)
    both = [name for name in found if name in names]
    wrong = [name for name in both if int(found[name].number) != names[name]]
    said = (
        f"| {path.name} | {solid.unit} | {len(shapes)} | {len(found)}/{len(solid.facemap.faces)} | "
        f"{len(both) - len(wrong)}/{len(both)} |"
    )
    if not found:
        return False, f"{said} nothing to annotate | | | |"
    product = shapes[next(iter(found.values())).shape].definition
    faces = [name for name in found if shapes[found[name].shape].definition == product]
    taken = {str(file[number]["DATUM"][-1]) for number in file.of("DATUM")}
    letters, specified = some_pmi(solid, faces, taken)
    out = directory / "out.step"
    wanted = write_ap242(out, file, solid, letters, specified)
    again = read_text(out)
    entities = match_faces(again, shapes_of(again), solid.mesh, solid.facemap)
    own = differences(wanted, read_pmi(again, entities))
    occt = differences(wanted, read_pmi_ocp(out), occt=True)
    same = untouched(file, again)
    count = len(wanted.datums) + len(wanted.tolerances) + len(wanted.sizes)
    for lost in own + occt:
        say(f"{path.name}: lost {lost}")
    kept = "yes" if same else "no"
    said += f" {count} | {count - len(own)} | {count - len(occt)} | {kept} |"
    return not (wrong or own or occt) and same, said


HEADER = [
    "| file | unit | shapes | faces found | names right | items | read by gpswb | by OCCT | kept |",
    "|---|---|---:|---:|---:|---:|---:|---:|---|",
]


def main() -> int:
    parser = argparse.ArgumentParser(description="Round trip of AP242")
    parser.add_argument("files", type=Path, nargs="+", metavar="FILE")
    parser.add_argument("--docs", type=Path, metavar="FILE.md")
    args = parser.parse_args()
    good, lines = 0, []
    with tempfile.TemporaryDirectory() as directory:
        for path in args.files:
            try:
                equal, line = one(path, Path(directory))
            except GpswbError as error:
                equal, line = False, f"| {path.name} | {error} | | | | | | | |"
            good += equal
            lines.append(line)
            say(line)
    result = f"{good} of {len(args.files)} files equal."
    say(result)
    if args.docs:
        renew(args.docs, "round trip", [*HEADER, *lines, "", result])
    return 0 if good == len(args.files) else 1


if __name__ == "__main__":
    raise SystemExit(main())
