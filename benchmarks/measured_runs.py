# SPDX-License-Identifier: LGPL-2.1-or-later
"""One partition in a process of its own, with a limit on its time; what is kept of it."""

from __future__ import annotations

import hashlib
import json
import multiprocessing
import resource
import signal
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import gpswb
from gpswb.batch.one_part import partition_solid
from gpswb.batch.settings import Settings
from gpswb.cad.density import Density
from gpswb.cad.solid import Solid
from gpswb.core.initial import unvoted_types
from gpswb.core.invariance import CLASSES
from gpswb.core.pipeline import Method, Mode
from gpswb.scan.point_regions import region_of_points
from gpswb.validation.face_result import facet_classes
from gpswb.validation.validate import validate

KEPT = Path(__file__).resolve().parents[1] / "build" / "measured"

METHODS: tuple[Method, ...] = ("hybrid", "curvature", "slippage")


@dataclass(frozen=True, eq=False)
class Run:
    """What one partition gave.

    Args:
        facts: counts, CPU seconds, noise; accuracies where there is a face map.
        region, label, initial, shape, unvoted: (m,) of each facet: region, class, initial region,
            shape type after voting and before; -1 for none.
        vertex_label: (n,) class of each vertex, of its region.
    """

    facts: dict[str, Any]
    region: np.ndarray
    label: np.ndarray
    initial: np.ndarray
    shape: np.ndarray
    unvoted: np.ndarray
    vertex_label: np.ndarray


def run(
    solid: Solid, method: Method = "hybrid", limit: float = 300.0, mode: Mode = "robust"
) -> Run | None:
    """Partition a solid; None if that takes more than ``limit`` seconds of CPU time.

    What the same code made of the same mesh before is taken from build/measured, so that a run that
    was cut short goes on where it stopped.

    Raises:
        ChildProcessError: the partition ended in another way, which is not kept.
    """
    KEPT.mkdir(parents=True, exist_ok=True)
    out = KEPT / f"{_key(solid, mode, method, limit)}.npz"
    if not out.exists():
        child = multiprocessing.get_context("fork").Process(
            target=_work, args=(solid, mode, method, limit, out)
        )
        child.start()
        child.join()
        if child.exitcode == -signal.SIGXCPU:
            np.savez(out, facts="null")
        elif not out.exists():
            raise ChildProcessError(f"{mode} {method} ended with {child.exitcode}")
    with np.load(out, allow_pickle=False) as kept:
        arrays = {name: kept[name] for name in kept.files if name != "facts"}
        facts = json.loads(str(kept["facts"]))
    print(f"  {len(solid.mesh.triangles)} triangles, {mode} {method}: {facts}", flush=True)
    return Run(facts=facts, **arrays) if facts else None


def _code() -> bytes:
    """Digest of the code that partitions."""
    said = hashlib.sha256()
    package = Path(gpswb.__file__).parent
    for path in sorted([*package.glob("core/**/*.py"), *package.glob("scan/*.py")]):
        said.update(path.read_bytes())
    return said.digest()


CODE = _code()
"""Taken once, as the code is: it may change on disk while a long run goes on."""


def _key(solid: Solid, mode: Mode, method: Method, limit: float) -> str:
    """Name of a run: of the code that partitions, the mesh and the options."""
    said = hashlib.sha256(f"{mode} {method} {limit} {solid.pointmap is not None}".encode())
    said.update(CODE)
    said.update(solid.mesh.vertices.tobytes())
    said.update(solid.mesh.triangles.tobytes())
    return said.hexdigest()[:24]


def _work(solid: Solid, mode: Mode, method: Method, limit: float, out: Path) -> None:
    before = resource.getrusage(resource.RUSAGE_SELF).ru_utime
    resource.setrlimit(resource.RLIMIT_CPU, (int(limit), int(limit) + 5))
    mesh = solid.mesh
    _, result = partition_solid(solid, Settings(Density("auto"), mode, method, "ocp"))
    facts: dict[str, Any] = {
        "vertices": len(mesh.vertices),
        "triangles": len(mesh.triangles),
        "initial": result.initial_region_count,
        "sharp": result.sharp_edge_regions,
        "regions": len(result.regions),
        "sigma": result.sigma / mesh.diagonal,
        "seconds": resource.getrusage(resource.RUSAGE_SELF).ru_utime - before,
    }
    if solid.facemap is not None:
        judged = validate(result, solid.facemap)
        facts["area"] = judged.area_accuracy
        facts["face"] = judged.face_accuracy
        facts["f1"] = judged.region_f1
    classes = [CLASSES.index(region.invariance_class) for region in result.regions]
    vertex = region_of_points(result, np.arange(len(mesh.vertices)))
    draft = out.with_suffix(".draft.npz")
    np.savez(
        draft,
        facts=json.dumps(facts),
        region=result.region,
        label=facet_classes(result),
        initial=result.initial_region,
        shape=result.shape_type,
        unvoted=unvoted_types(mesh, result.sigma),
        vertex_label=np.array([*classes, -1])[vertex],
    )
    draft.rename(out)
