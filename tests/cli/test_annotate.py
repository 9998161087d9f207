# SPDX-License-Identifier: LGPL-2.1-or-later
"""`gpswb annotate` as a user meets it: outputs, and wrong input in one line."""

import csv
import json
import re
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from conftest import Command
from occt_colours import colours_of_faces

from gpswb.io.ap242.strings import encode
from gpswb.io.ap242.write import read_text
from gpswb.io.colours import WHEEL

EVIL = "=1+1 <img src=x onerror=alert(1)> 'q' \\X\\ \"d\" ä⌀&amp;"


@pytest.fixture(scope="module")
def evil_step(block_step: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The block, its product named with quotes, backslashes, non-ASCII and HTML."""
    text = block_step.read_text("latin-1")
    names = f"{encode(EVIL)},{encode(EVIL)}"
    text, n = re.subn(r"(PRODUCT\()'[^']*',\s*'[^']*'", lambda m: m[1] + names, text)
    assert n == 1
    path = tmp_path_factory.mktemp("evil") / "=1+1 evil<b>'&.step"
    path.write_text(text, "latin-1")
    return path


SPECS = """feature,characteristic,value,datums,modifiers,upper,lower,fit
Hole 1,position,0.2,A|B|C,M,,,
Face1,flatness,0.05,,,,,
Hole 1,size,,,,0.02,-0.1,
Plane 2,parallelism,?,A,,,,
"""
DATUMS = "A=Plane 1,B=Plane 3,C=Plane 5"


def test_all_outputs_of_a_part_with_an_evil_name(
    gpswb: Command, evil_step: Path, tmp_path: Path
) -> None:
    specs, out = tmp_path / "specs.csv", tmp_path / "out"
    specs.write_text(SPECS, encoding="utf-8")
    words = ["--datums", DATUMS, "--specs", specs, "--ap242", "--qif", "--csv", "--coloured"]
    done = gpswb("annotate", evil_step, "--out", out, *words)
    assert (done.returncode, done.stderr) == (0, "")
    assert "7 features, 3 compounds" in done.stdout
    assert (
        "3 datums, 2 tolerances, 1 size appended and read back, by OCCT as well; 1 without a value "
        "left out" in done.stdout
    )
    assert {p.name for p in out.iterdir()} == {
        "features.json", "features.csv", "specifications.csv", "ap242.step", "part.qif",
        "coloured.step", "report.html",
    }  # fmt: skip
    document = json.loads((out / "features.json").read_text("utf-8"))
    hole = next(f for f in document["features"] if f["name"] == "Hole 1")
    assert (hole["size"]["value"], hole["material"]) == (pytest.approx(8.0, abs=1e-3), "internal")
    assert [row["indication"] for row in document["specified"]] == [
        "⌖ Ø0.2 Ⓜ | A | B | C", "⏥ 0.05", "Ø8 +0.02/-0.1", "∥ ? | A"
    ]  # fmt: skip
    written = (out / "ap242.step").read_text("latin-1")
    original = evil_step.read_text("latin-1")
    kept = [line for line in original.splitlines() if "FILE_SCHEMA" not in line]
    assert [line for line in written.splitlines() if line in set(kept)][: len(kept)] == kept
    assert "<img" not in (out / "report.html").read_text("utf-8")
    for table in ("features.csv", "specifications.csv"):  # no cell is a formula
        with (out / table).open(newline="", encoding="utf-8") as file:
            cells = {cell for row in csv.reader(file) for cell in row}
        assert [cell for cell in cells if cell[:1] in ("=", "+", "@", "\t")] == []
        assert {cell for cell in cells if cell[:1] == "-"} <= {"-1 0 0"}
    assert ET.parse(out / "part.qif").getroot().tag.endswith("}QIFDocument")
    coloured = read_text(out / "coloured.step")
    names = {str(coloured[n]["ADVANCED_FACE"][0]) for n in coloured.of("ADVANCED_FACE")}
    assert f"{hole['faces'][0]} cylindrical Hole 1" in names
    assert len(names) == 7
    class_of = {face: f["class"] for f in document["features"] for face in f["faces"] if f["class"]
                and f["kind"] == "integral"}  # fmt: skip
    expected = [WHEEL[class_of[f"Face{i}"]] for i in range(1, 8)]
    assert colours_of_faces(out / "coloured.step") == expected
    for file in (coloured, read_text(out / "ap242.step")):
        (product,) = file.of("PRODUCT")
        assert file[product]["PRODUCT"][1] == EVIL


def test_pmi_that_is_in_the_file_is_reviewed(
    gpswb: Command, evil_step: Path, tmp_path: Path
) -> None:
    specs, out = tmp_path / "specs.csv", tmp_path / "out"
    specs.write_text(SPECS, encoding="utf-8")
    words = ["--datums", DATUMS, "--specs", specs, "--ap242", "--no-report"]
    assert gpswb("annotate", evil_step, "--out", out, *words).returncode == 0
    again = ["--out", tmp_path / "again", "--no-report", "--ap242"]
    done = gpswb("annotate", out / "ap242.step", *again)
    assert (done.returncode, done.stderr) == (0, "")
    # What is suggested goes beside the datums that are there.
    assert "3 suggested datums" in done.stdout
    added = read_text(tmp_path / "again" / "ap242.step")
    letters = [str(added[number]["DATUM"][-1]) for number in added.of("DATUM")]
    assert sorted(letters) == ["A", "B", "C", "D", "E", "F"]
    review = json.loads((tmp_path / "again" / "features.json").read_text("utf-8"))["review"]
    found = {row["subject"]: (row["features"], row["class"], row["text"]) for row in review}
    assert found["datum A"] == (["Plane 1"], "planar", "")
    assert found["⌖ position Ø0.2 Ⓜ | A | B | C"] == (["Hole 1"], "cylindrical", "")
    assert found["diameter 8 +0.02/-0.1"] == (["Hole 1"], "cylindrical", "")
    assert "PMI in the file, reviewed" in done.stdout
    # The letters are taken: nothing is written beside them.
    done = gpswb("annotate", out / "ap242.step", "--out", out, "--datums", "A=Plane 1", "--ap242")
    assert done.returncode == 1
    assert "the file has a datum A already" in done.stderr
    assert done.stderr.count("\n") == 1


@pytest.mark.parametrize(
    ("datums", "specs", "code", "words"),
    [
        ("A=Face99", None, 1, "datum A: 'Face99' is neither a feature nor a face of one"),
        ("A=Plane 11", None, 1, "nor a face of one; did you mean 'Plane 1'?"),
        ("A=Face1", "feature,characteristic\nFace1,flatness,1\n", 1, "1: more cells than"),
        ("A", None, 2, "'A' is no datum; write A=Face1"),
        ("A=Face1", "", 1, "there is no specification in it"),
        ("A=Face1", "name\nx\n", 1, "'name' is none of feature, characteristic"),
        ("A=Face1", "feature,characteristic,value\nFace1,flatness,x\n", 1, "'x' is not a number"),
        ("A=Face1", "feature,characteristic,datums\nFace2,position,A|A\n", 1, "A stands twice in"),
        ("A=Face1", "feature,characteristic\n\"<img src=x>\",flatness\n", 1, "'<img src=x>' is"),
    ],
)  # fmt: skip
def test_wrong_input_is_one_line(
    gpswb: Command,
    block_step: Path,
    tmp_path: Path,
    datums: str,
    specs: str | None,
    code: int,
    words: str,
) -> None:
    table = tmp_path / "specs.csv"
    extra = [] if specs is None else ["--specs", table]
    table.write_text(specs or "", encoding="utf-8")
    done = gpswb(
        "annotate", block_step, "--out", tmp_path / "out", "--datums", datums, *extra,
        "--density", "stl",
    )  # fmt: skip
    assert done.returncode == code
    assert words in done.stderr
    assert not (tmp_path / "out").exists()
    assert done.stdout == ""
    if code == 1:
        assert done.stderr.startswith("gpswb: ")
        assert done.stderr.count("\n") == 1


def test_a_table_of_another_country_and_a_common_datum(
    gpswb: Command, block_step: Path, tmp_path: Path
) -> None:
    """Semicolons and decimal commas; the second datum is two faces under letters of their own."""
    table, out = tmp_path / "specs.csv", tmp_path / "out"
    table.write_text("feature;characteristic;value;datums\nHole 1;position;0,25;A|B-C\n", "utf-8")
    words = ["--datums", DATUMS, "--system", "A|B-C><", "--specs", table, "--no-report", "--qif"]
    done = gpswb("annotate", block_step, "--out", out, *words)
    assert (done.returncode, done.stderr) == (0, "")
    assert "datum system A|B-C><\n" in done.stdout
    assert "Of the part translation along any direction" in done.stdout
    (row,) = json.loads((out / "features.json").read_text("utf-8"))["specified"]
    assert row["indication"] == "⌖ Ø0.25 | A | B-C"
    assert "<DatumLabel>B-C</DatumLabel>" in (out / "part.qif").read_text("utf-8")
    done = gpswb("annotate", block_step, "--out", out, "--system", "A|B")
    assert (done.returncode, done.stdout) == (1, "")
    assert "--system is made of the letters that --datums gives" in done.stderr


def test_what_needs_a_step_file_says_so_at_once(gpswb: Command, tmp_path: Path) -> None:
    for option in ("--ap242", "--coloured"):
        done = gpswb("annotate", tmp_path / "cube.off", "--out", tmp_path / "out", option)
        assert (done.returncode, done.stdout) == (1, "")
        assert f"cube.off: {option} is for STEP files" in done.stderr


@pytest.fixture(scope="module")
def open_face_step(block_step: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The block, and beside it a face whose border is one straight edge: nothing is in it."""
    from OCP.BRep import BRep_Builder
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge, BRepBuilderAPI_MakeWire
    from OCP.Geom import Geom_Plane
    from OCP.gp import gp_Dir, gp_Pnt
    from OCP.STEPControl import (
        STEPControl_Reader,
        STEPControl_StepModelType,
        STEPControl_Writer,
    )
    from OCP.TopoDS import TopoDS_Compound, TopoDS_Face

    reader = STEPControl_Reader()
    reader.ReadFile(str(block_step))
    reader.TransferRoots()
    edge = BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 30), gp_Pnt(1, 0, 30)).Edge()
    builder, face, whole = BRep_Builder(), TopoDS_Face(), TopoDS_Compound()
    builder.MakeFace(face, Geom_Plane(gp_Pnt(0, 0, 30), gp_Dir(0, 0, 1)), 1e-7)
    builder.Add(face, BRepBuilderAPI_MakeWire(edge).Wire())
    builder.MakeCompound(whole)
    for each in (reader.OneShape(), face):
        builder.Add(whole, each)
    path = tmp_path_factory.mktemp("open") / "open_face.step"
    writer = STEPControl_Writer()
    writer.Transfer(whole, STEPControl_StepModelType.STEPControl_AsIs)
    writer.Write(str(path))
    return path


