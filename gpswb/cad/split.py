# SPDX-License-Identifier: LGPL-2.1-or-later
"""Conforming subdivision of a tessellation: triangles are cut by the middles of their marked sides.

Every marked side gets one new vertex, computed once: on the edge's own curve where two faces meet,
at the middle in parameter space inside a face. So the mesh stays as watertight as it was.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gpswb.cad.groups import groups
from gpswb.cad.kernel import Shape
from gpswb.cad.locate import AGREE
from gpswb.cad.surface import nearest_uv, outward_normals
from gpswb.cad.weld import Tessellation
from gpswb.core.mesh import BoolArray, FloatArray, IntArray

# Children of a triangle that is cut at side 0 first, by which other sides are marked; corners
# 0 1 2, midpoints 3 4 5 of the sides 0-1, 1-2, 2-0.
_CHILDREN = {
    (False, False): ((0, 3, 2), (3, 1, 2)),
    (True, False): ((0, 3, 2), (3, 1, 4), (3, 4, 2)),
    (False, True): ((0, 3, 5), (3, 2, 5), (3, 1, 2)),
    (True, True): ((0, 3, 5), (3, 1, 4), (3, 4, 2), (3, 2, 5)),
}
# A child's side that lies on a side of its parent: (parent side, at which end of it).
_ON_PARENT = {
    (0, 1): (0, "whole"), (1, 2): (1, "whole"), (2, 0): (2, "whole"),
    (0, 3): (0, "first"), (3, 1): (0, "last"),
    (1, 4): (1, "first"), (4, 2): (1, "last"),
    (2, 5): (2, "first"), (5, 0): (2, "last"),
}  # fmt: skip


@dataclass(frozen=True, eq=False)
class Sides:
    """The distinct sides of a tessellation.

    Args:
        number: (m, 3) number of each triangle's side.
        first: (s,) flat index 3·triangle + side of one occurrence.
        count: (s,) in how many triangles it occurs.
    """

    number: IntArray
    first: IntArray
    count: IntArray


def distinct_sides(mesh: Tessellation) -> Sides:
    """Number the sides: the same vertices on the same B-rep edge between the same parameters, or
    in the same face, are one side. Vertices alone don't tell: two arcs may end in the same points.
    """
    tail, head = mesh.triangles.ravel(), np.roll(mesh.triangles, -1, axis=1).ravel()
    low, high = np.minimum(tail, head), np.maximum(tail, head)
    edge = mesh.edge.ravel()
    key = low * np.int64(len(mesh.vertices)) + high
    order = np.argsort(key, kind="stable")
    new = np.diff(key[order], prepend=-1) != 0
    # Only sides of the same vertices that meet three times or more, or on an edge and off it, need
    # a second look; few do.
    run = np.cumsum(new) - 1
    rows = np.flatnonzero(_doubtful(run, edge[order]))
    group = np.where(edge >= 0, edge, -1 - np.repeat(mesh.face, 3))
    start = np.where(edge >= 0, mesh.ends.min(axis=2).ravel(), 0.0)
    if len(rows):
        items = order[rows]
        again = np.lexsort((start[items], group[items], key[items]))
        order[rows] = items = items[again]
        same = [np.diff(x[items]) == 0 for x in (key, group, start)]
        new[rows] = np.r_[True, ~(same[0] & same[1] & same[2])]
    number = np.empty(len(key), dtype=np.int64)
    number[order] = np.cumsum(new) - 1
    first = order[np.flatnonzero(new)]
    return Sides(number.reshape(-1, 3), first, np.bincount(number))


def _doubtful(run: IntArray, edge: IntArray) -> BoolArray:
    """Occurrences, in order of their key, whose run isn't plainly one side."""
    if not len(run):
        return np.zeros(0, dtype=bool)
    count = np.bincount(run)
    lowest, highest = np.full(len(count), np.iinfo(np.int64).max), np.full(len(count), -2)
    np.minimum.at(lowest, run, edge)
    np.maximum.at(highest, run, edge)
    doubtful: BoolArray = ((count > 2) | (lowest != highest))[run]
    return doubtful


def split(
    mesh: Tessellation,
    shape: Shape,
    sides: Sides,
    marked: BoolArray,
    size: FloatArray,
    middle: FloatArray,
) -> Tessellation:
    """Split every marked side, (s,), once; in a triangle the marked side of largest ``size`` (s,)
    is cut first. ``middle`` (s, 3) is `rim_middles`."""
    hit = marked[sides.number].any(axis=1)
    triangles = np.flatnonzero(hit)
    # Turn each triangle so that the side cut first is side 0.
    turn = np.where(marked, size, -1.0)[sides.number[triangles]].argmax(axis=1)
    order = (turn[:, None] + np.arange(3)) % 3
    at = (triangles[:, None], order)
    number = sides.number[at]
    new = np.cumsum(marked) - 1
    points = middle[marked]
    middle_uv = _middle_uv(mesh, shape, at, marked[number], middle[number])
    middle_normal = _middle_normal(mesh, shape, middle_uv, triangles, marked[number])
    _add_inner_points(points, mesh, shape, sides, marked, number, middle_uv, triangles)
    corner = np.concatenate([mesh.triangles[at], new[number] + len(mesh.vertices)], axis=1)
    uv = np.concatenate([mesh.uv[at], middle_uv], axis=1)
    normal = np.concatenate([mesh.normal[at], middle_normal], axis=1)
    free = np.concatenate([mesh.free[at], np.zeros_like(number)], axis=1)
    edge, side, ends = mesh.edge[at], mesh.side[at], mesh.ends[at]
    parts: dict[str, list[np.ndarray]] = {}
    for (second, third), children in _CHILDREN.items():
        rows = np.flatnonzero((marked[number[:, 1]] == second) & (marked[number[:, 2]] == third))
        for child in children:
            pick = np.array(child)
            parts.setdefault("triangles", []).append(corner[rows][:, pick])
            parts.setdefault("face", []).append(mesh.face[triangles[rows]])
            parts.setdefault("uv", []).append(uv[rows][:, pick])
            parts.setdefault("normal", []).append(normal[rows][:, pick])
            parts.setdefault("free", []).append(free[rows][:, pick])
            e, s, t = _child_sides(child, edge[rows], side[rows], ends[rows])
            parts.setdefault("edge", []).append(e)
            parts.setdefault("side", []).append(s)
            parts.setdefault("ends", []).append(t)
    merged = {
        name: np.concatenate([getattr(mesh, name)[~hit], *arrays]) for name, arrays in parts.items()
    }
    return Tessellation(vertices=np.concatenate([mesh.vertices, points]), **merged)


