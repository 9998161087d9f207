# SPDX-License-Identifier: LGPL-2.1-or-later
"""The verbs from a real part to the files they promise."""

import csv
import json
from pathlib import Path

import numpy as np
import pytest
from conftest import Command

from gpswb.core.invariance import CLASSES

FIGURES = {"area_accuracy", "face_accuracy", "region_f1", "confusion"}


@pytest.fixture(scope="module")
def partitioned(
    gpswb: Command, block_step: Path, tmp_path_factory: pytest.TempPathFactory
) -> tuple[str, Path]:
    out = tmp_path_factory.mktemp("out") / "deep" / "er"
    done = gpswb("partition", block_step, "--out", out, "--density", "coarse")
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout, out


def test_partition_writes_and_names_its_files(partitioned: tuple[str, Path]) -> None:
    said, out = partitioned
    names = {"result.json", "labels.npz", "mesh.ply", "faces.csv", "report.html"}
    assert {path.name for path in out.iterdir()} == names
    last = said.splitlines()[-1]
    assert all(str(out / name) in last for name in names)


def test_result_keeps_the_contract(partitioned: tuple[str, Path], block_step: Path) -> None:
    _, out = partitioned
    result = json.loads((out / "result.json").read_text("utf-8"))
    assert result["schema"] == "gpswb-result/1"
    assert result["source"]["path"] == str(block_step)
    assert result["mesh"]["density"] == "coarse"
    assert {"read", "tessellate"} <= set(result["timings_s"])
    assert [face["name"] for face in result["faces"]] == [f"Face{i}" for i in range(1, 8)]
    truths = [face["true_class"] for face in result["faces"]]
    assert sorted(truths) == ["cylindrical"] + ["planar"] * 6
    # 2 (20·10 + 30·10 + 30·20 − 16π) + 80π mm², from the sizes of the block.
    area = 2200 - 32 * np.pi + 80 * np.pi
    assert sum(face["area"] for face in result["faces"]) == pytest.approx(area)
    assert set(result["validation"]) >= FIGURES


def test_labels_belong_to_the_result(partitioned: tuple[str, Path]) -> None:
    _, out = partitioned
    result = json.loads((out / "result.json").read_text("utf-8"))
    with np.load(out / "labels.npz", allow_pickle=False) as labels:
        assert len(labels["triangles"]) == result["mesh"]["triangles"]
        counts = np.bincount(labels["face"], minlength=7)
        assert counts.tolist() == [face["triangles"] for face in result["faces"]]
        class_of = {r["id"]: CLASSES.index(r["class"]) for r in result["regions"]}
        assert all(
            class_of[r] == c
            for r, c in zip(labels["region"].tolist(), labels["class"].tolist(), strict=True)
            if r >= 0
        )


def test_failure_keeps_an_earlier_result(
    gpswb: Command, partitioned: tuple[str, Path], tmp_path: Path
) -> None:
    _, out = partitioned
    before = {path.name: path.read_bytes() for path in out.iterdir()}
    (tmp_path / "bad.step").write_text("nothing")
    assert gpswb("partition", tmp_path / "bad.step", "--out", out).returncode == 1
    assert {path.name: path.read_bytes() for path in out.iterdir()} == before


def test_mesh_input_has_no_faces(gpswb: Command, tmp_path: Path) -> None:
    points = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    rows = [f"3 {a} {b} {c}\n3 {a} {c} {d}" for a, b, c, d in quads]
    lines = ["OFF", "8 12 0", *(f"{x} {y} {z}" for x, y, z in points), *rows]
    (tmp_path / "cube.off").write_text("\n".join(lines) + "\n")
    done = gpswb("partition", tmp_path / "cube.off", "--out", tmp_path / "out", "--no-report")
    assert (done.returncode, done.stderr) == (0, "")
    assert "validation" not in done.stdout
    names = sorted(path.name for path in (tmp_path / "out").iterdir())
    assert names == ["labels.npz", "mesh.ply", "result.json"]
    assert json.loads((tmp_path / "out" / "result.json").read_text())["faces"] == []


