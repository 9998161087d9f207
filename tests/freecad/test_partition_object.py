# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object without a window: parametric, with the user's overrides, saved, and readable
where the workbench is missing."""

import json
import os
import subprocess
from pathlib import Path

import FreeCAD
import Part
import pytest

from gpswb.errors import InputError
from gpswb.gui.annotation import annotation_of
from gpswb.gui.datums import add_datum
from gpswb.gui.exports import FORMATS, export
from gpswb.gui.fingerprint import shape_fingerprint
from gpswb.gui.importing import import_part
from gpswb.gui.objects.feature import features
from gpswb.gui.objects.partition import (
    add_override,
    clear_overrides,
    make_partition,
    partitions,
    run,
)
from gpswb.gui.partition_result import effective_result
from gpswb.gui.preferences import PATH
from gpswb.gui.specifications import add_specification

# In TopExp order: the box's six faces, the hole, as FreeCAD numbers them.
CLASSES = ["planar"] * 6 + ["cylindrical"]


def drilled(height=20.0, radius=4.0):
    hole = Part.makeCylinder(radius, 100.0, FreeCAD.Vector(10.0, 12.0, 0.0))
    return Part.makeBox(40.0, 30.0, height).cut(hole)


@pytest.fixture
def document():
    made = FreeCAD.newDocument("Part")
    yield made
    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)


@pytest.fixture
def part(document):
    obj = document.addObject("Part::Feature", "Drilled")
    obj.Shape = drilled()
    return obj


@pytest.fixture
def limit():
    """Sets how long a run may have taken for a silent recompute."""
    group = FreeCAD.ParamGet(PATH)
    yield lambda seconds: group.SetFloat("RecomputeLimit", seconds)
    group.RemFloat("RecomputeLimit")


def hole_of(partition):
    (hole,) = (each for each in features(partition) if each.Class == "cylindrical")
    return hole


def test_faces_features_and_values(part):
    partition = make_partition(part, density="coarse")
    assert list(partition.Classes) == CLASSES
    assert partition.Source is part
    assert partition.Status == "up to date"
    hole = hole_of(partition)
    assert hole.Faces == [(part, ("Face7",))]
    assert hole.Radius.Unit == FreeCAD.Units.Length
    assert float(hole.Radius) == pytest.approx(4.0)
    # The axis is drawn along the hole, and stands out of the part at both ends.
    box = hole.Shape.BoundBox
    assert (box.XMin, box.YMin) == pytest.approx((10.0, 12.0))
    assert box.ZMin < -0.5
    assert box.ZMax > 20.5
    ranking = json.loads(hole.LogLikelihood)
    assert len(ranking) == 7
    assert max(ranking, key=ranking.get) == next(iter(ranking))


def test_a_quick_part_follows_its_source(part, limit):
    limit(1e9)
    partition = make_partition(part, density="coarse")
    part.Shape = drilled(radius=6.0)
    part.Document.recompute()
    assert partition.Status == "up to date"
    assert float(hole_of(partition).Radius) == pytest.approx(6.0)
    part.Shape = Part.makeBox(1.0, 2.0, 3.0)
    part.Document.recompute()
    assert list(partition.Classes) == ["planar"] * 6
    assert len(features(partition)) == 6


def test_a_slow_part_is_marked_stale_and_waits(part, limit):
    limit(0.0)
    partition = make_partition(part, density="coarse")
    part.Document.recompute()
    assert partition.Status == "up to date"
    part.Shape = drilled(radius=6.0)
    part.Document.recompute()
    assert partition.Status == "stale"
    assert float(hole_of(partition).Radius) == pytest.approx(4.0)
    part.Shape = drilled()
    part.Document.recompute()
    assert partition.Status == "up to date"
    partition.Density = "medium"
    part.Document.recompute()
    assert partition.Status == "stale"
    run(partition)
    assert partition.Status == "up to date"


def test_overrides_survive_a_change_of_the_part(part, limit):
    limit(1e9)
    partition = make_partition(part, density="coarse")
    add_override(partition, "merge", ["Face1", "Face2"])
    add_override(partition, "class", ["Face7"], "revolute")
    expected = ["prismatic", "prismatic", "planar", "planar", "planar", "planar", "revolute"]
    assert list(partition.Classes) == expected
    assert len(features(partition)) == 6
    assert effective_result(partition)[0].document["faces"][6]["class"] == "revolute"

    part.Shape = drilled(height=21.0)
    part.Document.recompute()
    assert list(partition.Classes) == expected
    add_override(partition, "split", ["Face1", "Face2"])
    assert list(partition.Classes)[:2] == ["planar", "planar"]
    clear_overrides(partition)
    assert list(partition.Classes) == CLASSES


def test_an_override_finds_its_face_under_another_name(part, limit):
    limit(1e9)
    partition = make_partition(part, density="coarse")
    add_override(partition, "class", ["Face7"], "revolute")
    # A second hole is cut first, so that the first one's face comes later.
    second = Part.makeCylinder(3.0, 100.0, FreeCAD.Vector(30.0, 20.0, 0.0))
    first = Part.makeCylinder(4.0, 100.0, FreeCAD.Vector(10.0, 12.0, 0.0))
    part.Shape = Part.makeBox(40.0, 30.0, 20.0).cut(second).cut(first)
    part.Document.recompute()
    radii = [float(each.Radius) for each in features(partition) if hasattr(each, "Radius")]
    assert radii == pytest.approx([3.0])
    name = partition.Classes.index("revolute") + 1
    assert part.Shape.getElement(f"Face{name}").Surface.Radius == pytest.approx(4.0)


def test_refusals_leave_the_document_alone(document, part):
    with pytest.raises(InputError, match="density 'silly' isn't valid"):
        make_partition(part, density="silly")
    line = document.addObject("Part::Feature", "Line")
    line.Shape = Part.makeLine((0, 0, 0), (1, 0, 0))
    with pytest.raises(InputError, match="no faces"):
        make_partition(line)
    assert [obj.Name for obj in document.Objects] == ["Drilled", "Line"]
    partition = make_partition(part, density="coarse")
    with pytest.raises(InputError, match="no face 'Face99'"):
        add_override(partition, "split", ["Face99"])
    partition.Result = '{"schema": "other/1"}'
    with pytest.raises(InputError, match="schema"):
        effective_result(partition)


def test_every_export(part, tmp_path):
    partition = make_partition(part, density="coarse")
    for suffix in FORMATS:
        path = tmp_path / f"part{suffix}"
        export(partition, path)
        assert path.stat().st_size > 50, suffix
    assert json.loads((tmp_path / "part.json").read_text())["schema"] == "gpswb-result/1"
    assert "cylindrical" in (tmp_path / "part.csv").read_text()
    with pytest.raises(InputError, match="must end in one of"):
        export(partition, tmp_path / "part.doc")
    partition.Datums = "A=Face6,B=Face7"
    assert annotation_of(partition).system.notation == "A|B"


def test_import_step(document, part, tmp_path):
    path = tmp_path / "drilled.step"
    part.Shape.exportStep(str(path))
    (found,) = import_part(path, document)
    assert found.Label == "drilled"
    assert len(found.Shape.Faces) == 7
    broken = tmp_path / "broken.step"
    broken.write_text("ISO-10303-21;\n")
    with pytest.raises(InputError, match="truncated"):
        import_part(broken, document)


def test_saved_and_reopened(part, tmp_path):
    path = tmp_path / "part.FCStd"
    partition = make_partition(part, density="coarse")
    add_override(partition, "merge", ["Face1", "Face2"])
    classes, triangles = list(partition.Classes), partition.Triangles
    part.Document.saveAs(str(path))
    FreeCAD.closeDocument(part.Document.Name)
    document = FreeCAD.openDocument(str(path))
    (again,) = partitions(document)
    assert list(again.Classes) == classes
    assert len(effective_result(again)[0].partition.mesh.triangles) == triangles
    assert len(features(again)) == 6
    clear_overrides(again)
    assert list(again.Classes) == CLASSES


WITHOUT = """
import os, sys, FreeCAD
try:
    import gpswb
