# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exact outward normals and arc lengths of a face's surface, for either kernel."""

from __future__ import annotations

import numpy as np

from gpswb.cad.kernel import BrepFace
from gpswb.core.mesh import FloatArray

_NUDGE = 1e-5
"""Step towards the middle of the face, as a fraction of it, where the surface has no normal: at a
pole or an apex the limit is wanted, and there is no need for it to be exact."""
_NEWTON_STEPS = 6
"""Most steps to a nearest point: the start is near, each step squares what is left."""


def outward_normals(face: BrepFace, uv: FloatArray) -> FloatArray:
    """(k, 3) exact unit normals out of the solid at the parameters (k, 2)."""
    _, du, dv = face.derivatives(uv)
    normal, good = _unit_cross(du, dv)
    if not good.all():
        u0, u1, v0, v1 = face.bounds
        middle = np.array([(u0 + u1) / 2, (v0 + v1) / 2])
        nudged = uv[~good] + _NUDGE * (middle - uv[~good])
        _, du, dv = face.derivatives(nudged)
        normal[~good] = _unit_cross(du, dv)[0]
    return normal * face.outward


def _unit_cross(du: FloatArray, dv: FloatArray) -> tuple[FloatArray, np.ndarray]:
    cross = np.cross(du, dv)
    size = np.linalg.norm(cross, axis=1)
    scale = np.max(np.linalg.norm(du, axis=1) * np.linalg.norm(dv, axis=1), initial=0.0)
    good = size > 1e-9 * scale
    return np.divide(cross, size[:, None], out=np.zeros_like(cross), where=size[:, None] > 0), good


def arc_lengths(face: BrepFace, samples: int = 17) -> tuple[FloatArray, FloatArray]:
    """Cumulated length (mm) of the face's u and v lines at evenly spaced parameters, (samples,)
    each: the mean over five lines across the face's parameter box."""
    u0, u1, v0, v1 = face.bounds
    along, across = np.linspace(0, 1, samples), np.linspace(0.1, 0.9, 5)
    tables = []
    for axis in (0, 1):
        uv = np.empty((5, samples, 2))
        uv[..., axis] = along[None, :]
        uv[..., 1 - axis] = across[:, None]
        uv = uv * [u1 - u0, v1 - v0] + [u0, v0]
        point = face.derivatives(uv.reshape(-1, 2))[0].reshape(5, samples, 3)
        step = np.linalg.norm(np.diff(point, axis=1), axis=2).mean(axis=0)
        tables.append(np.concatenate([[0.0], np.cumsum(step)]))
    return tables[0], tables[1]


def largest_curvature(face: BrepFace, uv: FloatArray) -> FloatArray:
    """(k,) largest absolute principal curvature (1/mm) at the parameters (k, 2).

    By central differences of the exact normals: good to about 1e-6, enough to size a mesh.
    """
    u0, u1, v0, v1 = face.bounds
    step = 1e-4 * np.array([max(u1 - u0, 1e-12), max(v1 - v0, 1e-12)])
    _, du, dv = face.derivatives(uv)
    turns = []
    for axis in (0, 1):
        shift = np.zeros(2)
        shift[axis] = step[axis]
        change = outward_normals(face, uv + shift) - outward_normals(face, uv - shift)
        turns.append(change / (2 * step[axis]))
    # Shape operator: (first fundamental form)^-1 (second), whose eigenvalues are the curvatures.
    first = [np.einsum("ij,ij->i", a, b) for a, b in ((du, du), (du, dv), (dv, dv))]
    second = [
        np.einsum("ij,ij->i", a, b)
        for a, b in ((turns[0], du), (turns[0], dv), (turns[1], du), (turns[1], dv))
    ]
    e, f, g = first
    determinant = e * g - f * f
    flat = determinant <= 1e-18 * (e + g) ** 2
    safe = np.where(flat, 1.0, determinant)
    mean = (g * second[0] - f * second[1] - f * second[2] + e * second[3]) / (2 * safe)
    gauss = (second[0] * second[3] - second[1] * second[2]) / safe
    largest = np.abs(mean) + np.sqrt(np.maximum(mean**2 - gauss, 0.0))
    return np.where(flat, np.inf, largest)


def nearest_uv(face: BrepFace, points: FloatArray, uv: FloatArray, enough: float) -> FloatArray:
    """(k, 2) parameters whose surface points lie nearest to ``points`` (k, 3), by Gauss-Newton
    steps from ``uv`` (k, 2), within the face's parameter box.

    Points that ``uv`` meets within ``enough`` (mm) stay as they are; a step that leads further away
    isn't made.
    """
    best = uv.copy()
    at, du, dv = face.derivatives(uv)
    gap = np.linalg.norm(points - at, axis=1)
    todo = np.flatnonzero(gap > enough)
    low, high = np.array(face.bounds[0::2]), np.array(face.bounds[1::2])
    at, du, dv = at[todo], du[todo], dv[todo]
    for _ in range(_NEWTON_STEPS):
        if not len(todo):
            break
        rest = points[todo] - at
        e, f, g = (np.einsum("ij,ij->i", a, b) for a, b in ((du, du), (du, dv), (dv, dv)))
        x, y = np.einsum("ij,ij->i", rest, du), np.einsum("ij,ij->i", rest, dv)
        determinant = e * g - f * f
        regular = determinant > 1e-12 * e * g
        todo, e, f, g, x, y = (a[regular] for a in (todo, e, f, g, x, y))
        step = np.column_stack([g * x - f * y, e * y - f * x]) / determinant[regular, None]
        tried = np.clip(best[todo] + step, low, high)
        at, du, dv = face.derivatives(tried)
        now = np.linalg.norm(points[todo] - at, axis=1)
        better = now < 0.99 * gap[todo]
        best[todo[better]], gap[todo[better]] = tried[better], now[better]
        todo, at, du, dv = todo[better], at[better], du[better], dv[better]
    return best
