# SPDX-License-Identifier: LGPL-2.1-or-later
"""``gpswb compare`` from files to files."""

import csv
import json
from pathlib import Path

import numpy as np
import pytest
from conftest import Command

from gpswb.cad.density import Density
from gpswb.cad.read import read_solid
from gpswb.validation.alignment import placement


@pytest.fixture(scope="module")
def scan(block_step: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The block with a hole, elsewhere, its top raised to an arch of 0.03 mm; in metres."""
    mesh = read_solid(block_step, Density.parse("edge=1.4")).mesh
    points = mesh.vertices.copy()
    top = points[:, 2] == 10
    points[top, 2] += 0.03 * (points[top, 0] / 15 - 1) ** 2
    away = np.linalg.inv(placement([5, -3, 2, 4, -3, 5]))
    points = (points @ away[:3, :3].T + away[:3, 3]) / 1000
    path = tmp_path_factory.mktemp("scan") / "scan.off"
    rows = [" ".join(f"{x:.12g}" for x in p) for p in points]
    facets = ["3 {} {} {}".format(*t) for t in mesh.triangles]
    head = f"OFF\n{len(rows)} {len(facets)} 0\n"
    path.write_text(head + "\n".join([*rows, *facets]) + "\n")
    return path


def test_compare_measures_what_was_made(
    gpswb: Command, block_step: Path, scan: Path, tmp_path: Path
) -> None:
    options = ("--unit", "m", "--place", "4.7,-2.8,2.1,3,-2,4", "--out", tmp_path / "out")
    done = gpswb("compare", scan, block_step, *options)
    assert (done.returncode, done.stderr) == (0, "")
    names = {"comparison.json", "comparison.csv", "result.json", "labels.npz", "report.html"}
    assert {path.name for path in (tmp_path / "out").iterdir()} == names
    said = json.loads((tmp_path / "out" / "comparison.json").read_text("utf-8"))
    assert said["schema"] == "gpswb-comparison/1"
    assert said["alignment"]["paired"] == 1.0
    assert said["rms"] < 0.02
    with (tmp_path / "out" / "comparison.csv").open(newline="") as file:
        rows = {row["form"]: row for row in csv.DictReader(file) if float(row["minimax"]) > 0.01}
    # Only the top is not flat. The outermost extracted points lie up to two edges inside its ends,
    # where the arch of 0.03 mm is (1 - 2 · 1.4/15)² = 0.66 as high.
    assert list(rows) == ["flatness"]
    assert 0.66 * 0.03 < float(rows["flatness"]["minimax"]) < 0.0301
    assert sum(feature["kind"] == "cylinder" for feature in said["features"]) == 1
    page = (tmp_path / "out" / "report.html").read_text("utf-8")
    assert "flatness" in page
    assert page.count("data:image/png") == 4


def test_a_scan_elsewhere_is_one_line(
    gpswb: Command, block_step: Path, scan: Path, tmp_path: Path
) -> None:
    options = ("--unit", "m", "--place", "900,0,0", "--out", tmp_path / "out")
    done = gpswb("compare", scan, block_step, *options)
    assert done.returncode == 1
    assert "place it roughly" in done.stderr
    assert done.stderr.count("\n") == 1
    assert not (tmp_path / "out").exists()
