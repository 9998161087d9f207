# SPDX-License-Identifier: LGPL-2.1-or-later
"""CPU seconds of FreeCAD's ``getCurvaturePerVertex`` on a mesh, as JSON; in FreeCAD's Python.

``PYTHONPATH=/usr/lib/freecad-python3/lib /usr/bin/python3 benchmarks/freecad_peer.py MESH ROUNDS``
"""

import json
import resource
import sys
import tempfile
from pathlib import Path

import FreeCAD  # noqa: F401 - before Mesh
import Mesh
import numpy as np


def cpu_seconds():
    use = resource.getrusage(resource.RUSAGE_SELF)
    return use.ru_utime + use.ru_stime


def write_ply(path, vertices, triangles):
    """FreeCAD reads a file much faster than a list of facets."""
    head = (
        "ply\nformat binary_little_endian 1.0\n"
        f"element vertex {len(vertices)}\nproperty float x\nproperty float y\nproperty float z\n"
        f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    rows = np.empty(len(triangles), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    rows["count"], rows["corners"] = 3, triangles
    path.write_bytes(head.encode() + vertices.astype("<f4").tobytes() + rows.tobytes())


def main():
    with np.load(sys.argv[1]) as stored, tempfile.TemporaryDirectory() as scratch:
        ply = Path(scratch) / "mesh.ply"
        write_ply(ply, stored["vertices"], stored["triangles"])
        seconds = []
        for _ in range(int(sys.argv[2])):
            mesh = Mesh.Mesh(str(ply))  # anew: curvature may be kept
            start = cpu_seconds()
            curvature = mesh.getCurvaturePerVertex()
            seconds.append(cpu_seconds() - start)
        print(json.dumps({"vertices": len(curvature), "seconds": seconds}))


main()
