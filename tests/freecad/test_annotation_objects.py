# SPDX-License-Identifier: LGPL-2.1-or-later
"""Datums, datum systems and specifications as document objects, without a window."""

import json

import FreeCAD
import Part
import pytest
from test_partition_object import document, drilled, part  # noqa: F401 - fixtures

from gpswb.errors import InputError
from gpswb.gui.annotation import annotation_of, remove_annotation
from gpswb.gui.colouring import CONSTRAINT, colouring
from gpswb.gui.datums import add_datum, datums_of, set_datums, take_suggestion
from gpswb.gui.exports import export
from gpswb.gui.importing import import_part
from gpswb.gui.objects.annotation import annotations_of
from gpswb.gui.objects.partition import finish_run, make_partition, partitions, run, start_run
from gpswb.gui.partition_result import effective_result
from gpswb.gui.specifications import add_specification, set_specification
from gpswb.io.ap242.match import match_faces
from gpswb.io.ap242.read_pmi import read_pmi
from gpswb.io.ap242.structure import shapes_of
from gpswb.io.ap242.write import read_text
from gpswb.io.colours import WHEEL
from gpswb.io.specification_file import read_specifications


@pytest.fixture(scope="module")
def found():
    """What a run finds, once for all tests."""
    made = FreeCAD.newDocument("Once")
    obj = made.addObject("Part::Feature", "Drilled")
    obj.Shape = drilled()
    work = start_run(obj, "coarse", "robust")
    FreeCAD.closeDocument(made.Name)
    yield work.result(), work.folder / "labels.npz"
    work.close()


@pytest.fixture
def partition(part, found):  # noqa: F811
    made = make_partition(part, "coarse", "robust", compute=False)
    for _ in finish_run(made, *found):
        pass
    return made


def states(partition):
    found = colouring(
        effective_result(partition)[0],
        "constraint state",
        WHEEL,
        [(letter, "+".join(faces)) for letter, faces in datums_of(partition)],
        partition.DatumSystem,
    )
    return [CONSTRAINT[label][0] for label in found.of_face]


def by_place(part):  # noqa: F811
    """Names of the faces by what they are, whatever their order."""
    found = {}
    for i, face in enumerate(part.Shape.Faces):
        box = face.BoundBox
        flat = [axis for axis in "XYZ" if getattr(box, f"{axis}Length") < 1e-6]
        key = f"{flat[0].lower()}{getattr(box, f'{flat[0]}Min'):.0f}" if flat else "hole"
        found[key] = f"Face{i + 1}"
    return found


def test_datums_their_system_and_the_constraint_state(part, partition):  # noqa: F811
    at = by_place(part)
    first = add_datum(partition, "A", [at["z0"]])
    assert first.Faces == [(part, (at["z0"],))]
    assert list(first.Cells) == ["A"]
    # A plane locks 1T+2R: what is parallel to it is located, a hole that stands on it keeps its
    # direction, and a plane that stands on it may still turn.
    at_state = dict(zip(at.values(), states(partition), strict=True))
    assert [at_state[at[k]] for k in ("z0", "z20", "hole", "x0")] == [
        "datum",
        "fully located",
        "oriented, not located",
        "not oriented",
    ]
    add_datum(partition, "B", [at["hole"]])
    add_datum(partition, "C", [at["x0"]])
    (system,) = (obj for obj in annotations_of(partition) if not obj.Faces)
    assert system.Label == "Datum system A|B|C"
    assert system.Status == "complete"
    assert "A (Plane" in system.Message
    assert "locks one translation and two rotations" in system.Message
    assert set(states(partition)) == {"datum", "fully located"}
    assert partition.DatumSystem == annotation_of(partition).system.notation == "A|B|C"
    remove_annotation(partition, next(o for o in annotations_of(partition) if o.Label == "Datum C"))
    assert system.Status == "can't be placed"
    assert [letter for letter, _ in datums_of(partition)] == ["A", "B"]


def test_a_specification_in_its_frame(part, partition):  # noqa: F811
    at = by_place(part)
    set_datums(partition, [("A", [at["z0"]]), ("B", [at["x0"]]), ("C", [at["y0"]])])
    obj = add_specification(
        partition, [at["hole"]], "position", value=0.2, datums="A|B|C", modifiers="M"
    )
    assert list(obj.Cells) == ["⌖", "Ø0.2 Ⓜ", "A", "B", "C"]
    assert obj.Label == "Position of Hole 1"
    assert obj.Status == "recommended"
    assert obj.Faces == [(part, (at["hole"],))]
    # Where the leader ends is on the hole's wall; the frame stands outside the part.
    x, y, z = obj.Anchor
    assert ((x - 10.0) ** 2 + (y - 12.0) ** 2) ** 0.5 == pytest.approx(4.0, rel=0.05)
    assert 0.0 < z < 20.0
    assert not part.Shape.BoundBox.isInside(obj.Place)
    # Nothing is invented, and what ISO 1101 speaks against is said.
    flat = add_specification(partition, [at["z20"]], "flatness")
    assert list(flat.Cells) == ["⏥", "?"]
    round_ = add_specification(partition, [at["z20"]], "roundness", value=0.1)
    assert round_.Status == "not allowed"
    assert "its sections aren't circles" in round_.Message
    set_specification(partition, flat, [at["z20"]], characteristic="parallelism", value="0.05",
                      datums="A")  # fmt: skip
    assert list(flat.Cells) == ["∥", "0.05", "A"]
    size = add_specification(partition, [at["hole"]], "size", "", fit="H7")
    assert list(size.Cells) == ["Ø8 H7"]
    assert [each.frame for each in annotation_of(partition).specified] == [
        "⌖ Ø0.2 Ⓜ | A | B | C",
        "∥ 0.05 | A",
        "○ 0.1",
        "Ø8 H7",
    ]


