# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a side may be: by curvature, the face's extent, the distance to small detail."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from gpswb.cad.kernel import BrepFace, Shape
from gpswb.cad.split import Sides
from gpswb.cad.surface import arc_lengths, largest_curvature, outward_normals
from gpswb.cad.weld import Tessellation
from gpswb.core.mesh import FloatArray, IntArray

_GROWTH = 0.4
"""Growth of the spacing per mm away from a fine place."""
_SLACK = 1.4
"""A side is split above this multiple of the spacing: halves are then no shorter than 0.7 of it."""
_STRETCH = 2.5
"""How much longer than the spacing a side on a curved face may be: along the direction of least
curvature it needs no more vertices, and more than this would make slivers."""
_FEWEST = 3
"""Least number of sides across the longest of strips: two vertices between its borders."""
_RIM_SLACK = 1.6
"""Spacing in a plane face where a curved neighbour has split its border, over the side there."""
_STRIP, _STRIP_TURN = 60.0, 2.0
"""A strip longer than so many times its width may turn up to so much more from vertex to vertex:
it would take most of the mesh otherwise, and has triangles enough."""
_KINK = 0.25, 1 / 16
"""Sides shorter than this fraction of the spacing (graded) or of the longest side (near-uniform)
aren't split for turning too much: a kink in a surface turns however short the side is."""
_FINEST = 1 / 500
"""Least spacing, as a fraction of the longest side: sliver faces and gaps ask for anything."""
_SMALLEST = 1 / 32
"""No curvature asks for a spacing below this fraction of the face's width: an apex has no end."""


@dataclass(frozen=True)
class SizeRule:
    """What a side must not exceed.

    Args:
        max_length: mm.
        max_turn: angle between the exact normals at its two ends, rad.
        divisions: least number of sides across a curved face, in both parameters; 0 for none.
        graded: sides grow only gradually away from fine places (else the mesh is near-uniform).
        max_triangles: refinement stops here.
    """

    max_length: float
    max_turn: float = math.inf
    divisions: int = 0
    graded: bool = True
    max_triangles: int = 300_000


