# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh handed to FreeCAD, in FreeCAD's Python."""

import tempfile
from pathlib import Path

import FreeCAD  # noqa: F401 - before Mesh
import Mesh
import numpy as np


def freecad_mesh(vertices, triangles):
    """FreeCAD's mesh of the same facets in the same order, in single precision as all its meshes.

    By a file: FreeCAD reads one much faster than a list of facets.
    """
    with tempfile.TemporaryDirectory() as scratch:
        path = Path(scratch) / "mesh.ply"
        _write_ply(path, vertices, triangles)
        mesh = Mesh.Mesh(str(path))
    if not np.array_equal(mesh.Topology[1], triangles):
        raise ValueError(f"FreeCAD took {mesh.CountFacets} of {len(triangles)} facets")
    return mesh


def _write_ply(path, vertices, triangles):
    head = (
        "ply\nformat binary_little_endian 1.0\n"
        f"element vertex {len(vertices)}\nproperty float x\nproperty float y\nproperty float z\n"
        f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    rows = np.empty(len(triangles), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    rows["count"], rows["corners"] = 3, triangles
    path.write_bytes(head.encode() + vertices.astype("<f4").tobytes() + rows.tobytes())
