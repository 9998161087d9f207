# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading triangle meshes: STL, PLY, OFF, OBJ. trimesh or FreeCAD parses, we check and weld."""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
import numpy.typing as npt
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from gpswb.core.mesh import Mesh
from gpswb.errors import InputError

SUFFIXES = (".stl", ".ply", ".off", ".obj")
"""Endings, in lower case, that `read_mesh` takes."""

WELD = 2.0**-21
"""Four units in the last place of single precision, relative to the largest coordinate: what the
writers of STL round away; corners nearer than this are one."""


def read_mesh(path: Path) -> Mesh:
    """Read a triangle mesh, coordinates taken as mm, corners at the same place welded.

    STL has no shared vertices at all and other formats double them along seams.

    Raises:
        InputError: no such file, not a mesh, no triangles, or coordinates that are not finite.
    """
    parse = _parser()
    try:
        with path.open("rb") as file:
            vertices, triangles = parse(file, path.suffix.lower()[1:])
    except OSError as error:
        raise InputError(f"can't read {path}: {error.strerror or error}") from error
    except Exception as error:  # the parsers raise whatever the bytes make them
        raise InputError(f"{path} is not a readable {path.suffix[1:].upper()} mesh") from error
    if not len(triangles):
        raise InputError(f"{path} holds no triangles")
    try:
        return weld(Mesh(vertices, triangles))
    except ValueError as error:
        raise InputError(f"{path}: {error}") from error


Arrays = tuple[npt.NDArray[np.float64], npt.NDArray[np.int64]]


def _parser() -> Callable[[BinaryIO, str], Arrays]:
    """The parser that this Python has: trimesh, else FreeCAD's own."""
    for module, parse in (("trimesh", _by_trimesh), ("Mesh", _by_freecad)):
        if importlib.util.find_spec(module):
            return parse
    raise InputError("reading a mesh file needs the Python package trimesh, or FreeCAD")


def _by_trimesh(file: BinaryIO, suffix: str) -> Arrays:
    import trimesh

    # From an open file, so that an OBJ can't make us open the other files it names.
    loaded: Any = trimesh.load_mesh(file, file_type=suffix, process=False, skip_materials=True)
    return (
        np.array(loaded.vertices, dtype=np.float64).reshape(-1, 3),
        np.array(loaded.faces, dtype=np.int64).reshape(-1, 3),
    )


def _by_freecad(file: BinaryIO, _suffix: str) -> Arrays:
    import FreeCAD
    import Mesh as FreeCADMesh

    assert FreeCAD.Version  # Mesh can't be loaded before it
    loaded = FreeCADMesh.Mesh()
    # By name: only so does it tell the two kinds of STL apart itself.
    loaded.read(file.name)
    points, facets = loaded.Topology
    return (
        np.array([tuple(point) for point in points], dtype=np.float64).reshape(-1, 3),
        np.array(facets, dtype=np.int64).reshape(-1, 3),
    )


def weld(mesh: Mesh) -> Mesh:
    """Unite vertices nearer than ``WELD`` and drop those that no triangle uses.

    Triangles that this folds to a line or a point are dropped as well.
    """
    used = mesh.vertices[mesh.triangles.ravel()] + 0.0  # turns -0.0 into 0.0
    vertices, index = np.unique(used, axis=0, return_inverse=True)
    index = index.reshape(-1)
    reach = WELD * float(np.abs(vertices).max(initial=0.0))
    near = cKDTree(vertices).query_pairs(reach, output_type="ndarray")
    if len(near):
        n = len(vertices)
        graph = coo_array((np.ones(len(near)), (near[:, 0], near[:, 1])), shape=(n, n))
        count, label = connected_components(graph, directed=False)
        first = np.full(count, n, dtype=np.int64)
        np.minimum.at(first, label, np.arange(n))
        vertices, index = vertices[first], label[index]
    triangles = index.reshape(-1, 3).astype(np.int64)
    if len(near):
        a, b, c = triangles.T
        triangles = triangles[(a != b) & (b != c) & (c != a)]
    return Mesh(vertices, triangles)
