# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parsing triangle meshes: STL, PLY, OFF, OBJ, 3MF. trimesh or FreeCAD parses, we check."""

from __future__ import annotations

import importlib.util
import zipfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from gpswb.core.mesh import FloatArray, IntArray, Mesh
from gpswb.errors import InputError

SUFFIXES = (".stl", ".ply", ".off", ".obj", ".3mf")
"""Endings, in lower case, that `parse_mesh` takes."""


MOST_BYTES = 2_000_000_000
"""Most that a 3MF may unpack to."""


@dataclass(frozen=True, eq=False)
class Parsed:
    """What a file holds, in its own unit.

    Args:
        vertices: (n, 3) float64.
        triangles: (m, 3) int64; none in a PLY that is a point cloud.
        unit: the unit that the file states; None in formats that state none.
    """

    vertices: FloatArray
    triangles: IntArray
    unit: str | None = None


def parse_mesh(path: Path) -> Parsed:
    """Parse a mesh file.

    Raises:
        InputError: no such file, not a mesh, an index out of range, coordinates not finite.
    """
    parse = _parser()
    try:
        file = path.open("rb")
    except OSError as error:
        raise InputError(f"can't read {path}: {error.strerror or error}") from error
    with file:
        try:
            if path.suffix.lower() == ".3mf":
                _check_archive(file)
            parsed = parse(file, path.suffix.lower()[1:])
        except Exception as error:  # the parsers raise whatever the bytes make them
            raise InputError(f"{path} is not a readable {path.suffix[1:].upper()} mesh") from error
    if len(parsed.triangles):
        try:
            Mesh(parsed.vertices, parsed.triangles)
        except ValueError as error:
            raise InputError(f"{path}: {error}") from error
    return parsed


def _check_archive(file: BinaryIO) -> None:
    """A 3MF is a zip archive: a small one could unpack to more than fits in memory."""
    with zipfile.ZipFile(file) as archive:
        size = sum(member.file_size for member in archive.infolist())
    if size > MOST_BYTES:
        raise ValueError(f"unpacks to {size} bytes")
    file.seek(0)


def _parser() -> Callable[[BinaryIO, str], Parsed]:
    """The parser that this Python has: trimesh, else FreeCAD's own."""
    for module, parse in (("trimesh", _by_trimesh), ("Mesh", _by_freecad)):
        if importlib.util.find_spec(module):
            return parse
    raise InputError("reading a mesh file needs the Python package trimesh, or FreeCAD")


def _by_trimesh(file: BinaryIO, suffix: str) -> Parsed:
    import trimesh

    # From an open file, so that an OBJ can't make us open the other files it names.
    scene: Any = trimesh.load_scene(file, file_type=suffix, process=False, skip_materials=True)
    vertices, triangles = [np.zeros((0, 3))], [np.zeros((0, 3), dtype=np.int64)]
    count = 0
    # A 3MF places its objects, and may place one several times.
    for name in scene.graph.nodes_geometry:
        transform, geometry = scene.graph[name]
        shape = scene.geometry[geometry]
        points = np.array(shape.vertices, dtype=np.float64).reshape(-1, 3)
        vertices.append(points @ transform[:3, :3].T + transform[:3, 3])
        faces = np.array(getattr(shape, "faces", []), dtype=np.int64).reshape(-1, 3)
        triangles.append(faces + count)
        count += len(points)
    stated = scene.units if suffix == "3mf" else None
    return Parsed(np.concatenate(vertices), np.concatenate(triangles), stated)


def _by_freecad(file: BinaryIO, _suffix: str) -> Parsed:
    import FreeCAD
    import Mesh as FreeCADMesh

    assert FreeCAD.Version  # Mesh can't be loaded before it
    loaded = FreeCADMesh.Mesh()
    # By name: only so does it tell the two kinds of STL apart itself.
    loaded.read(file.name)
    points, facets = loaded.Topology
    return Parsed(
        np.array([tuple(point) for point in points], dtype=np.float64).reshape(-1, 3),
        np.array(facets, dtype=np.int64).reshape(-1, 3),
    )
