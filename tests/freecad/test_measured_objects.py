# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's Mesh and Points objects: from a document in memory and from its file."""

from pathlib import Path

import FreeCAD
import Mesh
import numpy as np
import Points
import pytest

from gpswb.errors import InputError
from gpswb.io.measured_file import read_measured, read_object

CORNERS = [(0, 0, 0), (4, 0, 0), (0, 4, 0), (0, 0, 4)]
FACETS = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]


@pytest.fixture
def document(tmp_path: Path) -> FreeCAD.Document:
    opened = FreeCAD.newDocument("measured")
    box = opened.addObject("App::Part", "Box")
    box.Placement.Base = FreeCAD.Vector(1000, 0, 0)
    turned = FreeCAD.Placement(
        FreeCAD.Vector(0, 0, 10), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 90)
    )
    mesh = opened.addObject("Mesh::Feature", "Scan")
    mesh.Mesh = Mesh.Mesh([[CORNERS[i] for i in facet] for facet in FACETS])
    mesh.Placement = turned
    box.addObject(mesh)
    cloud = opened.addObject("Points::Feature", "Cloud")
    cloud.Points = Points.Points([FreeCAD.Vector(*p) for p in CORNERS])
    cloud.Placement = turned
    opened.recompute()
    yield opened
    FreeCAD.closeDocument(opened.Name)


def corners(vertices: np.ndarray) -> list:
    return sorted(map(tuple, (vertices.round(5) + 0.0).tolist()))


# A quarter turn about z takes x to y and y to -x; then 10 up.
TURNED = sorted([(0, 0, 10), (0, 4, 10), (-4, 0, 10), (0, 0, 14)])


def test_a_mesh_stands_where_its_container_puts_it(document: FreeCAD.Document) -> None:
    solid = read_object(document.Scan)
    assert corners(solid.mesh.vertices) == sorted((x + 1000, y, z) for x, y, z in TURNED)
    assert solid.unit == "mm"
    assert solid.pointmap is None


def test_points_become_a_mesh(document: FreeCAD.Document) -> None:
    solid = read_object(document.Cloud)
    assert corners(solid.mesh.vertices) == TURNED
    assert len(solid.mesh.triangles) == 4
    assert solid.pointmap is not None


def test_the_saved_document_gives_the_same(document: FreeCAD.Document, tmp_path: Path) -> None:
    document.removeObject("Cloud")
    document.saveAs(str(tmp_path / "scan.FCStd"))
    stored = read_measured(tmp_path / "scan.FCStd")
    assert corners(stored.mesh.vertices) == corners(read_object(document.Scan).mesh.vertices)


def test_saved_points_give_the_same(document: FreeCAD.Document, tmp_path: Path) -> None:
    document.removeObject("Scan")
    document.saveAs(str(tmp_path / "cloud.FCStd"))
    stored = read_measured(tmp_path / "cloud.FCStd")
    assert corners(stored.mesh.vertices) == TURNED


def test_another_object_is_refused(document: FreeCAD.Document) -> None:
    with pytest.raises(InputError, match="neither a mesh nor points"):
        read_object(document.Box)