except ImportError:
    pass
else:
    os._exit(3)
document = FreeCAD.openDocument({path!r})
partition = next(o for o in document.Objects if o.Name.startswith("GpsPartition"))
holes = [o for o in partition.Group if getattr(o, "Class", "") == "cylindrical"]
frames = [list(o.Cells) for o in partition.Group if hasattr(o, "Cells")]
good = (
    list(partition.Classes) == {classes!r}
    and partition.Source.Name == "Drilled"
    and len(holes) == 1
    and abs(float(holes[0].Radius) - 4.0) < 1e-6
    and len(holes[0].Shape.Edges) == 1
    and frames == [["A"], [], ["⟂", "Ø0.1", "A"]]
)
document.recompute()
document.saveAs({path!r})
os._exit(0 if good else 4)
"""


def test_opens_and_saves_where_the_workbench_is_missing(part, tmp_path):
    path = tmp_path / "part.FCStd"
    partition = make_partition(part, density="coarse")
    add_datum(partition, "A", ["Face6"])
    add_specification(partition, ["Face7"], "perpendicularity", 0.1, "A")
    part.Document.saveAs(str(path))
    script = tmp_path / "without.py"
    script.write_text(WITHOUT.format(path=str(path), classes=CLASSES))
    apart = {key: str(tmp_path / key) for key in ("XDG_DATA_HOME", "XDG_CONFIG_HOME")}
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"} | apart
    done = subprocess.run(
        ["/usr/bin/freecadcmd", str(script)],
        env=environment,
        cwd=Path(tmp_path),
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    # What that FreeCAD saved is whole here, too.
    FreeCAD.closeDocument(part.Document.Name)
    (again,) = partitions(FreeCAD.openDocument(str(path)))
    assert len(effective_result(again)[0].faces) == 7
    assert [each.frame for each in annotation_of(again).specified] == ["⟂ Ø0.1 | A"]


def test_a_feature_of_a_body_means_the_body(document):
    body = document.addObject("PartDesign::Body", "Body")
    box = document.addObject("PartDesign::AdditiveBox", "Box")
    body.addObject(box)
    document.recompute()
    partition = make_partition(box, density="coarse")
    assert partition.Source is body
    assert list(partition.Classes) == ["planar"] * 6


def test_the_fingerprint_is_that_of_the_geometry(document, part, tmp_path):
    first = shape_fingerprint(part.Shape)
    part.Shape.tessellate(0.1)
    document.recompute()
    assert shape_fingerprint(part.Shape) == first
    assert shape_fingerprint(drilled()) == first
    path = tmp_path / "part.FCStd"
    document.saveAs(str(path))
    FreeCAD.closeDocument(document.Name)
    assert shape_fingerprint(FreeCAD.openDocument(str(path)).Drilled.Shape) == first
    assert shape_fingerprint(drilled(radius=4.0001)) != first
    # Domes on equal circles differ in no vertex and no edge.
    assert shape_fingerprint(dome(1.0)) != shape_fingerprint(dome(1.5))


def dome(height):
    circle = Part.Wire(Part.makeCircle(5.0))
    shape = Part.makeFilledFace([*circle.Edges, Part.Vertex(0.0, 0.0, height)])
    assert len(shape.Faces) == 1
    return shape
