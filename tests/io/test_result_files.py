# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is written can be read back, and says what the contract says (design, section 10)."""

import csv
import json
from pathlib import Path

import numpy as np
from made_parts import put_together, row_of_squares, solid_of, truth

from gpswb.core.invariance import CLASSES
from gpswb.io.colours import SAFE, WHEEL
from gpswb.io.faces_csv import write_faces
from gpswb.io.labels_npz import write_labels
from gpswb.io.ply import write_ply
from gpswb.io.result_json import result_document, write_result
from gpswb.validation.validate import validate


def part() -> tuple:
    return put_together(
        row_of_squares(3),
        [truth("planar"), truth("cylindrical", "Cylinder"), None],
        [0, 1, -1],
        ["planar", "cylindrical"],
    )


def test_result_json_holds_the_contract(tmp_path: Path) -> None:
    partition, facemap = part()
    solid = solid_of(partition.mesh, facemap)
    document = result_document(solid, partition, validate(partition, facemap))
    write_result(tmp_path / "result.json", document)
    read = json.loads((tmp_path / "result.json").read_text("utf-8"))
    assert read == document
    assert read["schema"] == "gpswb-result/1"
    assert read["source"] == {"path": "part.step", "sha256": "0" * 64, "unit": "mm"}
    assert read["mesh"] == {
        "vertices": 8,
        "triangles": 6,
        "density": "stl",
        "mesher": "brepmesh",
    }
    assert read["timings_s"] == {"read": 1.0, "recognise": 0.25}
    region = read["regions"][1]
    assert (region["id"], region["class"], region["faces"]) == (1, "cylindrical", ["Face2"])
    assert region["intrinsic"] == {"radius": 5.0}
    assert set(region["log_likelihood"]) == set(CLASSES)
    assert region["margin"] is None  # infinite: JSON has no such number
    face = read["faces"][1]
    assert (face["name"], face["class"], face["true_class"]) == (
        "Face2",
        "cylindrical",
        "cylindrical",
    )
    assert (face["share"], face["triangles"], face["regions"]) == (1.0, 2, [1])
    assert read["faces"][2]["class"] is None
    assert read["validation"]["area_accuracy"] == 1.0
    assert read["validation"]["confusion"]["planar"]["planar"] == 1


def test_mesh_input_has_no_faces() -> None:
    partition, _ = part()
    document = result_document(solid_of(partition.mesh, None, "part.stl"), partition, None)
    assert (document["faces"], document["validation"]) == ([], None)


def test_labels_round_trip(tmp_path: Path) -> None:
    partition, facemap = part()
    write_labels(tmp_path / "labels.npz", partition, facemap)
    with np.load(tmp_path / "labels.npz", allow_pickle=False) as labels:
        assert np.array_equal(labels["vertices"], partition.mesh.vertices)
        assert np.array_equal(labels["triangles"], partition.mesh.triangles)
        assert labels["region"].tolist() == [0, 0, 1, 1, -1, -1]
        assert labels["class"].tolist() == [0, 0, 1, 1, -1, -1]
        assert labels["face"].tolist() == [0, 0, 1, 1, 2, 2]


def test_labels_of_a_mesh_name_no_face(tmp_path: Path) -> None:
    partition, _ = part()
    write_labels(tmp_path / "labels.npz", partition, None)
    with np.load(tmp_path / "labels.npz") as labels:
        assert labels["face"].tolist() == [-1] * 6


def test_ply_holds_the_mesh_and_its_labels(tmp_path: Path) -> None:
    partition, _ = part()
    write_ply(tmp_path / "mesh.ply", partition)
    head, body = (tmp_path / "mesh.ply").read_bytes().split(b"end_header\n", 1)
    lines = head.decode("ascii").splitlines()
    assert lines[:2] == ["ply", "format binary_little_endian 1.0"]
    assert {"element vertex 8", "element face 6"} <= set(lines)
    vertices = np.frombuffer(body[: 8 * 24], "<f8").reshape(8, 3)
    assert np.array_equal(vertices, partition.mesh.vertices)
    row = np.dtype([("n", "u1"), ("v", "<i4", 3), ("rgb", "u1", 3), ("c", "i1"), ("r", "<i4")])
    facets = np.frombuffer(body[8 * 24 :], row)
    assert np.array_equal(facets["v"], partition.mesh.triangles)
    assert facets["c"].tolist() == facets["r"].tolist() == [0, 0, 1, 1, -1, -1]
    assert tuple(facets["rgb"][0]) == WHEEL["planar"]


def test_faces_csv(tmp_path: Path) -> None:
    partition, facemap = part()
    write_faces(tmp_path / "faces.csv", validate(partition, facemap).faces)
    with (tmp_path / "faces.csv").open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [row["face"] for row in rows] == ["Face1", "Face2", "Face3"]
    assert [row["agrees"] for row in rows] == ["yes", "yes", ""]
    assert (rows[1]["class"], rows[1]["regions"], float(rows[1]["share"])) == (
        "cylindrical",
        "1",
        1.0,
    )


def test_both_palettes_colour_every_class_differently() -> None:
    for palette in (WHEEL, SAFE):
        assert set(palette) == set(CLASSES)
        colours = np.array(list(palette.values()), dtype=float)
        apart = np.linalg.norm(colours[:, None] - colours[None], axis=2) + 1e3 * np.eye(7)
        assert apart.min() > 60
