# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes and point clouds from files and FreeCAD objects: the door for all that was measured."""

from __future__ import annotations

import hashlib
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from gpswb.cad.fcstd_measured import Measurement, stored_measurements
from gpswb.cad.freecad_measured import is_measurement, measurement_of
from gpswb.cad.solid import PointMap, Solid
from gpswb.core.mesh import FloatArray, IntArray, Mesh
from gpswb.errors import InputError
from gpswb.io import cloud_file, mesh_file
from gpswb.io.length_units import MILLIMETRES, SPELLINGS
from gpswb.scan.cloud import mesh_cloud
from gpswb.scan.repair import repair
from gpswb.sentence import joined

SMALLEST, LARGEST = 1e-6, 1e9
"""Extents that a part may have, mm; beyond them numbers overflow, or the unit is wrong."""

SUFFIXES = (*mesh_file.SUFFIXES, *cloud_file.SUFFIXES)
"""Endings, in lower case, of measured files; FCStd documents may hold measurements, too."""


def read_measured(path: Path, unit: str | None = None) -> Solid:
    """Read a mesh file, a point cloud, or the Mesh and Points objects of an FCStd document.

    Args:
        path: the file.
        unit: of its coordinates, a key of `MILLIMETRES`; None for the file's own, mm where it
            states none.

    Raises:
        InputError: the file can't be read, holds nothing to partition, or states another unit.
    """
    start = time.perf_counter()
    suffix = path.suffix.lower()
    if suffix == ".fcstd":
        own, notes = _unit(path, "mm", unit)
        solid = solid_of_parts(stored_measurements(path), str(path), own, notes)
    else:
        if suffix in cloud_file.SUFFIXES:
            parsed = mesh_file.Parsed(cloud_file.parse_cloud(path), np.zeros((0, 3), np.int64))
        else:
            parsed = mesh_file.parse_mesh(path)
            if not len(parsed.triangles) and (suffix != ".ply" or not len(parsed.vertices)):
                raise InputError(f"{path} holds no triangles")
        own, notes = _unit(path, parsed.unit, unit)
        scaled = Measurement(parsed.vertices * MILLIMETRES[own], parsed.triangles)
        solid = solid_of_parts([scaled], str(path), own, notes)
    return _stamped(solid, hashlib.sha256(path.read_bytes()).hexdigest(), start)


def read_object(item: Any) -> Solid:
    """The same for a FreeCAD document object with a Mesh or Points; FreeCAD's unit is mm.

    Raises:
        InputError: it holds nothing to partition.
    """
    start = time.perf_counter()
    if not is_measurement(item):
        raise InputError(f"{item.Label} is neither a mesh nor points")
    placement = np.array(item.getGlobalPlacement().Matrix.A, dtype=np.float64).reshape(4, 4)
    inner = np.array(item.Placement.Matrix.A, dtype=np.float64).reshape(4, 4)
    # The object's own placement is in its coordinates already; those of its containers follow.
    part = measurement_of(item).placed(placement @ np.linalg.inv(inner))
    return _stamped(solid_of_parts([part], item.Label, "mm", ()), "", start)


def read_stored_measurement(path: Path, label: str) -> Solid:
    """The same for what `write_measurement` wrote.

    Args:
        label: what to call it in results and errors.

    Raises:
        InputError: it holds nothing to partition.
    """
    start = time.perf_counter()
    with np.load(path, allow_pickle=False) as file:
        part = Measurement(file["vertices"], file["triangles"])
    return _stamped(solid_of_parts([part], label, "mm", ()), "", start)


def write_measurement(path: Path, part: Measurement) -> None:
    """Store a mesh or points for `read_stored_measurement`, quickly and exactly.

    Raises:
        OSError: the file can't be written.
    """
    np.savez(path, vertices=part.vertices, triangles=part.triangles)


def solid_of_parts(
    parts: list[Measurement], source: str, unit: str, notes: tuple[str, ...]
) -> Solid:
    """One mesh of several measurements: facets are repaired, points meshed.

    Args:
        parts: meshes, or clouds; a mix is taken as one cloud.
        source, unit, notes: for the result.

    Raises:
        InputError: nothing to partition is in them.
    """
    offset = np.cumsum([0, *(len(part.vertices) for part in parts)])
    vertices = np.concatenate([part.vertices for part in parts])
    facets = np.concatenate(
        [part.triangles + first for part, first in zip(parts, offset[:-1], strict=True)]
    )
    pointmap = None
    try:
        finite, told = _finite(vertices)
        _check_extent(vertices[finite])
        if all(len(part.triangles) for part in parts):
            mesh, told = repair(Mesh(vertices, facets))
            mesher = "none"
        else:
            cloud = mesh_cloud(vertices[finite])
            vertex = np.full(len(vertices), -1, dtype=np.int64)
            vertex[finite] = cloud.vertex_of_point
            mesh, pointmap = cloud.mesh, PointMap(vertices, vertex)
            told, mesher = (*told, *cloud.notes), "advancing front"
    except (InputError, ValueError) as error:
        raise InputError(joined(": ", [source, str(error)])) from error
    return Solid(mesh, None, source, unit, "as read", mesher, (*notes, *told), "", {}, pointmap)


def _stamped(solid: Solid, sha256: str, start: float) -> Solid:
    read_s = time.perf_counter() - start
    return replace(solid, sha256=sha256, timings={"read": read_s, "tessellate": 0.0})


def _finite(points: FloatArray) -> tuple[IntArray, tuple[str, ...]]:
    """Indices of the points with finite coordinates, and a note if there are others."""
    good = np.isfinite(points).all(axis=1)
    lost = int((~good).sum())
    told = (f"{lost} points without finite coordinates left out",) if lost else ()
    return np.flatnonzero(good), told


def _check_extent(points: FloatArray) -> None:
    extent = float(np.abs(points).max(initial=0.0))
    span = float(np.ptp(points, axis=0).max()) if len(points) else 0.0
    if extent > LARGEST or 0.0 < span < SMALLEST:
        size = extent if extent > LARGEST else span
        raise InputError(f"an extent of {size:.3g} mm is no part's: --unit may be wrong")


def _unit(path: Path, stated: str | None, asked: str | None) -> tuple[str, tuple[str, ...]]:
    """The unit to take, and a note where it had to be assumed."""
    own = SPELLINGS.get(stated, stated) if stated else None
    if own is not None and own not in MILLIMETRES:
        raise InputError(f"{path} is in an unknown unit {stated!r}")
    if asked is not None and own not in (None, asked):
        raise InputError(f"{path} states that its unit is {own}, not {asked}")
    if asked or own:
        return asked or own or "mm", ()
    return "mm", ("the file names no unit: coordinates are taken as mm (--unit says otherwise)",)