class Sizing:
    """Size of every side relative to what is allowed: above 1 it must be split.

    Every vertex carries two spacings. In plane faces it comes from the sides of the B-rep edges at
    the vertex; in curved ones also from the curvature and the width of the faces. It grows with the
    distance from there. Splitting a side lowers it by less than the side, so refinement ends.
    """

    def __init__(self, shape: Shape, rule: SizeRule, first: Tessellation) -> None:
        self._shape = shape
        self._rule = rule
        # A face narrower than the finest spacing is a seam of the B-rep, not something to resolve.
        finest = _FINEST * rule.max_length
        arcs = [arc_lengths(face) if _curved(face) else None for face in shape.faces]
        self._arcs = [a if a and min(a[0][-1], a[1][-1]) > finest else None for a in arcs]
        self._spacing = self._plain = np.full(len(first.vertices), rule.max_length)
        if rule.graded:
            rim = first.edge.ravel() >= 0
            length = np.maximum(first.side_lengths().ravel()[rim], _FINEST * rule.max_length)
            ends = first.triangles.ravel(), np.roll(first.triangles, -1, axis=1).ravel()
            for end in ends:
                np.minimum.at(self._spacing, end[rim], length)
            self._plain = self._spacing.copy()
            self._limit_by_surface(first, 0)

    def __call__(self, mesh: Tessellation, sides: Sides, length: FloatArray) -> FloatArray:
        """(s,) size of each distinct side of the mesh, whose side lengths are (m, 3) mm."""
        if self._rule.graded:
            self._extend(mesh, sides, length)
        size = length / self._rule.max_length
        for f, rows in _by_face(mesh.face):
            face = self._shape.faces[f]
            if face.kind is None or np.isnan(mesh.uv[rows]).any():
                size[rows] = 0.0  # There is no telling where a new vertex would lie.
                continue
            curved = _curved(face) and self._arcs[f] is not None
            stretch = _STRETCH if curved else 1.0
            if curved:
                size[rows] = np.maximum(size[rows], self._detail(face, f, mesh, rows, length[rows]))
            if self._rule.graded:
                spacing = self._spacing if curved else self._plain
                a = spacing[mesh.triangles[rows]]
                b = np.roll(a, -1, axis=1)
                steps = _steps(a, b, length[rows]) / (_SLACK * stretch)
                size[rows] = np.maximum(size[rows], steps)
        out = np.zeros(len(sides.first))
        np.maximum.at(out, sides.number.ravel(), size.ravel())
        return out

    def _extend(self, mesh: Tessellation, sides: Sides, length: FloatArray) -> None:
        """Give new vertices a spacing and let small ones spread along the sides."""
        known = len(self._spacing)
        fresh = np.full(len(mesh.vertices) - known, self._rule.max_length)
        self._spacing = np.concatenate([self._spacing, fresh])
        self._plain = np.concatenate([self._plain, fresh])
        self._limit_by_surface(mesh, known)
        tail = mesh.triangles.ravel()[sides.first]
        head = np.roll(mesh.triangles, -1, axis=1).ravel()[sides.first]
        long = length.ravel()[sides.first]
        rim = mesh.edge.ravel()[sides.first] >= 0
        finest = _FINEST * self._rule.max_length
        for end in (tail, head):
            np.minimum.at(self._plain, end[rim], np.maximum(_RIM_SLACK * long[rim], finest))
        for spacing in (self._spacing, self._plain):
            for _ in range(6):
                reach = spacing[tail] + _GROWTH * long, spacing[head] + _GROWTH * long
                np.minimum.at(spacing, head, reach[0])
                np.minimum.at(spacing, tail, reach[1])

    def _limit_by_surface(self, mesh: Tessellation, known: int) -> None:
        """Lower the spacing of the vertices from ``known`` on to what their faces ask for."""
        rule = self._rule
        for f, rows in _by_face(mesh.face):
            arcs = self._arcs[f]
            if arcs is None or np.isnan(mesh.uv[rows]).any():
                continue
            corner = mesh.triangles[rows]
            new = corner >= known
            vertex, at = np.unique(corner[new], return_index=True)
            if not len(vertex):
                continue
            width = min(arcs[0][-1], arcs[1][-1])
            limit = np.full(len(vertex), rule.max_length)
            if math.isfinite(rule.max_turn):
                curvature = largest_curvature(self._shape.faces[f], mesh.uv[rows][new][at])
                limit = self._max_turn(f) / np.maximum(curvature, 1e-12)
                limit = np.maximum(limit, _SMALLEST * width)
            if rule.divisions and width > 0:
                limit = np.minimum(limit, width / self._divisions(f)[0])
            limit = np.maximum(limit, _FINEST * rule.max_length)
            self._spacing[vertex] = np.minimum(self._spacing[vertex], limit)

    def _detail(
        self, face: BrepFace, f: int, mesh: Tessellation, rows: IntArray, length: FloatArray
    ) -> FloatArray:
        """Turn and extent of each side relative to the rule's."""
        uv, other = _side_ends(mesh.uv[rows], mesh.free[rows])
        size = np.zeros_like(length)
        if math.isfinite(self._rule.max_turn):
            size = _turn(face, mesh, rows, uv, other) / self._max_turn(f)
        if self._rule.graded:
            spacing = self._spacing[mesh.triangles[rows]]
            least = _KINK[0] * np.minimum(spacing, np.roll(spacing, -1, axis=1))
        else:
            least = np.full_like(length, _KINK[1] * self._rule.max_length)
        size[length < least] = 0.0
        arcs = self._arcs[f]
        if not self._rule.divisions or arcs is None:
            return size
        low, high = np.array(face.bounds[0::2]), np.array(face.bounds[1::2])
        across, along = self._divisions(f)
        narrow = int(arcs[1][-1] < arcs[0][-1])
        for axis, table in enumerate(arcs):
            if table[-1] <= 0 or high[axis] <= low[axis]:
                continue
            grid = np.linspace(low[axis], high[axis], len(table))
            a, b = (np.interp(x[..., axis], grid, table) for x in (uv, other))
            # Lines of a parameter grow shorter towards a pole: the side's own length bounds them.
            extent = np.minimum(np.abs(a - b), length)
            part = extent * (across if axis == narrow else along) / table[-1]
            size = np.maximum(size, np.where(length < least, 0.0, part))
        return size

    def _max_turn(self, f: int) -> float:
        arcs = self._arcs[f]
        if arcs is None:
            return self._rule.max_turn
        slenderness = _slenderness(arcs)
        return self._rule.max_turn * float(np.clip((slenderness / _STRIP) ** 0.5, 1.0, _STRIP_TURN))

    def _divisions(self, f: int) -> tuple[float, float]:
        """Least number of sides across and along a face: fewer across a long narrow strip, which
        has triangles enough."""
        arcs, wanted = self._arcs[f], self._rule.divisions
        if not wanted or arcs is None:
            return 0.0, 0.0
        across = max(_FEWEST, wanted * math.sqrt(min(1.0, wanted / _slenderness(arcs))))
        return min(across, wanted), wanted


