# SPDX-License-Identifier: LGPL-2.1-or-later
"""CPU seconds of FreeCAD's ``getCurvaturePerVertex`` on a mesh, as JSON; in FreeCAD's Python.

``PYTHONPATH=/usr/lib/freecad-python3/lib /usr/bin/python3 benchmarks/freecad_peer.py MESH ROUNDS``
"""

import json
import resource
import sys

import numpy as np
from freecad_mesh import freecad_mesh


def cpu_seconds():
    use = resource.getrusage(resource.RUSAGE_SELF)
    return use.ru_utime + use.ru_stime


def main():
    with np.load(sys.argv[1]) as stored:
        vertices, triangles = stored["vertices"], stored["triangles"]
        seconds = []
        for _ in range(int(sys.argv[2])):
            mesh = freecad_mesh(vertices, triangles)  # anew: curvature may be kept
            start = cpu_seconds()
            curvature = mesh.getCurvaturePerVertex()
            seconds.append(cpu_seconds() - start)
        print(json.dumps({"vertices": len(curvature), "seconds": seconds}))


main()
