# SPDX-License-Identifier: LGPL-2.1-or-later
"""Delaunay flips inside faces: the diagonal of two triangles goes where their angles are better."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from gpswb.cad.split import distinct_sides
from gpswb.cad.weld import Tessellation
from gpswb.core.mesh import BoolArray, FloatArray, IntArray

_GAIN = 1e-6
"""Least gain (sum of opposite angles above pi, rad): equal diagonals must not flip for ever."""

LEAST_COSINE = 0.3
"""Between the normal of a facet and the exact ones: a facet below stands across its surface."""
_PER_TRIANGLE = ("triangles", "face", "uv", "normal", "edge", "side", "ends", "free")


def flip(mesh: Tessellation, fresh: BoolArray | None = None, rounds: int = 12) -> Tessellation:
    """Flip sides inside faces until Delaunay (opposite angles in space sum to at most pi).

    A flip is made only where the two new triangles lie the right way up in parameter space and
    agree with the exact normals; sides on B-rep edges stay as they are. A triangle that is turned
    over in parameter space is flipped away if it can be: a vertex may have moved across a side when
    it went from a chord to its curved edge.

    Args:
        mesh: the tessellation.
        fresh: (m,) triangles that have changed since the last flips; None for all.
        rounds: at most so many rounds; the work shrinks from one to the next.
    """
    fresh = np.ones(len(mesh.triangles), dtype=bool) if fresh is None else fresh
    up = upward(mesh)
    out = {name: getattr(mesh, name).copy() for name in _PER_TRIANGLE}
    for _ in range(rounds):
        rows = _around(out["triangles"], fresh, len(mesh.vertices))
        part = replace(mesh, **{name: array[rows] for name, array in out.items()})
        first, second = _pairs(part)
        chosen = _choose(part, up[rows], first, second) if len(first) else np.zeros(0, dtype=bool)
        if not chosen.any():
            break
        first, second = first[chosen], second[chosen]
        part = _apply(part, first, second)
        for name, array in out.items():
            array[rows] = getattr(part, name)
        fresh = np.zeros(len(mesh.triangles), dtype=bool)
        fresh[rows[first // 3]] = True
        fresh[rows[second // 3]] = True
    return replace(mesh, **out)


def _around(triangles: IntArray, fresh: BoolArray, n: int) -> IntArray:
    """Rows of the fresh triangles and of those that may share a side with one."""
    touched = np.zeros(n, dtype=bool)
    touched[triangles[fresh]] = True
    return np.flatnonzero(touched[triangles].sum(axis=1) >= 2)


def _pairs(mesh: Tessellation) -> tuple[IntArray, IntArray]:
    """Flat indices 3·triangle + side of both occurrences of every side that may flip."""
    sides = distinct_sides(mesh)
    number = sides.number.ravel()
    order = np.argsort(number, kind="stable")
    start = np.cumsum(np.r_[0, sides.count[:-1]])[sides.count == 2]
    first, second = order[start], order[start + 1]
    rim = mesh.edge.ravel() >= 0
    good = ~rim[first]
    return first[good], second[good]


def _corners(mesh: Tessellation, side: IntArray) -> tuple[IntArray, IntArray]:
    """Triangle and local corners (q, 3): start, end and apex of the side."""
    return side // 3, (side % 3)[:, None] + np.array([0, 1, 2])


def _choose(mesh: Tessellation, up: FloatArray, first: IntArray, second: IntArray) -> BoolArray:
    area = up * chart_area(mesh.uv, mesh.free)
    gain = _gain(mesh, first, second)
    # A triangle that is turned over goes away, or gets smaller, whatever the angles say.
    least = np.minimum(area[first // 3], area[second // 3])
    gain[least < 0] += 2 * np.pi
    rows = np.flatnonzero(gain > _GAIN)
    gain, least = gain[rows], least[rows]
    t1, c1 = _corners(mesh, first[rows])
    t2, c2 = _corners(mesh, second[rows])
    at1, at2 = (t1[:, None], c1 % 3), (t2, c2[:, 2] % 3)
    ids, apex = mesh.triangles[at1], mesh.triangles[at2]
    a, b, c, d = (mesh.vertices[i] for i in (ids[:, 0], ids[:, 1], ids[:, 2], apex))
    # Corners a, b, c, d of the quadrilateral with their parameters.
    uv = np.concatenate([mesh.uv[at1], mesh.uv[at2][:, None]], axis=1)
    free = np.concatenate([mesh.free[at1], mesh.free[at2][:, None]], axis=1)
    new1, new2 = (up[t1] * chart_area(uv[:, k], free[:, k]) for k in ([0, 3, 2], [3, 1, 2]))
    margin = 1e-3 * (np.abs(area[t1]) + np.abs(area[t2]))
    normal = mesh.normal[t1].mean(axis=1) + mesh.normal[t2].mean(axis=1)
    wanted = np.minimum(new1, new2) > np.minimum(least, 0.0) + margin
    wanted &= _agrees(normal, d - a, c - a) | (new1 < 0)
    wanted &= _agrees(normal, b - d, c - d) | (new2 < 0)
    wanted &= (apex != ids[:, 2]) & ~_joined(mesh, ids[:, 2], apex)
    # A triangle takes part in its best flip only.
    best = np.zeros(len(mesh.triangles))
    worth = np.where(wanted, gain, 0.0)
    np.maximum.at(best, t1, worth)
    np.maximum.at(best, t2, worth)
    wanted &= (worth == best[t1]) & (worth == best[t2])
    # Equal gains may still meet in a triangle: the last writer wins.
    owner = np.full(len(mesh.triangles), -1, dtype=np.int64)
    left = np.flatnonzero(wanted)
    owner[t1[left]] = left
    owner[t2[left]] = left
    chosen = np.zeros(len(first), dtype=bool)
    chosen[rows[left]] = (owner[t1[left]] == left) & (owner[t2[left]] == left)
    return chosen


def _gain(mesh: Tessellation, first: IntArray, second: IntArray) -> FloatArray:
    """By how much the angles opposite each side exceed pi, rad."""
    t1, c1 = _corners(mesh, first)
    t2, c2 = _corners(mesh, second)
    ids, apex = mesh.triangles[t1[:, None], c1 % 3], mesh.triangles[t2, c2[:, 2] % 3]
    a, b, c, d = (mesh.vertices[i] for i in (ids[:, 0], ids[:, 1], ids[:, 2], apex))
    gain: FloatArray = _angle(a, c, b) + _angle(a, d, b) - np.pi
    return gain


def _joined(mesh: Tessellation, c: IntArray, d: IntArray) -> BoolArray:
    """Whether a side joins these vertices already: a second one would have four triangles."""
    n = np.int64(len(mesh.vertices))
    tail, head = mesh.triangles.ravel(), np.roll(mesh.triangles, -1, axis=1).ravel()
    sides = np.minimum(tail, head) * n + np.maximum(tail, head)
    wanted = np.minimum(c, d) * n + np.maximum(c, d)
    _, first = np.unique(wanted, return_index=True)
    again = np.ones(len(wanted), dtype=bool)
    again[first] = False
    joined: BoolArray = np.isin(wanted, sides) | again
    return joined


def _apply(mesh: Tessellation, first: IntArray, second: IntArray) -> Tessellation:
    t1, c1 = _corners(mesh, first)
    t2, c2 = _corners(mesh, second)
    i1, i2 = c1 % 3, c2 % 3
    out: dict[str, np.ndarray] = {}
    for name in ("triangles", "uv", "normal", "free"):
        array = getattr(mesh, name).copy()
        a, b, c = (array[t1, i1[:, k]] for k in range(3))
        d = array[t2, i2[:, 2]]
        array[t1] = np.stack([a, d, c], axis=1)
        array[t2] = np.stack([d, b, c], axis=1)
        out[name] = array
    inside = {"edge": -1, "side": 0, "ends": 0.0}
    for name, fill in inside.items():
        array = getattr(mesh, name).copy()
        # Sides of the first triangle: a-b (gone), b-c, c-a; of the second: b-a, a-d, d-b.
        bc, ca = array[t1, i1[:, 1]], array[t1, i1[:, 2]]
        ad, db = array[t2, i2[:, 1]], array[t2, i2[:, 2]]
        none = np.full_like(bc, fill)
        array[t1] = np.stack([ad, none, ca], axis=1)
        array[t2] = np.stack([db, bc, none], axis=1)
        out[name] = array
    return replace(mesh, **out)


def _agrees(normal: FloatArray, x: FloatArray, y: FloatArray) -> BoolArray:
    """Whether the triangle on x and y looks the same way as the normal, within about 70 degrees."""
    cross = np.cross(x, y)
    bound = LEAST_COSINE * np.linalg.norm(cross, axis=1) * np.linalg.norm(normal, axis=1)
    dot: FloatArray = np.einsum("ij,ij->i", normal, cross)
    agrees: BoolArray = (dot > bound) & (dot > 0)
    return agrees


def _angle(p: FloatArray, q: FloatArray, r: FloatArray) -> FloatArray:
    """Angle at q."""
    x, y = p - q, r - q
    cross = np.linalg.norm(np.cross(x, y), axis=1)
    angle: FloatArray = np.arctan2(cross, np.einsum("ij,ij->i", x, y))
    return angle


def chart_area(uv: FloatArray, free: IntArray) -> FloatArray:
    """(t,) twice the signed areas in parameter space of triangles (t, 3, 2), where a parameter
    without meaning (``free`` (t, 3), see `Tessellation`) is the mean of the other corners'."""
    poles = np.flatnonzero(free[:, 0] | free[:, 1] | free[:, 2])
    if len(poles):
        uv = uv.copy()
        for axis in (0, 1):
            lost, at = free[poles] == axis + 1, uv[poles, :, axis]
            known = np.where(lost, 0.0, at).sum(axis=1) / np.maximum((~lost).sum(axis=1), 1)
            uv[poles, :, axis] = np.where(lost, known[:, None], at)
    x, y = uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]
    area: FloatArray = x[:, 0] * y[:, 1] - x[:, 1] * y[:, 0]
    return area


def upward(mesh: Tessellation) -> FloatArray:
    """(m,) +1 where the triangles of a face run counter-clockwise in its parameter space, -1 where
    they run clockwise: most decide, some may be turned over."""
    area = np.nan_to_num(chart_area(mesh.uv, mesh.free))
    by_face = np.bincount(mesh.face, area)
    return np.where(by_face < 0, -1.0, 1.0)[mesh.face]
