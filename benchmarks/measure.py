# SPDX-License-Identifier: LGPL-2.1-or-later
"""One mesh in a process of its own: gpswb and libigl in turn, one thread, CPU seconds, as JSON.

``python benchmarks/measure.py MESH.npz ROUNDS``; with 0 rounds the modes of the paper instead.
"""

from __future__ import annotations

import os

# One thread, whatever the machine has: set before anything imports numpy.
os.environ.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", IGL_NUM_THREADS="1")

import contextlib
import json
import resource
import sys
from collections import defaultdict
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from unittest.mock import patch

import igl
import numpy as np
from meshes import about

from gpswb.core.curvature import estimate_curvature
from gpswb.core.mesh import Mesh
from gpswb.core.normals import wedge_normals
from gpswb.core.partition import Partition
from gpswb.core.pipeline import partition
from gpswb.core.sharp_edges import feature_edges
from gpswb.core.wedges import find_wedges

IOU = 0.8
"""A face is found if a region shares this much of the union of both, by area."""

ELEMENTARY = {
    "Plane": "plane",
    "Cylinder": "cylinder",
    "Cone": "cone",
    "Sphere": "sphere",
    "Torus": "torus",
}
"""CAD surfaces whose regions must be of the same kind, beside the same class."""


def cpu_seconds() -> float:
    """Of this process, user and system: a busy machine changes little."""
    use = resource.getrusage(resource.RUSAGE_SELF)
    return use.ru_utime + use.ru_stime


def timed(work: Callable[[], Any]) -> tuple[float, Any]:
    """CPU seconds of some work, and what it gave."""
    start = cpu_seconds()
    result = work()
    return cpu_seconds() - start, result


class Stages:
    """CPU seconds of each stage that the pipeline reports; what comes before the first is noise."""

    def __init__(self) -> None:
        self.spent: defaultdict[str, float] = defaultdict(float)
        self._stage, self._since = "noise", cpu_seconds()

    def __call__(self, name: str, fraction: float) -> None:
        now = cpu_seconds()
        self.spent[self._stage] += now - self._since
        self._stage, self._since = (name if fraction < 1.0 else "between stages"), now


class Pairs:
    """A merge rule that counts the pairs it is asked for."""

    def __init__(self, rule: Any, counts: dict[str, float]) -> None:
        self._rule, self._counts = rule, counts

    def score(self, first: Any, second: Any) -> Any:
        self._counts["pairs"] += len(first)
        return self._rule.score(first, second)

    def join(self, kept: int, gone: int) -> None:
        self._rule.join(kept, gone)


@contextlib.contextmanager
def counted_merging() -> Iterator[dict[str, float]]:
    """Count the pairs that merging scores, and its CPU seconds, wherever the core calls it."""
    from gpswb.core import merging

    original, counts = merging.merge_regions, {"pairs": 0, "seconds": 0.0}

    def merge(count: int, pairs: Any, rule: Any, least: float) -> Any:
        seconds, result = timed(lambda: original(count, pairs, Pairs(rule, counts), least))
        counts["seconds"] += seconds
        return result

    with contextlib.ExitStack() as stack:
        for name, module in list(sys.modules.items()):
            if name.startswith("gpswb.core.") and hasattr(module, "merge_regions"):
                stack.enter_context(patch.object(module, "merge_regions", merge))
        yield counts


def resident(field: str) -> int:
    """Bytes of a field of /proc/self/status: VmRSS, or VmHWM, its peak."""
    for line in Path("/proc/self/status").read_text().splitlines():
        if line.startswith(field + ":"):
            return int(line.split()[1]) * 1024
    raise ValueError(field)