def test_suggestion_and_runner_up(partition):
    system = take_suggestion(partition)
    assert system.Status == "complete"
    first = datums_of(partition)
    again = take_suggestion(partition, 1)
    assert again is system
    assert datums_of(partition) != first
    assert len([o for o in annotations_of(partition) if o.Label.startswith("Datum ")]) == 4


def test_refusals_leave_the_document_alone(part, partition):  # noqa: F811
    at = by_place(part)
    add_datum(partition, "A", [at["z0"]])
    add_specification(partition, [at["hole"]], "perpendicularity", 0.1, "A")
    before = [(obj.Name, getattr(obj, "Annotation", "")) for obj in part.Document.Objects]
    for call, why in (
        (lambda: add_datum(partition, "A", [at["x0"]]), "given twice"),
        (lambda: add_datum(partition, "a", [at["x0"]]), "no datum letter"),
        (lambda: add_datum(partition, "B", ["Face99"]), "no face 'Face99'"),
        (lambda: set_datums(partition, [("B", [at["x0"]])]), "datum A"),
        (lambda: set_datums(partition, [("A", [at["x0"]])], "A|D"), "datum D"),
        (lambda: add_specification(partition, [at["x0"]], "flatnes", 1), "did you mean"),
        (lambda: add_specification(partition, [at["x0"]], "flatness", "1", "A"), "no datum"),
        (lambda: add_specification(partition, [at["x0"]], "flatness", "wide"), "not a number"),
        (lambda: add_specification(partition, [at["x0"]], "size", "", upper=1, lower=0), "size"),
        (lambda: add_specification(partition, [], "flatness"), "no face"),
    ):
        with pytest.raises(InputError, match=why):
            call()
    assert [(o.Name, getattr(o, "Annotation", "")) for o in part.Document.Objects] == before


def test_saved_reopened_and_changed(part, partition, tmp_path):  # noqa: F811
    at = by_place(part)
    add_datum(partition, "A", [at["z0"]])
    add_specification(partition, [at["hole"]], "perpendicularity", 0.1, "A")
    path = tmp_path / "part.FCStd"
    part.Document.saveAs(str(path))
    FreeCAD.closeDocument(part.Document.Name)
    again = FreeCAD.openDocument(str(path))
    (partition,) = partitions(again)
    assert [list(obj.Cells) for obj in annotations_of(partition) if obj.Cells] == [
        ["A"],
        ["⟂", "Ø0.1", "A"],
    ]
    assert all(json.loads(o.Annotation)["schema"] == "gpswb-annotation/1"
               for o in annotations_of(partition))  # fmt: skip
    # Two faces more, and so another order: the annotations follow their own.
    partition.Source.Shape = drilled().cut(Part.makeBox(3.0, 3.0, 20.0))
    run(partition)
    (hole,) = (
        f"Face{i + 1}"
        for i, face in enumerate(partition.Source.Shape.Faces)
        if type(face.Surface).__name__ == "Cylinder"
    )
    assert hole != at["hole"]
    spec = next(o for o in annotations_of(partition) if len(o.Cells) > 1)
    assert spec.Faces == [(partition.Source, (hole,))]
    assert spec.Status == "recommended"


def test_a_face_that_is_gone(part, partition):  # noqa: F811
    at = by_place(part)
    obj = add_specification(partition, [at["hole"]], "cylindricity", 0.01)
    part.Shape = Part.makeBox(40.0, 30.0, 20.0)
    run(partition)
    assert obj.Status == "can't be placed"
    assert "is gone" in obj.Message
    assert list(obj.Cells) == []
    with pytest.raises(InputError, match="is gone"):
        annotation_of(partition)


