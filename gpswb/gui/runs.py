# SPDX-License-Identifier: LGPL-2.1-or-later
"""What runs in a process of its own, so that the window stays alive and a crash is survived."""

from __future__ import annotations

import dataclasses
import json
import shutil
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

from gpswb.batch.one_part import Outcome, Progress, examine, partition_solid
from gpswb.batch.settings import Settings
from gpswb.cad.density import Density
from gpswb.cad.freecad_measured import is_measurement, measurement_of
from gpswb.cad.isolate import IsolatedJob, job_progress
from gpswb.cad.read import read_solid
from gpswb.gui.overrides import apply_overrides, from_json, regions_from_json, regions_to_json
from gpswb.gui.partition_result import read_run
from gpswb.io.labels_npz import write_labels
from gpswb.io.measured_file import read_stored_measurement, write_measurement
from gpswb.io.result_json import result_document

_SHAPE, _MEASURED, _LABELS, _RESULT = "shape.brep", "measured.npz", "labels.npz", "result.json"


class Run:
    """A job on a part: see `IsolatedJob`, which it is made of.

    Args:
        job: name of a function of this module, whose first arguments are a directory and a label.
        source: a document object with a shape, a mesh or points; or a partition with a result.
        args: what else the function takes.
    """

    def __init__(self, job: str, source: Any, *args: Any) -> None:
        self._folder = tempfile.TemporaryDirectory(prefix="gpswb-run-")
        self.folder = Path(self._folder.name)
        if hasattr(source, "RunKey"):
            shutil.copyfile(source.Labels, self.folder / _LABELS)
            (self.folder / _RESULT).write_text(source.Result)
        elif is_measurement(source):
            write_measurement(self.folder / _MEASURED, measurement_of(source))
        else:
            source.Shape.exportBrep(str(self.folder / _SHAPE))
        self._job = IsolatedJob(f"{__name__}:{job}", [str(self.folder), source.Label, *args])

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


def partition_shape(
    folder: str, label: str, density: str, mode: str, overrides: str
) -> dict[str, Any]:
    """Job: partition a shape; leaves ``labels.npz`` and returns what `finish_run` takes."""
    tell = job_progress()
    outcome = examine(Path(folder, _SHAPE), _settings(density, mode), tell)
    return _stored(Path(folder), label, outcome, overrides, tell)


def partition_measurement(folder: str, label: str, mode: str, overrides: str) -> dict[str, Any]:
    """Job: the same for a mesh or points."""
    tell = job_progress()
    tell("read", 0.0)
    solid = read_stored_measurement(Path(folder, _MEASURED), label)
    solid, partition = partition_solid(solid, _settings("auto", mode), tell)
    return _stored(Path(folder), label, Outcome(solid, partition, None), overrides, tell)


def _stored(
    folder: Path, label: str, outcome: Outcome, overrides: str, tell: Progress
) -> dict[str, Any]:
    tell("store", 0.0)
    solid = dataclasses.replace(outcome.solid, source=label)
    write_labels(folder / _LABELS, outcome.partition, solid.facemap, solid.pointmap)
    document = result_document(solid, outcome.partition, outcome.validation)
    described = ""
    if overrides:
        described = _described(document, folder, overrides, "", lambda share: tell("store", share))
    return {"document": document, "described": described}


def describe_overrides(folder: str, label: str, overrides: str, described: str) -> str:
    """Job: fit the regions of overrides on a result; those in ``described`` are known."""
    tell = job_progress()
    tell("read", 0.0)
    document = json.loads(Path(folder, _RESULT).read_text())
    return _described(
        document, Path(folder), overrides, described, lambda share: tell("recognise", share)
    )


def _described(
    document: dict[str, Any],
    folder: Path,
    overrides: str,
    known: str,
    tell: Callable[[float], None],
) -> str:
    stored = read_run(document, folder / _LABELS)
    found = apply_overrides(stored, from_json(overrides), regions_from_json(known), tell)
    return regions_to_json(found.described)


def count_triangles(folder: str, label: str, density: str) -> dict[str, Any]:
    """Job: mesh a shape as a run would, and say how many triangles that makes, by what."""
    solid = read_solid(Path(folder, _SHAPE), Density.parse(density), "freecad")
    return {"triangles": len(solid.mesh.triangles), "mesher": solid.mesher}


def sweep_densities(
    folder: str, label: str, densities: list[str], mode: str
) -> list[dict[str, Any]]:
    """Job: partition at each density; a row of figures each."""
    tell = job_progress()
    rows = []
    for i, density in enumerate(densities):
        tell(density, i / len(densities))
        outcome = examine(Path(folder, _SHAPE), _settings(density, mode))
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