def measure(path: Path, rounds: int) -> dict[str, Any]:
    """Everything that this process measures of one mesh."""
    with np.load(path) as stored:
        vertices, triangles, face = (stored[k] for k in ("vertices", "triangles", "face"))
    partition(Mesh(*cube()))  # imports and compilation are not counted
    igl.principal_curvature(*cube())
    runs: list[dict[str, float]] = []
    stages: list[dict[str, float]] = []
    memory = 0
    for number in range(rounds):
        mesh = Mesh(vertices, triangles)
        if number == 0:
            before = resident("VmRSS")
            Path("/proc/self/clear_refs").write_text("5")  # the peak begins anew
        clock = Stages()
        seconds, result = timed(lambda m=mesh, c=clock: partition(m, progress=c))
        if number == 0:
            memory = resident("VmHWM") - before
        stages.append(dict(clock.spent))
        likelihoods, _ = timed(lambda r=result: [dict(x.log_likelihood) for x in r.regions])
        own, _ = timed(lambda: curvature_alone(vertices, triangles))
        peer, _ = timed(lambda: igl.principal_curvature(vertices, triangles))
        runs.append(
            {
                "whole": seconds,
                "likelihoods": likelihoods,
                "curvature alone": own,
                "libigl": peer,
            }
        )
    said = about(path)
    return {
        "vertices": len(vertices),
        "triangles": len(triangles),
        "mesher": said["mesher"],
        "tessellation_cpu_s": said["cpu_s"],
        "runs": runs,
        "stages": {k: float(np.median([s.get(k, 0.0) for s in stages])) for k in stages[0]},
        "memory_a_vertex": memory / len(vertices),
        "faces": len(said["classes"]),
        "found": found(result, face, said),
        "regions": len(result.regions),
    }


def curvature_alone(vertices: Any, triangles: Any) -> Any:
    """Normals and principal curvatures, from a mesh of which nothing is known yet."""
    mesh = Mesh(vertices, triangles)
    wedges = find_wedges(mesh, feature_edges(mesh))
    return estimate_curvature(mesh, wedges, wedge_normals(mesh, wedges))


def other_modes(path: Path) -> dict[str, float]:
    """CPU seconds of the modes of the paper, and pairs and seconds of merging in ``corrected``."""
    with np.load(path) as stored:
        vertices, triangles = stored["vertices"], stored["triangles"]
    paper, _ = timed(lambda: partition(Mesh(vertices, triangles), mode="paper"))
    with counted_merging() as counts:
        corrected, _ = timed(lambda: partition(Mesh(vertices, triangles), mode="corrected"))
    return {"paper": paper, "corrected": corrected, **counts}


def found(result: Partition, face: Any, said: dict[str, Any]) -> int:
    """Faces that a region covers, and that the region names rightly: class and kind of surface."""
    areas = result.mesh.areas
    count, regions = len(said["classes"]), len(result.regions)
    both = (face >= 0) & (result.region >= 0)
    pair = face[both] * regions + result.region[both]
    shared = np.bincount(pair, areas[both], minlength=count * regions).reshape(count, regions)
    of_face = np.bincount(face[face >= 0], areas[face >= 0], minlength=count)
    in_region = result.region >= 0
    of_region = np.bincount(result.region[in_region], areas[in_region], minlength=regions)
    overlap = shared / (of_face[:, None] + of_region - shared)
    right = 0
    for i, best in enumerate(overlap.argmax(axis=1)):
        region = result.regions[best]
        kind = ELEMENTARY.get(said["surfaces"][i], region.surface)
        named = region.invariance_class == said["classes"][i] and region.surface == kind
        right += bool(overlap[i, best] >= IOU and named)
    return right


def cube() -> tuple[Any, Any]:
    """A small mesh: 8 vertices, 12 triangles."""
    vertices = np.array([(x, y, z) for x in (0.0, 1) for y in (0.0, 1) for z in (0.0, 1)])
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])
    return vertices, triangles.astype(np.int64)


if __name__ == "__main__":
    mesh, rounds = Path(sys.argv[1]), int(sys.argv[2])
    print(json.dumps(measure(mesh, rounds) if rounds else other_modes(mesh)))
