# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's own segmentation of a mesh, as a partition that can be validated."""

from __future__ import annotations

import os
import signal
import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Literal

import numpy as np

from gpswb.cad.solid import Solid
from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import IntArray, Mesh
from gpswb.core.partition import Partition, Region

Call = Literal["planar", "type", "curvature"]

PYTHON = "/usr/bin/python3"
FREECAD = "/usr/lib/freecad-python3/lib"

WORDS: dict[InvarianceClass, str] = {
    "planar": "plane", "cylindrical": "cylinder", "spherical": "sphere",
}  # fmt: skip


def freecad_partition(
    solid: Solid, call: Call, distance: float, least: int, limit: float
) -> tuple[Partition, float] | None:
    """FreeCAD's segments of a solid's mesh and their CPU seconds; None after ``limit`` of them.

    Args:
        solid: with its face map, from which the radii for the call ``curvature`` are taken.
        call: ``getPlanarSegments``, ``getSegmentsOfType`` or ``getSegmentsByCurvature``.
        distance: tolerance of the first two, mm.
        least: facets that a segment has at least.

    Raises:
        ChildProcessError: FreeCAD failed.
    """
    mesh = solid.mesh
    with tempfile.TemporaryDirectory() as scratch:
        given, out = Path(scratch) / "mesh.npz", Path(scratch) / "segments.npz"
        np.savez(
            given, call=call, vertices=mesh.vertices, triangles=mesh.triangles,
            radii=true_radii(solid), distance=distance, least=least,
        )  # fmt: skip
        script = Path(__file__).with_name("freecad_segments.py")
        done = subprocess.run(
            [PYTHON, str(script), str(given), str(out), str(limit)],
            env={**os.environ, "PYTHONPATH": FREECAD},
            check=False,
            capture_output=True,
            text=True,
        )
        if done.returncode == -signal.SIGXCPU:
            return None
        if done.returncode or not out.exists():
            raise ChildProcessError(f"FreeCAD ended with {done.returncode}: {done.stderr[-300:]}")
        with np.load(out) as found:
            parts = np.split(found["facets"], np.cumsum(found["length"])[:-1])
            kinds, seconds = found["kind"].tolist(), float(found["seconds"])
    return partition_of_segments(mesh, list(zip(kinds, parts, strict=False))), seconds


def true_radii(solid: Solid) -> list[float]:
    """The different radii of a part's cylinders and spheres, mm, ascending."""
    assert solid.facemap is not None
    radii = [
        face.truth.parameters["radius"][0]
        for face in solid.facemap.faces
        if face.truth is not None and face.truth.surface in ("Cylinder", "Sphere")
    ]
    return np.unique(np.round(radii, 6)).tolist()  # the same radius, whatever the file rounds


def partition_of_segments(
    mesh: Mesh, segments: Sequence[tuple[InvarianceClass, IntArray]]
) -> Partition:
    """The segments as regions, each of the class that was asked for.

    Segments of different calls overlap: a facet goes to the largest of its segments, of equal ones
    to the first. A facet in no segment is in no region, so it counts as not recognised.
    """
    m, n = len(mesh.triangles), len(mesh.vertices)
    region = np.full(m, -1)
    # The stable sort and its reverse: the first of equals is written last.
    for i in sorted(range(len(segments)), key=lambda i: len(segments[i][1]), reverse=True)[::-1]:
        region[segments[i][1]] = i
    regions = []
    for i in np.unique(region[region >= 0]).tolist():
        own = region == i
        region[own] = len(regions)
        regions.append(_region(len(regions), segments[i][0], mesh, own))
    nothing = np.zeros(m, dtype=np.int64)
    return Partition(
        mesh, nothing, nothing, region, tuple(regions), np.zeros(n, dtype=np.int64), np.zeros(m),
        np.zeros(m), len(regions), 0, 0.0, "freecad", "freecad",
    )  # fmt: skip


def _region(id_: int, kind: InvarianceClass, mesh: Mesh, own: np.ndarray) -> Region:
    area, facets = float(mesh.areas[own].sum()), int(own.sum())
    return Region(id_, kind, area, facets, WORDS[kind], {}, {}, 0.0, np.inf, 1)
