# SPDX-License-Identifier: LGPL-2.1-or-later
"""Delaunay triangles of a point cloud, each with its smallest empty sphere."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial import Delaunay, QhullError

from gpswb.core.mesh import FloatArray, IntArray
from gpswb.errors import InputError
from gpswb.sentence import Sentence

JITTER = 1e-5
"""Displacement, in mean spacings, that breaks ties: points on a grid or in one plane have no unique
Delaunay tetrahedra. Only the topology is taken from the displaced points."""

SEED = 18183
"""Seed of the displacement, so that a run can be repeated."""


@dataclass(frozen=True, eq=False)
class EmptySpheres:
    """Triangles of the Delaunay tetrahedra of a cloud.

    Args:
        triangles: (t, 3) int64, each row rising.
        radius: (t,) radius of the smallest sphere through the three corners that holds no point of
            the cloud inside (Cohen-Steiner and Da 2004, section 2), mm.
    """

    triangles: IntArray
    radius: FloatArray


def empty_spheres(points: FloatArray, spacing: float) -> EmptySpheres:
    """Every Delaunay triangle of the points.

    Args:
        points: (n, 3), distinct, n >= 4; mm.
        spacing: typical distance of neighbours, mm.

    Raises:
        InputError: the points lie on a line or a point.
    """
    random = np.random.default_rng(SEED)
    x = (points - points.mean(axis=0)) / spacing
    x = x + random.uniform(-JITTER, JITTER, x.shape)
    try:
        mesh = Delaunay(x)
    except QhullError as error:
        raise InputError(
            Sentence("{n} points span no surface: they lie on a line", n=len(points))
        ) from error
    tetra = mesh.simplices.astype(np.int64)
    centre = _tetra_centres(x, tetra)
    t = len(tetra)
    opposite = np.array([[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]])
    own = np.repeat(np.arange(t), 4)
    other = mesh.neighbors.astype(np.int64).ravel()
    once = other < own  # -1, outside, included
    own, other = own[once], other[once]
    corner = np.sort(tetra[:, opposite].reshape(-1, 3)[once], axis=1)
    a, b, c = (x[corner[:, k]] for k in range(3))
    middle = _triangle_centres(a, b, c)
    # The centres of spheres through the corners lie on the line through `middle` across the
    # triangle; those of empty ones between the centres of the two tetrahedra.
    normal = np.cross(b - a, c - a)
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
    first = np.einsum("ij,ij->i", centre[own] - middle, normal)
    second = np.einsum("ij,ij->i", centre[other] - middle, normal)
    # Outside the hull there is no tetrahedron: the line goes on for ever, away from the first.
    apex = x[tetra.ravel()[np.flatnonzero(once)]]
    side = np.sign(np.einsum("ij,ij->i", apex - a, normal))
    second = np.where(other < 0, -side * np.inf, second)
    low, high = np.minimum(first, second), np.maximum(first, second)
    off = np.maximum(0.0, np.maximum(low, -high))
    radius = np.sqrt(np.einsum("ij,ij->i", middle - a, middle - a) + off**2)
    return EmptySpheres(corner, spacing * np.nan_to_num(radius, nan=np.inf))


def _tetra_centres(x: FloatArray, tetra: IntArray) -> FloatArray:
    """(t, 3) centres of the spheres through the corners; far away for a flat tetrahedron."""
    a = x[tetra[:, 0]]
    u, v, w = (x[tetra[:, k]] - a for k in (1, 2, 3))
    vw, wu, uv = np.cross(v, w), np.cross(w, u), np.cross(u, v)
    volume = 2.0 * np.einsum("ij,ij->i", u, vw)
    volume = np.where(np.abs(volume) < 1e-300, 1e-300, volume)
    uu, vv, ww = (np.einsum("ij,ij->i", s, s)[:, None] for s in (u, v, w))
    centre: FloatArray = a + (uu * vw + vv * wu + ww * uv) / volume[:, None]
    return centre


def _triangle_centres(a: FloatArray, b: FloatArray, c: FloatArray) -> FloatArray:
    """(t, 3) circumcentres."""
    u, v = b - a, c - a
    n = np.cross(u, v)
    nn = np.maximum(np.einsum("ij,ij->i", n, n), 1e-300)[:, None]
    uu, vv = (np.einsum("ij,ij->i", s, s)[:, None] for s in (u, v))
    centre: FloatArray = a + (uu * np.cross(v, n) + vv * np.cross(n, u)) / (2.0 * nn)
    return centre
