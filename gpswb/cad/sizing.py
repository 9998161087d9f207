# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a side may be: by curvature, by the face's own extent, by the distance to small detail."""

from __future__ import annotations

import math

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import dijkstra

from gpswb.cad.kernel import BrepFace, Shape
from gpswb.cad.split import Sides, distinct_sides
from gpswb.cad.surface import arc_lengths, outward_normals
from gpswb.cad.weld import Tessellation
from gpswb.core.mesh import FloatArray, IntArray

_GROWTH = 0.4
"""Growth of the spacing per mm away from a short side."""
_SLACK = 1.4
"""A side is split above this multiple of the spacing: halves are then no shorter than 0.7 of it."""
_STRETCH = 3.0
"""How much longer than the spacing a side on a curved face may be: across the curvature direction
it needs no more vertices, and more than this would make slivers."""


def initial_spacing(mesh: Tessellation, max_length: float, graded: bool) -> FloatArray:
    """(n,) wanted spacing at each vertex, mm: the shortest B-rep side there, growing with distance.

    Found once, on the first mesh, as the shortest path from a common source: so that splitting
    can't shrink the spacing that asked for it.
    """
    n = len(mesh.vertices)
    if not graded or not n:
        return np.full(n, max_length)
    tail, head = mesh.triangles.ravel(), np.roll(mesh.triangles, -1, axis=1).ravel()
    length = mesh.side_lengths().ravel()
    own = np.full(n, max_length)
    rim = mesh.edge.ravel() >= 0
    np.minimum.at(own, tail[rim], length[rim])
    np.minimum.at(own, head[rim], length[rim])
    # One occurrence of a side gives its weight (a repeated entry would be summed).
    first = distinct_sides(mesh).first
    low, high = np.minimum(tail, head)[first], np.maximum(tail, head)[first]
    pair, at = np.unique(low * np.int64(n) + high, return_index=True)
    rows = np.concatenate([pair // n, np.full(n, n)])
    columns = np.concatenate([pair % n, np.arange(n)])
    weights = np.concatenate([_GROWTH * length[first][at], own])
    graph = coo_matrix((np.maximum(weights, 1e-300), (rows, columns)), shape=(n + 1, n + 1))
    reach: FloatArray = dijkstra(graph.tocsr(), directed=False, indices=n)[:n]
    return np.minimum(reach, max_length)


class Sizing:
    """Size of every side relative to what is allowed: above 1 it must be split."""

    def __init__(self, shape: Shape, max_length: float, max_turn: float, divisions: int) -> None:
        self._shape = shape
        self._max_length = max_length
        self._max_turn = max_turn
        self._divisions = divisions
        self._arcs = [
            arc_lengths(face) if divisions and _curved(face) else None for face in shape.faces
        ]

    def __call__(
        self, mesh: Tessellation, sides: Sides, length: FloatArray, spacing: FloatArray
    ) -> tuple[FloatArray, FloatArray]:
        """(s,) size of each distinct side; and the part of it that curvature and the face's extent
        ask for. ``length`` is (m, 3), ``spacing`` (n,), mm."""
        detail = np.zeros_like(length)
        stretch = np.ones(len(mesh.triangles))
        order = np.argsort(mesh.face, kind="stable")
        faces, start = np.unique(mesh.face[order], return_index=True)
        for f, rows in zip(faces, np.split(order, start[1:]), strict=True):
            face = self._shape.faces[f]
            if _curved(face):
                stretch[rows] = _STRETCH
                detail[rows] = self._detail(face, f, mesh, rows, length[rows])
        local = _log_mean(spacing[mesh.triangles], spacing[np.roll(mesh.triangles, -1, axis=1)])
        allowed = np.minimum(_SLACK * local * stretch[:, None], self._max_length)
        out, part = np.zeros(len(sides.first)), np.zeros(len(sides.first))
        number = sides.number.ravel()
        np.maximum.at(part, number, detail.ravel())
        np.maximum.at(out, number, np.maximum(detail, length / allowed).ravel())
        return out, part

    def _detail(
        self, face: BrepFace, f: int, mesh: Tessellation, rows: IntArray, length: FloatArray
    ) -> FloatArray:
        uv, other = _side_ends(mesh.uv[rows], mesh.free[rows])
        size = np.zeros_like(length)
        if math.isfinite(self._max_turn):
            size = _turn(face, uv, other) / self._max_turn
        arcs = self._arcs[f]
        if arcs is None:
            return size
        low, high = np.array(face.bounds[0::2]), np.array(face.bounds[1::2])
        for axis, table in enumerate(arcs):
            if table[-1] <= 0 or high[axis] <= low[axis]:
                continue
            grid = np.linspace(low[axis], high[axis], len(table))
            a, b = (np.interp(x[..., axis], grid, table) for x in (uv, other))
            # Lines of a parameter grow shorter towards a pole: the side's own length bounds them.
            extent = np.minimum(np.abs(a - b), length)
            size = np.maximum(size, extent * self._divisions / table[-1])
        return size


def _curved(face: BrepFace) -> bool:
    return face.kind not in (None, "Plane")


def _log_mean(a: FloatArray, b: FloatArray) -> FloatArray:
    """Mean of a spacing that grows linearly from a to b, as the integral of ds/h asks for."""
    with np.errstate(divide="ignore", invalid="ignore"):
        mean = (b - a) / np.log(b / a)
    return np.where(np.abs(b - a) < 1e-6 * a, (a + b) / 2, mean)


def _side_ends(uv: FloatArray, free: IntArray) -> tuple[FloatArray, FloatArray]:
    """(r, 3, 2) parameters of both ends of each side; at a pole the far end's free one."""
    tail, head = uv.copy(), np.roll(uv, -1, axis=1)
    free_head = np.roll(free, -1, axis=1)
    for axis in (0, 1):
        at_tail, at_head = free == axis + 1, free_head == axis + 1
        tail[at_tail & ~at_head, axis] = head[at_tail & ~at_head, axis]
        head[at_head & ~at_tail, axis] = tail[at_head & ~at_tail, axis]
    return tail, head


def _turn(face: BrepFace, uv: FloatArray, other: FloatArray) -> FloatArray:
    """Angle between the exact normals at both ends of each side, rad."""
    both = np.concatenate([uv.reshape(-1, 2), other.reshape(-1, 2)])
    distinct, inverse = np.unique(both, axis=0, return_inverse=True)
    normal = outward_normals(face, distinct)[inverse.ravel()]
    n, k = normal[: len(both) // 2], normal[len(both) // 2 :]
    cross = np.linalg.norm(np.cross(n, k), axis=1)
    turn: FloatArray = np.arctan2(cross, np.einsum("ij,ij->i", n, k))
    return turn.reshape(uv.shape[:2])
