# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading triangle meshes: STL, PLY, OFF, OBJ (trimesh parses, we check and weld)."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
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
    try:
        # An ImportError would be the machine's fault, not the file's: say what to install.
        import trimesh
    except ImportError as error:
        raise InputError("reading a mesh file needs the Python package trimesh") from error
    try:
        with path.open("rb") as file:
            # From an open file, so that an OBJ can't make us open the other files it names.
            loaded: Any = trimesh.load_mesh(
                file, file_type=path.suffix.lower()[1:], process=False, skip_materials=True
            )
            vertices = np.array(loaded.vertices, dtype=np.float64).reshape(-1, 3)
            triangles = np.array(loaded.faces, dtype=np.int64).reshape(-1, 3)
    except OSError as error:
        raise InputError(f"can't read {path}: {error.strerror or error}") from error
    except Exception as error:  # the parsers raise whatever the bytes make them raise
        raise InputError(f"{path} is not a readable {path.suffix[1:].upper()} mesh") from error
    if not len(triangles):
        raise InputError(f"{path} holds no triangles")
    try:
        return weld(Mesh(vertices, triangles))
    except ValueError as error:
        raise InputError(f"{path}: {error}") from error


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