def test_validate_goes_through_good_and_bad(
    gpswb: Command, block_step: Path, tmp_path: Path
) -> None:
    corpus = tmp_path / "corpus"
    (corpus / "sub").mkdir(parents=True)
    (corpus / "block.step").write_bytes(block_step.read_bytes())
    (corpus / "sub" / "block.step").write_bytes(block_step.read_bytes())
    (corpus / "bad.stp").write_text("nothing")
    (corpus / "readme.txt").write_text("no part")
    out, docs = tmp_path / "out", tmp_path / "validation.md"
    words = ["validate", corpus, "--out", out, "--density", "stl", "--docs", docs]
    done = gpswb(*words, cwd=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert "bad.stp: refused: not a STEP file" in done.stdout
    with (out / "summary.csv").open(newline="", encoding="utf-8") as file:
        rows = {row["file"]: row for row in csv.DictReader(file)}
    assert {name: row["status"] for name, row in rows.items()} == {
        "bad.stp": "refused",
        "block.step": "done",
        "block.step (2)": "done",
    }
    summary = json.loads((out / "summary.json").read_text("utf-8"))
    assert summary["schema"] == "gpswb-summary/1"
    assert summary["totals"]["judged"] == 2
    assert summary["totals"]["faces"] == 14
    for name in ("block.step", "block.step (2)"):
        result = json.loads((out / "parts" / name / "result.json").read_text("utf-8"))
        assert float(rows[name]["face_accuracy"]) == result["validation"]["face_accuracy"]
    text = docs.read_text("utf-8")
    assert "## density stl" in text
    assert "`gpswb validate corpus --density stl --out out --docs validation.md`" in text
    assert str(tmp_path) not in text


def test_noise_is_added_and_the_same_each_time(
    gpswb: Command, block_step: Path, tmp_path: Path
) -> None:
    vertices = []
    for name in ("one", "two"):
        out = tmp_path / name
        words = [
            "validate",
            block_step,
            "--out",
            out,
            "--density",
            "coarse",
            "--method",
            "curvature",
            "--no-cache",
        ]
        assert gpswb(*words, "--noise-added", "0.001").returncode == 0
        with np.load(out / "parts" / "block.step" / "labels.npz") as labels:
            vertices.append(labels["vertices"])
    assert np.array_equal(*vertices)
    # Vertices of the two faces at z = 0 and 10 scatter about them by 0.001 of the diagonal.
    z = vertices[0][:, 2]
    flat = np.minimum(np.abs(z), np.abs(z - 10))
    sigma = 0.001 * np.sqrt(30**2 + 20**2 + 10**2)
    near = flat < 5 * sigma
    assert np.sqrt((flat[near] ** 2).mean()) == pytest.approx(sigma, rel=0.15)


def test_sweep_measures_each_density(gpswb: Command, block_step: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    done = gpswb("sweep", block_step, "--densities", "stl,deflection=0.01,4,coarse", "--out", out)
    assert (done.returncode, done.stderr) == (0, "")
    with (out / "sweep.csv").open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [row["density"] for row in rows] == ["stl", "deflection=0.01,4", "coarse"]
    triangles = [int(row["triangles"]) for row in rows]
    assert triangles[0] < triangles[1]
    assert "<svg" in (out / "sweep.svg").read_text("utf-8")


def test_sweep_of_a_corpus_averages_its_parts(
    gpswb: Command, block_step: Path, tmp_path: Path
) -> None:
    (tmp_path / "corpus").mkdir()
    for name in ("a.step", "b.step"):
        (tmp_path / "corpus" / name).write_bytes(block_step.read_bytes())
    (tmp_path / "corpus" / "bad.step").write_text("nothing")
    rows = []
    for name, path in (("one", block_step), ("two", tmp_path / "corpus")):
        out = tmp_path / name
        words = ["sweep", path, "--densities", "stl", "--noise-added", "0,0.001", "--out", out]
        assert gpswb(*words, "--method", "curvature").returncode == 0
        with (out / "sweep.csv").open(newline="", encoding="utf-8") as file:
            rows.append(list(csv.DictReader(file)))
    assert [row["noise"] for row in rows[0]] == ["0.0", "0.001"]
    for one, two in zip(*rows, strict=True):
        assert (one["parts"], two["parts"]) == ("1", "2")
        assert int(two["triangles"]) == 2 * int(one["triangles"])
        for key in ("area_accuracy", "face_accuracy", "region_f1"):
            assert float(two[key]) == pytest.approx(float(one[key]))


def test_sweep_needs_faces_to_judge_by(gpswb: Command, tmp_path: Path) -> None:
    (tmp_path / "flat.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
    done = gpswb("sweep", tmp_path / "flat.off", "--densities", "stl")
    assert done.returncode == 1
    assert "no CAD faces to judge by" in done.stderr
