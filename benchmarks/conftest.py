# SPDX-License-Identifier: LGPL-2.1-or-later
"""The benchmark part, built once, and what its stages leave for one another."""

import os
import subprocess
import sys
from pathlib import Path

# One thread, whatever the machine has: set before anything imports numpy.
os.environ.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")

import pytest
from stages import Run

VERTICES = (10_000, 100_000)


@pytest.fixture(scope="session")
def part(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("part")
    build = Path(__file__).resolve().parents[1] / "examples" / "build.py"
    subprocess.run([sys.executable, str(build), "--out", str(out), "benchmark_part"], check=True)
    return out / "benchmark_part.step"


@pytest.fixture(scope="session", params=VERTICES, ids=lambda n: f"{n // 1000}k")
def run(
    request: pytest.FixtureRequest, part: Path, tmp_path_factory: pytest.TempPathFactory
) -> Run:
    return Run(part, request.param, tmp_path_factory.mktemp("results"))
