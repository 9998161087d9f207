# SPDX-License-Identifier: LGPL-2.1-or-later
"""Even out the vertices inside faces: each moves towards the middle of its neighbours."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from gpswb.cad.kernel import Shape
from gpswb.cad.weld import Tessellation
from gpswb.core.mesh import FloatArray

_TURNS = 3
_STEP = 0.7


def smooth(mesh: Tessellation, shape: Shape) -> Tessellation:
    """Laplacian smoothing in parameter space, points evaluated exactly on the surface again (their
    normals aren't: nothing reads them any more).

    Vertices on B-rep edges stay. A move that makes the worst triangle around the vertex worse, in
    space or by turning one over in parameter space, isn't made.
    """
    for _ in range(_TURNS):
        mesh = _smooth_once(mesh, shape)
    return mesh


def _smooth_once(mesh: Tessellation, shape: Shape) -> Tessellation:
    n = len(mesh.vertices)
    corner = mesh.triangles.ravel()
    fixed = np.zeros(n, dtype=bool)
    rim = mesh.edge >= 0
    fixed[mesh.triangles[rim]] = True
    fixed[np.roll(mesh.triangles, -1, axis=1)[rim]] = True
    fixed[mesh.triangles[(mesh.free > 0).any(axis=1)]] = True
    bare = np.array([face.kind is None for face in shape.faces])
    fixed[mesh.triangles[bare[mesh.face] | np.isnan(mesh.uv).any(axis=(1, 2))]] = True
    # A vertex inside a face has the same parameters in all its triangles: take any one corner.
    at = np.zeros(n, dtype=np.int64)
    at[corner] = np.arange(len(corner))
    uv = mesh.uv.reshape(-1, 2)[at]
    total, weight = np.zeros((n, 2)), np.bincount(corner, minlength=n)
    for axis in (0, 1):
        others = (mesh.uv[..., axis].sum(axis=1)[:, None] - mesh.uv[..., axis]) / 2
        total[:, axis] = np.bincount(corner, others.ravel(), minlength=n)
    move = np.flatnonzero(~fixed & (weight > 0))
    target = uv.copy()
    target[move] += _STEP * (total[move] / weight[move, None] - uv[move])
    points = mesh.vertices.copy()
    face = mesh.face[at // 3]
    order = move[np.argsort(face[move], kind="stable")]
    start = np.flatnonzero(np.diff(face[order], prepend=-1))
    for group in np.split(order, start[1:]) if len(order) else []:
        surface = shape.faces[int(face[group[0]])]
        points[group] = surface.derivatives(target[group])[0]
    moved = np.zeros(n, dtype=bool)
    moved[move] = True
    # Moves interact: those that spoil a triangle are taken back until none does.
    before = _worst_around(mesh, mesh.vertices, mesh.uv)
    for _ in range(10):
        new_points = np.where(moved[:, None], points, mesh.vertices)
        new_uv = np.where(moved[mesh.triangles][..., None], target[mesh.triangles], mesh.uv)
        bad = moved & (_worst_around(mesh, new_points, new_uv) < before)
        if not bad.any():
            return replace(mesh, vertices=new_points, uv=new_uv)
        moved &= ~bad
    return mesh


def _worst_around(mesh: Tessellation, points: FloatArray, uv: FloatArray) -> FloatArray:
    """(n,) quality of the worst triangle at each vertex: 1 equilateral, 0 flat, below 0 turned over
    in parameter space."""
    p = points[mesh.triangles]
    along = np.roll(p, -1, axis=1) - p
    area2 = np.linalg.norm(np.cross(along[:, 0], along[:, 1]), axis=1)
    squares = np.einsum("ijk,ijk->i", along, along)
    quality = 2 * np.sqrt(3.0) * area2 / np.maximum(squares, 1e-300)
    a, b = uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]
    signed = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    # Which way is up in parameter space depends on the face's orientation: ask the old triangles.
    old = mesh.uv
    c, d = old[:, 1] - old[:, 0], old[:, 2] - old[:, 0]
    up = np.sign(c[:, 0] * d[:, 1] - c[:, 1] * d[:, 0])
    quality = np.where(signed * up > 0, quality, -1.0)
    worst = np.full(len(mesh.vertices), np.inf)
    np.minimum.at(worst, mesh.triangles.ravel(), np.repeat(quality, 3))
    return worst