def test_a_face_without_triangles_is_a_feature_without_a_class(
    gpswb: Command, open_face_step: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    words = ["--ap242", "--qif", "--csv", "--coloured"]
    done = gpswb("annotate", open_face_step, "--out", out, *words)
    assert (done.returncode, done.stderr) == (0, "")
    assert "1 of 8 faces have no triangles: Face8" in done.stdout
    document = json.loads((out / "features.json").read_text("utf-8"))
    integral = [f for f in document["features"] if f["kind"] == "integral"]
    assert sorted(name for f in integral for name in f["faces"]) == [
        f"Face{i}" for i in range(1, 9)
    ]
    bare = integral[-1]
    assert (bare["name"], bare["class"], bare["faces"]) == ("Unrecognised 1", None, ["Face8"])
    permitted = document["permitted"][str(bare["id"])]
    assert {row["status"] for row in permitted} == {"not allowed"}
    assert {row["reason"] for row in permitted} == {
        "not recognised: no region of the mesh lies on it"
    }
    with (out / "features.csv").open(newline="", encoding="utf-8") as file:
        (row,) = (row for row in csv.DictReader(file) if row["faces"] == "Face8")
    assert (row["class"], row["sure"]) == ("none", "no")
    assert "Unrecognised 1" in (out / "part.qif").read_text("utf-8")
    refused = gpswb("annotate", open_face_step, "--out", tmp_path / "no", "--datums", "A=Face8")
    assert (refused.returncode, refused.stderr) == (
        1, "gpswb: datum A: Face8 is not recognised: no region of the mesh lies on it\n",
    )  # fmt: skip
    table = tmp_path / "specs.csv"
    table.write_text("feature,characteristic,value\nFace8,flatness,0.1\n", encoding="utf-8")
    refused = gpswb("annotate", open_face_step, "--out", tmp_path / "no", "--specs", table)
    assert (refused.returncode, refused.stderr) == (
        1, "gpswb: flatness of 'Face8': not recognised: no region of the mesh lies on it\n",
    )  # fmt: skip
    assert not (tmp_path / "no").exists()