def _child_sides(
    child: tuple[int, ...], edge: IntArray, side: IntArray, ends: FloatArray
) -> tuple[IntArray, IntArray, FloatArray]:
    out_edge = np.full((len(edge), 3), -1, dtype=np.int64)
    out_side, out_ends = np.zeros((len(edge), 3), dtype=np.int64), np.zeros((len(edge), 3, 2))
    for k in range(3):
        parent = _ON_PARENT.get((child[k], child[(k + 1) % 3]))
        if parent is None:
            continue
        p, where = parent
        t0, t1 = ends[:, p, 0], ends[:, p, 1]
        middle = (t0 + t1) / 2
        out_edge[:, k], out_side[:, k] = edge[:, p], side[:, p]
        out_ends[:, k, 0] = middle if where == "last" else t0
        out_ends[:, k, 1] = middle if where == "first" else t1
    return out_edge, out_side, out_ends


def _middle_uv(
    mesh: Tessellation,
    shape: Shape,
    at: tuple[IntArray, IntArray],
    marked: BoolArray,
    points: FloatArray,
) -> FloatArray:
    """(h, 3, 2) parameters of the middles of the sides of the triangles ``at``; ``points``
    (h, 3, 3) are the middles of those on B-rep edges."""
    uv, free = mesh.uv[at], mesh.free[at]
    other_uv, other_free = np.roll(uv, -1, axis=1), np.roll(free, -1, axis=1)
    middle = (uv + other_uv) / 2
    for axis in (0, 1):
        here = (free == axis + 1) & (other_free != axis + 1)
        there = (other_free == axis + 1) & (free != axis + 1)
        middle[here, axis] = other_uv[here, axis]
        middle[there, axis] = uv[there, axis]
    edge, side = mesh.edge[at], mesh.side[at]
    rows = np.flatnonzero((edge >= 0) & marked)
    if len(rows):
        owner = np.repeat(mesh.face[at[0][:, 0]], 3)[rows]
        target = points.reshape(-1, 3)
        t = mesh.ends[at].mean(axis=2).ravel()[rows]
        flat = middle.reshape(-1, 2)
        key = np.column_stack([owner, edge.ravel()[rows], side.ravel()[rows]])
        for (f, e, s), group in groups(key):
            face = shape.faces[f]
            uv = face.rim_uv(e, s, t[group])
            # The edge's curves in space and in parameter space may run at different paces.
            flat[rows[group]] = nearest_uv(face, target[rows[group]], uv, AGREE * shape.diagonal)
    return middle


def _middle_normal(
    mesh: Tessellation, shape: Shape, uv: FloatArray, triangles: IntArray, marked: BoolArray
) -> FloatArray:
    """(h, 3, 3) exact outward normals at the marked sides' middles ``uv`` (h, 3, 2)."""
    normal = np.zeros((*uv.shape[:2], 3))
    row, k = np.nonzero(marked)
    for (f,), group in groups(mesh.face[triangles[row]][:, None]):
        if shape.faces[f].kind is not None:
            at = row[group], k[group]
            normal[at] = outward_normals(shape.faces[f], uv[at])
    return normal


def rim_middles(mesh: Tessellation, shape: Shape, sides: Sides, marked: BoolArray) -> FloatArray:
    """(s, 3) middles of the marked sides that lie on B-rep edges, on their curves; nan for all
    others."""
    points = np.full((len(marked), 3), np.nan)
    edge = mesh.edge.ravel()[sides.first]
    on_edge = np.flatnonzero(marked & (edge >= 0))
    t = mesh.ends.reshape(-1, 2)[sides.first[on_edge]].mean(axis=1)
    for (e,), group in groups(edge[on_edge][:, None]):
        points[on_edge[group]] = shape.edge_points(e, t[group])
    return points


def _add_inner_points(
    points: FloatArray,
    mesh: Tessellation,
    shape: Shape,
    sides: Sides,
    marked: BoolArray,
    number: IntArray,
    middle_uv: FloatArray,
    triangles: IntArray,
) -> None:
    """Fill in the positions of the new vertices inside faces."""
    wanted = np.flatnonzero(marked)
    edge = mesh.edge.ravel()[sides.first[wanted]]
    # One occurrence of each side among the turned triangles gives its parameters and face.
    occurrence = np.empty(len(marked), dtype=np.int64)
    occurrence[number.ravel()] = np.arange(number.size)
    inside = np.flatnonzero(edge < 0)
    slot = occurrence[wanted[inside]]
    face = mesh.face[triangles[slot // 3]]
    uv = middle_uv.reshape(-1, 2)[slot]
    for (f,), group in groups(face[:, None]):
        points[inside[group]] = shape.faces[f].derivatives(uv[group])[0]
