# SPDX-License-Identifier: LGPL-2.1-or-later
"""A partition of FreeCAD's Mesh and Points objects: regions as features, no faces."""

import json

import FreeCAD
import Mesh
import numpy as np
import Points
import pytest
from test_partition_object import document, drilled  # noqa: F401 - fixture

from gpswb.errors import InputError
from gpswb.gui.colouring import colouring
from gpswb.gui.exports import export
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
from gpswb.io.colours import WHEEL

CLASSES = ["cylindrical"] + ["planar"] * 6
"""The drilled block is known: six planes and a hole."""


def scan_of(shape):
    points, facets = shape.tessellate(0.05)
    return Mesh.Mesh([[points[i] for i in facet] for facet in facets])


@pytest.fixture
def scan(document):  # noqa: F811 - the fixture
    obj = document.addObject("Mesh::Feature", "Scan")
    obj.Mesh = scan_of(drilled())
    return obj


@pytest.fixture
def partition(scan):
    return make_partition(scan)


def names(partition, wanted):
    stored, _ = effective_result(partition)
    return [face.name for face in stored.faces if face.invariance_class == wanted]


def test_regions_of_a_mesh_are_features(scan, partition):
    assert sorted(partition.Classes) == CLASSES
    assert partition.Density == "as read"
    assert partition.Triangles == scan.Mesh.CountFacets
    assert sorted(f.Class for f in features(partition)) == CLASSES
    assert not any(f.Faces for f in features(partition))
    (hole,) = (f for f in features(partition) if f.Class == "cylindrical")
    assert hole.Radius.Value == pytest.approx(4.0, rel=1e-4)
    # Its axis reaches through the block, 20 high, and stands out on both sides.
    box = hole.Shape.BoundBox
    assert box.ZMin < 0.0 < 20.0 < box.ZMax
    assert partition.getEditorMode("FaceAccuracy") == ["Hidden"]


def test_it_stands_in_its_container_like_the_mesh(scan):
    scan.Placement.Base = FreeCAD.Vector(0.0, 0.0, 100.0)
    box = scan.Document.addObject("App::Part", "Box")
    box.Placement.Base = FreeCAD.Vector(1000.0, 0.0, 0.0)
    box.addObject(scan)
    partition = make_partition(scan)
    assert partition in box.Group
    # The container moves both: coordinates are those within it.
    vertices = effective_result(partition)[0].solid.mesh.vertices
    assert vertices.min(axis=0) == pytest.approx([0.0, 0.0, 100.0], abs=1e-5)


def test_what_the_user_knows_better_survives_a_run(partition):
    first, second, *_ = names(partition, "planar")
    add_override(partition, "merge", [first, second])
    (hole,) = names(partition, "cylindrical")
    add_override(partition, "class", [hole], "revolute")
    assert partition.Regions == 6
    assert sorted(f.Class for f in features(partition)).count("revolute") == 1
    run(partition)
    assert partition.Regions == 6
    assert "revolute" in partition.Classes
    assert json.loads(partition.Result)["faces"] == []
    clear_overrides(partition)
    assert sorted(partition.Classes) == CLASSES


def test_a_number_of_a_region_says_nothing_of_another_mesh(scan, partition):
    (hole,) = names(partition, "cylindrical")
    add_override(partition, "class", [hole], "revolute")
    scan.Mesh = scan_of(drilled(radius=6.0))
    run(partition)
    assert "revolute" not in partition.Classes
    assert f"{hole} is gone" in partition.Message


def test_a_changed_mesh_makes_it_stale(scan, partition):
    group = FreeCAD.ParamGet(PATH)
    group.SetFloat("RecomputeLimit", 0.0)
    try:
        scan.Document.recompute()
        assert partition.Status == "up to date"
        scan.Mesh = scan_of(drilled(height=21.0))
        scan.Document.recompute()
        assert partition.Status == "stale"
    finally:
        group.RemFloat("RecomputeLimit")


def test_save_and_reopen(partition, tmp_path):
    (hole,) = names(partition, "cylindrical")
    add_override(partition, "class", [hole], "revolute")
    path = tmp_path / "scan.FCStd"
    partition.Document.saveAs(str(path))
    classes = list(partition.Classes)
    FreeCAD.closeDocument(partition.Document.Name)
    (again,) = partitions(FreeCAD.openDocument(str(path)))
    again.touch()
    again.Document.recompute()
    assert (again.Status, list(again.Classes)) == ("up to date", classes)
    assert names(again, "revolute") == [hole]


def test_files(partition, tmp_path):
    for suffix in (".html", ".json", ".ply", ".npz"):
        export(partition, tmp_path / f"scan{suffix}")
    told = json.loads((tmp_path / "scan.json").read_text())
    assert told["faces"] == []
    assert told["validation"] is None
    assert len(told["regions"]) == 7
    for suffix in (".csv", ".ap242.step", ".features.json"):
        with pytest.raises(InputError, match="without CAD faces"):
            export(partition, tmp_path / f"scan{suffix}")
        assert not (tmp_path / f"scan{suffix}").exists()


def test_colours_of_pieces(partition):
    stored, _ = effective_result(partition)
    found = colouring(stored, "invariance class", WHEEL)
    assert sum(found.counts) == 7
    assert found.counts[:2] == (6, 1)
    assert (found.of_facet >= 0).all()


def test_points(document, tmp_path):  # noqa: F811 - the fixture
    side = np.linspace(0.0, 20.0, 21)
    grid = np.stack(np.meshgrid(side, side, [0.0]), axis=-1).reshape(-1, 3)
    wall = grid[:, [0, 2, 1]]
    points = np.unique(np.vstack([grid, wall]), axis=0)
    cloud = document.addObject("Points::Feature", "Cloud")
    cloud.Points = Points.Points([FreeCAD.Vector(*p) for p in points.tolist()])
    partition = make_partition(cloud)
    assert partition.Classes == ["planar", "planar"]
    export(partition, tmp_path / "cloud.npz")
    with np.load(tmp_path / "cloud.npz") as file:
        assert file["point"] == pytest.approx(points, abs=1e-5)
        assert (file["point_class"] == 0).mean() > 0.9
    cloud.Points = Points.Points()
    with pytest.raises(InputError, match="empty"):
        make_partition(cloud)


def test_import_of_measured_files(document, tmp_path):  # noqa: F811 - the fixture
    scan_of(drilled()).write(str(tmp_path / "scan.stl"))
    (obj,) = import_part(tmp_path / "scan.stl", document)
    assert obj.Mesh.CountFacets == scan_of(drilled()).CountFacets
    (tmp_path / "empty.stl").write_text("solid\nendsolid\n")
    with pytest.raises(InputError):
        import_part(tmp_path / "empty.stl", document)
