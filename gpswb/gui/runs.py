# SPDX-License-Identifier: LGPL-2.1-or-later
"""What runs in a process of its own, so that the window stays alive and a crash is survived."""

from __future__ import annotations

import dataclasses
import tempfile
from pathlib import Path
from typing import Any

from gpswb.batch.one_part import examine
from gpswb.batch.settings import Settings
from gpswb.cad.density import Density
from gpswb.cad.isolate import IsolatedJob, job_progress
from gpswb.cad.read import read_solid
from gpswb.io.labels_npz import write_labels
from gpswb.io.result_json import result_document


class Run:
    """A job on a shape: see `IsolatedJob`, which it is made of.

    Args:
        job: name of a function of this module, whose first arguments are a directory and a label.
        shape: a FreeCAD shape.
        label: what to call it in results and errors.
        args: what else the function takes.
    """

    def __init__(self, job: str, shape: Any, label: str, *args: Any) -> None:
        self._folder = tempfile.TemporaryDirectory(prefix="gpswb-run-")
        self.folder = Path(self._folder.name)
        shape.exportBrep(str(self.folder / "shape.brep"))
        self._job = IsolatedJob(f"{__name__}:{job}", [str(self.folder), label, *args])

    @property
    def running(self) -> bool:
        """Whether it is still at work."""
        return self._job.running

    @property
    def progress(self) -> tuple[str, float] | None:
        """Stage, and share of it that is done; None before the first."""
        return self._job.progress

    def result(self) -> Any:
        """Wait for what the function returned; what it wrote is in ``folder`` until `close`.

        Raises:
            GpswbError: it failed, or its process died.
        """
        return self._job.result()

    def close(self) -> None:
        """End it if it still runs, and remove all that it wrote."""
        self._job.close()
        self._folder.cleanup()


def partition_shape(folder: str, label: str, density: str, mode: str) -> dict[str, Any]:
    """Job: partition ``shape.brep``; leaves ``labels.npz`` and returns the result's document."""
    tell = job_progress()
    outcome = examine(Path(folder, "shape.brep"), _settings(density, mode), tell)
    tell("store", 0.0)
    write_labels(Path(folder, "labels.npz"), outcome.partition, outcome.solid.facemap)
    solid = dataclasses.replace(outcome.solid, source=label)
    return result_document(solid, outcome.partition, outcome.validation)


def count_triangles(folder: str, label: str, density: str) -> dict[str, Any]:
    """Job: mesh ``shape.brep`` as a run would, and say how many triangles that makes, by what."""
    solid = read_solid(Path(folder, "shape.brep"), Density.parse(density), "freecad")
    return {"triangles": len(solid.mesh.triangles), "mesher": solid.mesher}


def sweep_densities(
    folder: str, label: str, densities: list[str], mode: str
) -> list[dict[str, Any]]:
    """Job: partition at each density; a row of figures each."""
    tell = job_progress()
    rows = []
    for i, density in enumerate(densities):
        tell(density, i / len(densities))
        outcome = examine(Path(folder, "shape.brep"), _settings(density, mode))
        result, judged = outcome.partition, outcome.validation
        assert judged is not None
        seconds = sum([*outcome.solid.timings.values(), *result.timings.values()])
        rows.append(
            {
                "density": density,
                "triangles": len(result.mesh.triangles),
                "initial_regions": result.initial_region_count,
                "regions": len(result.regions),
                "area_accuracy": judged.area_accuracy,
                "face_accuracy": judged.face_accuracy,
                "region_f1": judged.region_f1,
                "seconds": round(seconds, 3),
            }
        )
    return rows


def _settings(density: str, mode: str) -> Settings:
    return Settings(Density.parse(density), mode, "hybrid", "freecad")  # type: ignore[arg-type]
