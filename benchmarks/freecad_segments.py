# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's mesh segments of a mesh; in FreeCAD's Python.

``PYTHONPATH=/usr/lib/freecad-python3/lib /usr/bin/python3 benchmarks/freecad_segments.py IN OUT
LIMIT``. IN is an npz with ``call`` (planar, type or curvature), ``vertices`` and ``triangles``,
``radii`` and ``distance`` (mm) and ``least``; OUT becomes one with the ``facets`` of all segments,
each one's ``length`` and ``kind``, and ``seconds``. LIMIT CPU seconds end the process by a signal.
"""

import resource
import sys

import numpy as np
from freecad_mesh import freecad_mesh

CURVATURE = 0.1
"""1/mm, tolerance of FreeCAD's dialog of segments by curvature."""


def planar(mesh, distance, radii, least):
    """``getPlanarSegments``: planes only."""
    return [("planar", part) for part in mesh.getPlanarSegments(distance, least)]


def of_type(mesh, distance, radii, least):
    """``getSegmentsOfType``: the surface that was asked for tells the class."""
    names = {"planar": "Plane", "cylindrical": "Cylinder", "spherical": "Sphere"}
    return [
        (kind, part)
        for kind, name in names.items()
        for part in mesh.getSegmentsOfType(name, distance, least)
    ]


def by_curvature(mesh, distance, radii, least):
    """``getSegmentsByCurvature``: the two principal curvatures asked for tell the class.

    The answer doesn't say which pair a segment fits, so each class is asked for by itself. A face
    may be convex or hollow, so each radius is asked for with both signs.
    """
    # Half of the least curvature at most: with more, planes would pass as the widest cylinder.
    near = min([CURVATURE, *(0.5 / radius for radius in radii)])
    bent = [sign / radius for radius in radii for sign in (1.0, -1.0)]
    asked = {
        "planar": [(0.0, 0.0)],
        "cylindrical": [(max(c, 0.0), min(c, 0.0)) for c in bent],
        "spherical": [(c, c) for c in bent],
    }
    return [
        (kind, part)
        for kind, pairs in asked.items()
        if pairs
        for part in mesh.getSegmentsByCurvature([(*c, near, near, least) for c in pairs])
    ]


def cpu_seconds():
    use = resource.getrusage(resource.RUSAGE_SELF)
    return use.ru_utime + use.ru_stime


def main():
    given, out, limit = sys.argv[1:]
    with np.load(given) as stored:
        mesh = freecad_mesh(stored["vertices"], stored["triangles"])
        call = {"planar": planar, "type": of_type, "curvature": by_curvature}[str(stored["call"])]
        radii = stored["radii"].tolist()
        distance, least = float(stored["distance"]), int(stored["least"])
    start = cpu_seconds()
    most = int(start + float(limit)) + 1
    resource.setrlimit(resource.RLIMIT_CPU, (most, most + 5))
    segments = call(mesh, distance, radii, least)
    np.savez(
        out,
        facets=np.array([i for _, part in segments for i in part], dtype=np.int64),
        length=np.array([len(part) for _, part in segments], dtype=np.int64),
        kind=np.array([kind for kind, _ in segments], dtype="U16"),
        seconds=cpu_seconds() - start,
    )


main()
