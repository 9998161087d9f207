# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measured files: clouds in every dialect, units, 3MF, FreeCAD documents."""

import importlib.util
import struct
import zipfile
from pathlib import Path

import numpy as np
import pytest

from gpswb.errors import InputError
from gpswb.io.cloud_file import parse_cloud
from gpswb.io.measured_file import read_measured

HAS_TRIMESH = importlib.util.find_spec("trimesh") is not None
TETRAHEDRON = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], dtype=float)
FACES = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]

DIALECTS = {
    "plain.xyz": "0 0 0\n1 0 0\n0 1 0\n0 0 1\n",
    "extra.asc": "# x y z intensity\n0 0 0 17\n1.0 0 0 3 // far\n0 1e0 0 5\n\n0 0 +1. 9\n",
    "count.pts": "4\n0 0 0 12 255 0 0\n1 0 0 12 255 0 0\n0 1 0 12 255 0 0\n0 0 1 12 255 0 0\n",
    "comma.csv": "X,Y,Z\r\n0,0,0\r\n1,0,0\r\n0,1,0\r\n0,0,1\r\n",
    "brackets.txt": "Points:=[\n[0, 0, 0],\n[1, 0, 0], \n[0, 1, 0],\n[0, 0, 1] \n ];",
}


@pytest.mark.parametrize("name", DIALECTS)
def test_dialects_agree(tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_text(DIALECTS[name], newline="")
    assert (parse_cloud(tmp_path / name) == TETRAHEDRON).all()


def test_cloud_becomes_a_mesh_with_a_point_map(tmp_path: Path) -> None:
    path = tmp_path / "cloud.xyz"
    path.write_text(DIALECTS["plain.xyz"] + "nan nan nan\n0 0 0\n")
    solid = read_measured(path, "inch")
    assert (solid.unit, solid.mesher) == ("inch", "advancing front")
    assert solid.mesh.areas.sum() == pytest.approx(25.4**2 * (1.5 + np.sqrt(3) / 2))
    assert solid.pointmap is not None
    vertex = solid.pointmap.vertex_of_point
    assert vertex[4] == -1
    assert vertex[5] == vertex[0]
    assert (solid.mesh.vertices[vertex[:4]] == 25.4 * TETRAHEDRON).all()
    assert solid.notes[:2] == (
        "1 points without finite coordinates left out",
        "1 of 5 points repeat others",
    )


def test_unit_not_stated_is_told(tmp_path: Path) -> None:
    path = tmp_path / "t.xyz"
    path.write_text(DIALECTS["plain.xyz"])
    solid = read_measured(path)
    assert solid.unit == "mm"
    assert "the file names no unit" in solid.notes[0]
    assert not any("names no unit" in note for note in read_measured(path, "mm").notes)


def test_ply_of_points_is_a_cloud(tmp_path: Path) -> None:
    path = tmp_path / "points.ply"
    head = ["ply", "format ascii 1.0", "element vertex 4"]
    head += [f"property float {axis}" for axis in "xyz"]
    rows = [" ".join(f"{x:g}" for x in p) for p in TETRAHEDRON]
    path.write_text("\n".join([*head, "end_header", *rows]) + "\n")
    if not HAS_TRIMESH:  # FreeCAD's Mesh module reads no points
        with pytest.raises(InputError, match="holds no triangles"):
            read_measured(path)
        return
    assert len(read_measured(path).mesh.triangles) == 4


@pytest.mark.parametrize(
    ("name", "content", "text"),
    [
        ("empty.xyz", "", "no line starts with three numbers"),
        ("words.txt", "hello\nworld\n", "no line starts with three numbers"),
        ("broken.xyz", "0 0 0\n1 0 0\n0 x 0\n", "not a readable point cloud"),
        ("short.xyz", "0 0 0\n1 0 0\n0 1\n", "not a readable point cloud"),
        ("nan.xyz", "nan nan nan\n" * 9, "0 different points"),
        ("two.xyz", "0 0 0\n1 0 0\n", "2 different points among 2"),
        ("equal.xyz", "1 2 3\n" * 1000, "1 different points among 1000"),
        ("huge.xyz", "1e300 0 0\n1 0 0\n0 1 0\n0 0 1\n", "an extent of 1e.300 mm is no part's"),
        ("tiny.xyz", "1e-300 0 0\n0 0 0\n0 1e-300 0\n0 0 1e-300\n", "--unit may be wrong"),
    ],
)
def test_bad_clouds_give_one_line(tmp_path: Path, name: str, content: str, text: str) -> None:
    (tmp_path / name).write_text(content)
    with pytest.raises(InputError, match=text) as error:
        read_measured(tmp_path / name)
    assert name in str(error.value)
    assert "\n" not in str(error.value)


def document(path: Path) -> None:
    """An FCStd document with a mesh in a container, as FreeCAD 0.20 writes it."""
    place = '<PropertyPlacement Px="{}" Py="0" Pz="0" Q0="0" Q1="0" Q2="{}" Q3="{}"/>'
    turned = place.format(10, np.sqrt(0.5), np.sqrt(0.5))  # a quarter turn about z
    prop = '<Property name="{}" type="{}">{}</Property>'
    mesh = prop.format("Mesh", "Mesh::PropertyMeshKernel", '<Mesh file="M.bms"/>')
    mesh += prop.format("Placement", "App::PropertyPlacement", turned)
    group = '<LinkList count="1"><Link value="M"/></LinkList>'
    box = prop.format("Group", "App::PropertyLinkList", group)
    box += prop.format("Placement", "App::PropertyPlacement", place.format(1000, 0, 1))
    objects = "".join(
        f'<Object name="{name}"><Properties>{text}</Properties></Object>'
        for name, text in (("M", mesh), ("Box", box))
    )
    data = struct.pack("<II256sII", 0xA0B0C0D0, 0x010000, b"", 4, 4)
    data += TETRAHEDRON.astype("<f4").tobytes()
    for face in FACES:
        data += struct.pack("<6I", *face, 0, 0, 0)
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("Document.xml", f"<D><ObjectData>{objects}</ObjectData></D>")
        archive.writestr("M.bms", data)


def test_mesh_of_a_freecad_document_stands_in_its_place(tmp_path: Path) -> None:
    path = tmp_path / "scan.FCStd"
    document(path)
    found = sorted(map(tuple, read_measured(path).mesh.vertices.round(6).tolist()))
    # x goes to y, y to -x; then 10 and 1000 along x.
    assert found == [(1009, 0, 0), (1010, 0, 0), (1010, 0, 1), (1010, 1, 0)]
    with pytest.raises(InputError, match="states that its unit is mm, not m"):
        read_measured(path, "m")


def test_a_document_whose_mesh_is_spoilt_gives_one_line(tmp_path: Path) -> None:
    path = tmp_path / "scan.FCStd"
    document(path)
    with zipfile.ZipFile(path) as archive:
        xml, data = archive.read("Document.xml"), archive.read("M.bms")
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("Document.xml", xml)
        # The first corner's index is beyond the points.
        archive.writestr("M.bms", data[: 272 + 48] + b"\x09" + data[272 + 49 :])
    with pytest.raises(InputError, match="triangles refer to vertices"):
        read_measured(path)


def test_truncated_document_gives_one_line(tmp_path: Path) -> None:
    path = tmp_path / "scan.FCStd"
    document(path)
    with zipfile.ZipFile(path) as archive:
        xml, data = archive.read("Document.xml"), archive.read("M.bms")
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("Document.xml", xml)
        archive.writestr("M.bms", data[:300])
    with pytest.raises(InputError, match="not a FreeCAD document that can be read"):
        read_measured(path)


MODEL = """<?xml version="1.0" encoding="UTF-8"?>
<model unit="inch" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
<resources><object id="1" type="model"><mesh><vertices>{}</vertices>
<triangles>{}</triangles></mesh></object></resources>
<build><item objectid="1"/><item objectid="1" transform="1 0 0 0 1 0 0 0 1 5 0 0"/></build></model>
"""
TYPES = """<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
"""


def test_3mf_brings_its_unit_and_places_its_items(tmp_path: Path) -> None:
    path = tmp_path / "two.3mf"
    vertices = "".join('<vertex x="{:g}" y="{:g}" z="{:g}"/>'.format(*p) for p in TETRAHEDRON)
    faces = "".join('<triangle v1="{}" v2="{}" v3="{}"/>'.format(*f) for f in FACES)
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("[Content_Types].xml", TYPES)
        archive.writestr("3D/3dmodel.model", MODEL.format(vertices, faces))
    if not HAS_TRIMESH:  # FreeCAD 0.20 can't read 3MF
        with pytest.raises(InputError, match="not a readable 3MF mesh"):
            read_measured(path)
        return
    solid = read_measured(path)
    assert solid.unit == "inch"
    assert len(solid.mesh.triangles) == 8
    assert np.ptp(solid.mesh.vertices, axis=0) == pytest.approx([6 * 25.4, 25.4, 25.4])
    assert "2 components, partitioned together" in solid.notes
    with pytest.raises(InputError, match="states that its unit is inch, not mm"):
        read_measured(path, "mm")
