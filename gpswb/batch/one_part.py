# SPDX-License-Identifier: LGPL-2.1-or-later
"""One part through the whole pipeline: read, tessellate, partition, map back, validate."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from gpswb.batch.settings import Settings
from gpswb.cad.fcstd import holds_shape
from gpswb.cad.read import read_solid
from gpswb.cad.solid import Solid
from gpswb.core.mesh import Mesh
from gpswb.core.partition import Partition
from gpswb.core.pipeline import partition
from gpswb.errors import InputError
from gpswb.io.measured_file import SUFFIXES, read_measured
from gpswb.scan.bridges import without_bridges
from gpswb.validation.validate import Validation, validate

Progress = Callable[[str, float], None]
"""Called with the stage's name and the share (0..1) of it that is done."""

NOISE_SEED = 18183
"""Seed of the noise that is added for tests, so that a run can be repeated."""


@dataclass(frozen=True, eq=False)
class Outcome:
    """A part's solid, its partition and, where there is a B-rep, its validation."""

    solid: Solid
    partition: Partition
    validation: Validation | None


def examine(path: Path, settings: Settings, progress: Progress | None = None) -> Outcome:
    """Take one file through the pipeline.

    Raises:
        GpswbError: the file can't be read, or holds nothing to partition.
    """
    solid = read_any(path, settings, progress)
    if settings.noise_added > 0:
        solid = add_noise(solid, settings.noise_added)
    solid, result = partition_solid(solid, settings, progress)
    judged = validate(result, solid.facemap) if solid.facemap else None
    return Outcome(solid, result, judged)


def partition_solid(
    solid: Solid, settings: Settings, progress: Progress | None = None
) -> tuple[Solid, Partition]:
    """Partition what was read; in a cloud's mesh facets that bridge edges get no regions.

    Returns:
        The solid, with a note if there were such regions, and the partition.
    """
    result = partition(
        solid.mesh,
        mode=settings.mode,
        method=settings.method,
        noise=settings.noise,
        progress=progress,
    )
    if solid.pointmap is not None:
        bare = len(result.regions)
        result = without_bridges(result)
        bare -= len(result.regions)
        if bare:
            note = f"{bare} regions that no point belongs to, on edges, went to their neighbours"
            solid = replace(solid, notes=(*solid.notes, note))
    return solid, result


def read_any(path: Path, settings: Settings, progress: Progress | None = None) -> Solid:
    """Read a CAD file by its kernel, or what was measured.

    A FreeCAD document with a shape is a CAD file, whatever else is in it.

    Raises:
        GpswbError: the file can't be read, or holds nothing to partition.
    """
    suffix = path.suffix.lower()
    if suffix in SUFFIXES or (suffix == ".fcstd" and not holds_shape(path)):
        return read_measured(path, settings.unit)
    if settings.unit is not None:
        raise InputError(f"{path} states its unit itself: --unit is for meshes and point clouds")
    return read_solid(path, settings.density, settings.kernel, progress)


def add_noise(solid: Solid, fraction: float) -> Solid:
    """Displace every vertex by a normal deviate of σ = ``fraction`` of the diagonal an axis."""
    random = np.random.default_rng(NOISE_SEED)
    vertices = solid.mesh.vertices
    moved = vertices + random.normal(0.0, fraction * solid.mesh.diagonal, vertices.shape)
    note = f"gaussian noise added, sigma {fraction:g} of the diagonal"
    return replace(solid, mesh=Mesh(moved, solid.mesh.triangles), notes=(*solid.notes, note))
