# SPDX-License-Identifier: LGPL-2.1-or-later
"""A simulated scan of a block with a hole, from the cloud's file to the class of every point."""

import json
from pathlib import Path

import numpy as np
import pytest
from conftest import Command
from parts.simulated_scan import Scanner, SimulatedScan, simulate

from gpswb.cad.density import Density
from gpswb.cad.read import read_solid
from gpswb.validation.nominal import nominal_samples

SCANNER = Scanner(points=4000, noise=0.01, gaps=2, gap_radius=1.0, outliers=0.01)


@pytest.fixture(scope="module")
def scanned(block_step: Path) -> tuple[SimulatedScan, np.ndarray]:
    """The scan, and the distance of each point to the part's exact surfaces."""
    solid = read_solid(block_step, Density.parse("deflection=0.002"))
    scan = simulate(solid, SCANNER)
    return scan, nominal_samples(solid).nearest_face(scan.points)[1]


def test_the_scan_is_as_bad_as_asked(scanned: tuple[SimulatedScan, np.ndarray]) -> None:
    scan, distance = scanned
    real = scan.label >= 0
    assert (~real).sum() == 40
    assert 3500 < real.sum() < 4000  # two gaps are cut out
    # n deviates give sigma within 3 σ/√(2n); chords of 2 µm shift the hole's little.
    assert distance[real].std() == pytest.approx(0.01, rel=0.05)
    assert np.abs(distance[~real]).mean() > 0.2


def test_partition_of_the_cloud(
    gpswb: Command, scanned: tuple[SimulatedScan, np.ndarray], tmp_path: Path
) -> None:
    scan, _ = scanned
    np.savetxt(tmp_path / "cloud.xyz", scan.points, fmt="%.5f")
    done = gpswb("partition", tmp_path / "cloud.xyz", "--unit", "mm", "--out", tmp_path / "out")
    assert (done.returncode, done.stderr) == (0, "")
    result = json.loads((tmp_path / "out" / "result.json").read_text("utf-8"))
    assert any("set aside as outliers" in note for note in result["notes"])
    assert result["settings"]["sigma"] == pytest.approx(0.01, rel=0.3)
    with np.load(tmp_path / "out" / "labels.npz", allow_pickle=False) as labels:
        assert labels["point"] == pytest.approx(scan.points, abs=1e-5)
        found = labels["point_class"]
    real = scan.label >= 0
    assert (found[real] == scan.label[real]).mean() > 0.95
    assert (found[~real] < 0).mean() > 0.5  # the others lie near the surface by chance
    assert (found[real] < 0).mean() < 0.002
