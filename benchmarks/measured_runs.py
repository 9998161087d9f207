# SPDX-License-Identifier: LGPL-2.1-or-later
"""One partition in a process of its own, with a limit on its time; what is kept of it."""

from __future__ import annotations

import json
import multiprocessing
import resource
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from gpswb.cad.solid import FaceMap
from gpswb.core.initial import unvoted_types
from gpswb.core.mesh import Mesh
from gpswb.core.pipeline import Method, partition
from gpswb.validation.face_result import facet_classes
from gpswb.validation.validate import validate

METHODS: tuple[Method, ...] = ("hybrid", "curvature", "slippage")


@dataclass(frozen=True, eq=False)
class Run:
    """What one partition gave.

    Args:
        facts: counts, CPU seconds, noise; accuracies where there is a face map.
        region, label, initial, shape, unvoted: (m,) of each facet: region, class, initial region,
            shape type after voting and before; -1 for none.
    """

    facts: dict[str, Any]
    region: np.ndarray
    label: np.ndarray
    initial: np.ndarray
    shape: np.ndarray
    unvoted: np.ndarray


def run(
    mesh: Mesh, facemap: FaceMap | None = None, method: Method = "hybrid", limit: float = 900.0
) -> Run | None:
    """Partition a mesh; None if that takes more than ``limit`` seconds of CPU time."""
    with tempfile.TemporaryDirectory() as scratch:
        out = Path(scratch) / "run.npz"
        child = multiprocessing.get_context("fork").Process(
            target=_work, args=(mesh, facemap, method, limit, out)
        )
        child.start()
        child.join()
        if not out.exists():
            return None
        with np.load(out, allow_pickle=False) as kept:
            arrays = {name: kept[name] for name in kept.files if name != "facts"}
            return Run(facts=json.loads(str(kept["facts"])), **arrays)


def _work(mesh: Mesh, facemap: FaceMap | None, method: Method, limit: float, out: Path) -> None:
    before = resource.getrusage(resource.RUSAGE_SELF).ru_utime
    resource.setrlimit(resource.RLIMIT_CPU, (int(limit), int(limit) + 5))
    result = partition(mesh, method=method)
    facts: dict[str, Any] = {
        "vertices": len(mesh.vertices),
        "triangles": len(mesh.triangles),
        "initial": result.initial_region_count,
        "sharp": result.sharp_edge_regions,
        "regions": len(result.regions),
        "sigma": result.sigma / mesh.diagonal,
        "seconds": resource.getrusage(resource.RUSAGE_SELF).ru_utime - before,
    }
    if facemap is not None:
        judged = validate(result, facemap)
        facts["area"] = judged.area_accuracy
        facts["face"] = judged.face_accuracy
        facts["f1"] = judged.region_f1
    draft = out.with_name("draft.npz")
    np.savez(
        draft,
        facts=json.dumps(facts),
        region=result.region,
        label=facet_classes(result),
        initial=result.initial_region,
        shape=result.shape_type,
        unvoted=unvoted_types(mesh, result.sigma),
    )
    draft.rename(out)
