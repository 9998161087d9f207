# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces that the mesher leaves without a triangle, spanned by the border that neighbours share."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from gpswb.cad.faced import FacedMesh, open_sides
from gpswb.cad.kernel import BrepFace
from gpswb.cad.weld import Tessellation
from gpswb.core.mesh import FloatArray, IntArray

_MOST_SIDES = 200
"""Longest border that is spanned: the search takes time with its third power."""


def span(mesh: Tessellation, faces: Iterable[tuple[int, BrepFace]]) -> FacedMesh:
    """The mesh with triangles across the borders of ``faces``, (number, face), which have none.

    A face is spanned if its neighbours leave open one closed loop along its edges, and then it
    closes the mesh there: no vertex is added. A face whose border isn't closed, has holes, or has
    a neighbour without triangles stays as it is.
    """
    empty = dict(faces)
    triangles, face = [mesh.triangles], [mesh.face]
    if empty:
        row, k = np.nonzero(open_sides(mesh.triangles) & (mesh.edge >= 0))
        # The face runs along each side against the neighbour's direction.
        tail, head = mesh.triangles[row, (k + 1) % 3], mesh.triangles[row, k]
        edge = mesh.edge[row, k]
        for number, each in empty.items():
            mine = np.isin(edge, each.edges)
            if set(edge[mine].tolist()) != set(each.edges):
                continue
            loop = _loop(tail[mine], head[mine])
            if loop is not None:
                across = loop[least_area_triangles(mesh.vertices[loop])]
                triangles.append(across)
                face.append(np.full(len(across), number))
    return FacedMesh(mesh.vertices, np.concatenate(triangles), np.concatenate(face))


def _loop(tail: IntArray, head: IntArray) -> IntArray | None:
    """(k,) vertices of directed sides in their order; None where they aren't one closed loop."""
    after = dict(zip(tail.tolist(), head.tolist(), strict=True))
    if len(after) != len(tail) or not 3 <= len(tail) <= _MOST_SIDES:
        return None
    loop = [int(tail[0])]
    while (vertex := after.get(loop[-1])) is not None and vertex != loop[0]:
        if len(loop) == len(tail):
            return None
        loop.append(vertex)
    return np.array(loop) if vertex is not None and len(loop) == len(tail) else None


def least_area_triangles(points: FloatArray) -> IntArray:
    """(k-2, 3) triangles between the corners (k, 3) of a closed polygon, with the least area in
    all.

    By dynamic programming over its chords (Barequet and Sharir, Filling gaps in the boundary of a
    polyhedron, 1995). It needs no plane to project on, so that a sliver is no harder than a square.
    """
    k = len(points)
    cost = np.zeros((k, k))
    middle = np.zeros((k, k), dtype=np.int64)
    for width in range(2, k):
        for first in range(k - width):
            last = first + width
            between = np.arange(first + 1, last)
            spread = np.cross(points[between] - points[first], points[between] - points[last])
            total = cost[first, between] + cost[between, last]
            total += np.linalg.norm(spread, axis=1) / 2
            best = int(total.argmin())
            cost[first, last], middle[first, last] = total[best], between[best]
    waiting, found = [(0, k - 1)], []
    while waiting:
        first, last = waiting.pop()
        if last - first > 1:
            at = int(middle[first, last])
            found.append((first, at, last))
            waiting += [(first, at), (at, last)]
    return np.array(found, dtype=np.int64)
