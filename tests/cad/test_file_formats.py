# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files as they come: units, formats, and files that are none."""

from __future__ import annotations

import math
import zipfile
from pathlib import Path

import kernel_parts
import numpy as np
import pytest

from gpswb.cad.density import Density
from gpswb.cad.read import read_solid
from gpswb.cad.units import step_units
from gpswb.errors import InputError

STL = Density.parse("stl")
INCH = (
    "#90001=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#90002);\n"
    "#90002=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"
    "#90003=DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\nENDSEC;\nEND-ISO-10303-21;"
)


def in_unit(path: Path, unit: str) -> None:
    """Give the same numbers another unit."""
    head, data = path.read_text().split("DATA;")
    lines = data.replace("\n", "").split(";")
    number = next(i for i, line in enumerate(lines) if "LENGTH_UNIT()" in line.replace(" ", ""))
    name = lines[number].split("=")[0]
    if unit == "m":
        lines[number] = f"{name}=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.))"
        data = ";\n".join(lines)
    else:
        lines[number] = (
            f"{name}=(CONVERSION_BASED_UNIT('INCH',#90001)LENGTH_UNIT()NAMED_UNIT(#90003))"
        )
        data = ";\n".join(lines).replace("ENDSEC;\nEND-ISO-10303-21;", INCH)
    path.write_text(f"{head}DATA;\n{data}")


@pytest.mark.parametrize(("unit", "factor"), [("mm", 1.0), ("m", 1000.0), ("inch", 25.4)])
def test_units_are_applied(unit: str, factor: float, kernel: str, tmp_path: Path) -> None:
    path = kernel_parts.write("drilled", tmp_path)
    if unit != "mm":
        in_unit(path, unit)
    solid = read_solid(path, STL, kernel)
    assert solid.unit == unit
    assert step_units(path.read_bytes()) == [unit]
    extent = np.ptp(solid.mesh.vertices, axis=0)
    assert extent == pytest.approx(np.array([20, 16, 10]) * factor)


def test_brep_gives_what_step_gives(kernel: str, tmp_path: Path) -> None:
    one, other = (
        read_solid(kernel_parts.write("drilled", tmp_path, suffix), Density.parse("auto"), kernel)
        for suffix in (".step", ".brep")
    )
    assert one.facemap is not None
    assert other.facemap is not None
    areas = [sorted(f.area for f in s.facemap.faces) for s in (one, other) if s.facemap]
    assert areas[0] == pytest.approx(areas[1])


DOCUMENT = """<?xml version='1.0' encoding='utf-8'?>
<Document SchemaVersion="4"><Objects Count="3" Dependencies="1">
<ObjectDeps Name="Box" Count="0"/><ObjectDeps Name="Cut" Count="1"><Dep Name="Box"/></ObjectDeps>
<ObjectDeps Name="Part" Count="1"><Dep Name="Cut"/></ObjectDeps>
</Objects><ObjectData Count="3">
<Object name="Box"><Properties><Property name="Shape"><Part file="Box.brp"/></Property></Properties>
</Object>
<Object name="Cut"><Properties><Property name="Shape"><Part file="Cut.brp"/></Property></Properties>
</Object>
<Object name="Part"><Properties>
<Property name="Group"><LinkList count="1"><Link value="Cut"/></LinkList></Property>
<Property name="Placement"><PropertyPlacement Px="100" Py="0" Pz="0" Q0="0" Q1="0" Q2="{s}"
 Q3="{s}"/></Property></Properties></Object>
</ObjectData></Document>"""


def test_freecad_document(kernel: str, tmp_path: Path) -> None:
    """Its final shape only, moved with its container: 100 mm along x, a quarter turn about z."""
    document = tmp_path / "part.FCStd"
    with zipfile.ZipFile(document, "w") as archive:
        archive.writestr("Document.xml", DOCUMENT.format(s=math.sqrt(0.5)))
        for name, made in (("Box", "cylinder"), ("Cut", "drilled")):
            archive.write(kernel_parts.write(made, tmp_path, ".brep"), f"{name}.brp")
    solid = read_solid(document, STL, kernel)
    assert solid.facemap is not None
    assert len(solid.facemap.faces) == 7
    low, high = solid.mesh.vertices.min(axis=0), solid.mesh.vertices.max(axis=0)
    assert low == pytest.approx([84, 0, 0], abs=1e-9)
    assert high == pytest.approx([100, 20, 10])


def bad_files(folder: Path) -> dict[str, Path]:
    good = kernel_parts.write("drilled", folder)
    files = {name: folder / f"{name}.step" for name in ("empty", "text", "truncated", "nothing")}
    files["empty"].write_text("  \n")
    files["text"].write_text("a part, they said\n" * 50)
    files["truncated"].write_text(good.read_text()[: good.stat().st_size // 2])
    files["nothing"].write_text(
        "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n"
    )
    files["faceless"] = kernel_parts.write("wire", folder)
    files["missing"] = folder / "missing.step"
    files["directory"] = folder
    files["other"] = folder / "part.iges"
    files["other"].write_text("S 1")
    files["brep"] = folder / "part.brep"
    files["brep"].write_text("CASCADE Topology V1, (c) Matra-Datavision\nLocations 1\nrubbish")
    files["document"] = folder / "broken.FCStd"
    files["document"].write_bytes(b"PK\3\4 and no more")
    files["bomb"] = folder / "bomb.FCStd"
    with zipfile.ZipFile(files["bomb"], "w") as archive:
        archive.writestr("Document.xml", '<!DOCTYPE x [<!ENTITY a "b">]><Document>&a;</Document>')
    return files


@pytest.mark.parametrize(
    "name",
    [
        "empty", "text", "truncated", "nothing", "faceless", "missing", "directory", "other",
        "brep", "document", "bomb",
    ],
)  # fmt: skip
def test_bad_input_is_one_clear_line(
    name: str, kernel: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    path = bad_files(tmp_path)[name]
    capfd.readouterr()
    with pytest.raises(InputError) as caught:
        read_solid(path, STL, kernel)
    message = str(caught.value)
    assert message.startswith(str(path))
    assert len(message.splitlines()) == 1
    assert capfd.readouterr().out == ""