def test_export_is_that_of_annotate(part, partition, tmp_path):  # noqa: F811
    at = by_place(part)
    set_datums(partition, [("A", [at["z0"]]), ("B", [at["x0"], at["x40"]])])
    add_specification(partition, [at["hole"]], "position", 0.2, "A|B", modifiers="M")
    add_specification(partition, [at["hole"]], "size", "", upper=0.02, lower=-0.1)
    add_specification(partition, [at["z20"]], "flatness")
    export(partition, tmp_path / "part.ap242.step")
    # Read back with faces numbered as in the document: a third party's faces would be too.
    file = read_text(tmp_path / "part.ap242.step")
    solid = effective_result(partition)[0].solid
    pmi = read_pmi(file, match_faces(file, shapes_of(file), solid.mesh, solid.facemap))
    assert {d.letter: set(d.faces) for d in pmi.datums} == {
        "A": {at["z0"]},
        "B": {at["x0"], at["x40"]},
    }
    # What is open isn't written: there is no value to write.
    ((position,), (size,)) = pmi.tolerances, pmi.sizes
    assert (position.characteristic, position.value, position.datums) == ("position", 0.2, "A|B")
    assert (position.prefix, position.modifiers, position.faces) == ("Ø", ("Ⓜ",), (at["hole"],))
    assert (size.nominal, size.upper, size.lower) == (pytest.approx(8.0), 0.02, -0.1)
    export(partition, tmp_path / "part.given.csv")
    rows = read_specifications(tmp_path / "part.given.csv")
    assert [(r.characteristic, r.value, r.datums, r.modifiers, r.lower) for r in rows] == [
        ("position", 0.2, "A|B", ("Ⓜ",), None),
        ("size", None, "", (), -0.1),
        ("flatness", None, "", (), None),
    ]
    export(partition, tmp_path / "part.features.json")
    written = json.loads((tmp_path / "part.features.json").read_text(encoding="utf-8"))
    assert len(written["specified"]) == 3
    assert written["datums_given"]


def lines_of(path):
    return path.read_text(encoding="latin-1").splitlines()


@pytest.fixture
def imported(document, tmp_path):  # noqa: F811
    """A part from a STEP file whose product has an evil name; file and partition."""
    path = tmp_path / "part <b>.step"
    drilled().exportStep(str(path))
    text = path.read_text(encoding="latin-1")
    text = text.replace("PRODUCT('", r"PRODUCT('<i>''\\ \X2\00E4\X0\ ")
    path.write_text(text, encoding="latin-1")
    (part_,) = import_part(path, document)
    return path, make_partition(part_, density="coarse")


def test_pmi_goes_on_the_text_of_the_part_s_own_file(imported, tmp_path):
    path, partition = imported
    source = partition.Source
    hole = named(source, "Cylinder")
    # The part may have been moved since: its file has not.
    source.Placement = FreeCAD.Placement(
        FreeCAD.Vector(5.0, -3.0, 40.0), FreeCAD.Rotation(FreeCAD.Vector(1.0, 2.0, 3.0), 70.0)
    ).multiply(source.Placement)
    run(partition)
    add_specification(partition, [hole], "size", "", upper=-0.02, lower=-0.1)
    out = tmp_path / "out.ap242.step"
    assert export(partition, out) == f"PMI is appended to the text of {path}"
    written = lines_of(out)
    own = [
        line for line in lines_of(path) if "FILE_SCHEMA" not in line and "AUTOMOTIVE" not in line
    ]
    assert [line for line in written if line in set(own)][: len(own)] == own
    # Back in the window, what is in that file now is reviewed.
    (again,) = import_part(out, source.Document)
    other = make_partition(again, density="coarse")
    export(other, tmp_path / "again.features.json")
    *datums, size = json.loads((tmp_path / "again.features.json").read_text("utf-8"))["review"]
    assert [row["subject"] for row in datums] == ["datum A", "datum B", "datum C"]
    assert (size["subject"], size["features"]) == ("diameter 8 -0.02/-0.1", ["Hole 1"])
    export(other, tmp_path / "again.html")
    assert "<i>" not in (tmp_path / "again.html").read_text("utf-8")
    assert any("LENGTH_MEASURE(-0.1)" in line for line in written[len(own) - 5 :])


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda path, _: path.unlink(), "no such file"),
        (lambda path, _: path.write_text(path.read_text() + " "), "has changed since"),
        (lambda _, part_: setattr(part_, "Shape", drilled(20.01)), "the part has changed since"),
        (lambda _, part_: setattr(part_, "StepFile", ""), "wasn't imported from a STEP file"),
    ],
    ids=["gone", "changed", "another shape", "no file"],
)
def test_without_its_file_the_part_is_written_anew_and_that_is_said(
    imported, tmp_path, change, words
):
    path, partition = imported
    change(path, partition.Source)
    run(partition)
    add_specification(partition, [named(partition.Source, "Cylinder")], "cylindricity", 0.02)
    said = export(partition, tmp_path / "out.ap242.step")
    assert "not on the original STEP text but on the part as FreeCAD writes it: " in said
    assert words in said
    file = read_text(tmp_path / "out.ap242.step")
    assert len(list(file.of("CYLINDRICITY_TOLERANCE"))) == 1


def named(part_, kind):
    (name,) = (
        f"Face{i + 1}"
        for i, face in enumerate(part_.Shape.Faces)
        if type(face.Surface).__name__ == kind
    )
    return name


def test_undo_in_one_step(part, partition):  # noqa: F811
    part.Document.UndoMode = 1
    at = by_place(part)
    part.Document.openTransaction("datum")
    add_datum(partition, "A", [at["z0"]])
    part.Document.commitTransaction()
    part.Document.undo()
    assert annotations_of(partition) == []
    assert partition.Datums == partition.DatumSystem == ""
    part.Document.redo()
    assert [obj.Label for obj in annotations_of(partition)] == ["Datum A", "Datum system A"]