def _slenderness(arcs: tuple[FloatArray, FloatArray]) -> float:
    """Length of a face over its width."""
    width, length = sorted((float(arcs[0][-1]), float(arcs[1][-1])))
    return length / max(width, 1e-12)


def _curved(face: BrepFace) -> bool:
    return face.kind not in (None, "Plane")


def _by_face(face: IntArray) -> list[tuple[int, IntArray]]:
    """Each face that occurs, with its triangles."""
    order = np.argsort(face, kind="stable")
    faces, start = np.unique(face[order], return_index=True)
    return list(zip(faces.tolist(), np.split(order, start[1:]), strict=True))


def _steps(a: FloatArray, b: FloatArray, length: FloatArray) -> FloatArray:
    """Number of spacings along a side whose spacing grows from both ends: the integral of ds/h."""
    peak = (a + b + _GROWTH * length) / 2
    steps: FloatArray = np.log(peak**2 / (a * b)) / _GROWTH
    return steps


def _side_ends(uv: FloatArray, free: IntArray) -> tuple[FloatArray, FloatArray]:
    """(r, 3, 2) parameters of both ends of each side; at a pole the far end's free one."""
    tail, head = uv.copy(), np.roll(uv, -1, axis=1)
    free_head = np.roll(free, -1, axis=1)
    for axis in (0, 1):
        at_tail, at_head = free == axis + 1, free_head == axis + 1
        tail[at_tail & ~at_head, axis] = head[at_tail & ~at_head, axis]
        head[at_head & ~at_tail, axis] = tail[at_head & ~at_tail, axis]
    return tail, head


def _turn(
    face: BrepFace, mesh: Tessellation, rows: IntArray, uv: FloatArray, other: FloatArray
) -> FloatArray:
    """(r, 3) angle between the exact normals at both ends of each side, rad."""
    tail = mesh.normal[rows]
    head = np.roll(tail, -1, axis=1)
    # At a pole or an apex the normal depends on where one comes from.
    pole = (mesh.free[rows] > 0).any(axis=1)
    if pole.any():
        tail[pole] = outward_normals(face, uv[pole].reshape(-1, 2)).reshape(-1, 3, 3)
        head[pole] = outward_normals(face, other[pole].reshape(-1, 2)).reshape(-1, 3, 3)
    cross = np.linalg.norm(np.cross(tail, head), axis=2)
    turn: FloatArray = np.arctan2(cross, np.einsum("ijk,ijk->ij", tail, head))
    return turn
