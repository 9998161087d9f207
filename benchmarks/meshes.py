# SPDX-License-Identifier: LGPL-2.1-or-later
"""The meshes that speed is measured on, made once and kept in build/benchmarks."""

from __future__ import annotations

import hashlib
import json
import resource
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
BUILD = ROOT / "build" / "benchmarks"

NOISE = 0.03
"""Standard deviation of the noisy case's vertices, of the mean edge length."""

DENSITIES = {
    "10k": "vertices=10000",
    "100k": "vertices=100000",
    "1M": "vertices=1000000",
    "stl": "stl",
}
"""The cases by their tessellation; the case ``noise`` is 100k with noise."""


def mesh_file(case: str) -> Path:
    """The mesh of a case as npz: made if it is not there, or was made by other code.

    It holds ``vertices`` (n, 3) mm, ``triangles`` (m, 3), ``face`` (m,), and ``about``: JSON with
    the faces' true classes, surfaces and features, and what the tessellation cost.
    """
    made_by = [*sorted((ROOT / "gpswb" / "cad").glob("*.py"))]
    made_by += [ROOT / "examples" / "parts" / "benchmark_part.py", Path(__file__)]
    mark = hashlib.sha256(b"".join(path.read_bytes() for path in made_by)).hexdigest()[:12]
    path = BUILD / f"{case}-{mark}.npz"
    if not path.exists():
        BUILD.mkdir(parents=True, exist_ok=True)
        arrays = _noisy() if case == "noise" else _tessellated(DENSITIES[case])
        draft = path.with_suffix(".draft.npz")
        np.savez(draft, **arrays)
        draft.rename(path)
    return path


def about(path: Path) -> dict[str, Any]:
    """What a mesh file says of itself."""
    with np.load(path) as stored:
        said: dict[str, Any] = json.loads(str(stored["about"]))
    return said


def _tessellated(density: str) -> dict[str, Any]:
    from gpswb.cad.density import Density
    from gpswb.cad.read import read_solid

    words = [sys.executable, str(ROOT / "examples" / "build.py"), "--out", str(BUILD)]
    subprocess.run([*words, "benchmark_part"], check=True, stdout=subprocess.DEVNULL)
    wall, cpu = time.perf_counter(), _cpu_seconds()
    solid = read_solid(BUILD / "benchmark_part.step", Density.parse(density))
    facemap = solid.facemap
    assert facemap is not None
    said = {
        "mesher": solid.mesher,
        "wall_s": time.perf_counter() - wall,
        "cpu_s": _cpu_seconds() - cpu,
        "classes": [face.truth.nominal if face.truth else None for face in facemap.faces],
        "surfaces": [face.truth.surface if face.truth else None for face in facemap.faces],
        "features": facemap.feature_of_face.tolist(),
    }
    return {
        "vertices": solid.mesh.vertices,
        "triangles": solid.mesh.triangles,
        "face": facemap.face_of_triangle,
        "about": json.dumps(said),
    }


def _noisy() -> dict[str, Any]:
    with np.load(mesh_file("100k")) as stored:
        arrays = dict(stored)
    corners = arrays["vertices"][arrays["triangles"]]
    edge = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2).mean()
    random = np.random.default_rng(18183)
    arrays["vertices"] += random.normal(0.0, NOISE * edge, arrays["vertices"].shape)
    return arrays


def _cpu_seconds() -> float:
    each = [resource.getrusage(w) for w in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(use.ru_utime + use.ru_stime for use in each)
