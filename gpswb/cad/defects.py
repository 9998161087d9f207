# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is wrong with a mesh whose triangles know their face, whatever made it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gpswb.cad.faced import FacedMesh
from gpswb.core.mesh import BoolArray, FloatArray, IntArray

_FLAT = 1e-9
"""Height of a triangle without area, as a fraction of the mesh's diagonal."""
_FOLD_COSINE = -0.5
"""Cosine between the normals of two facets of one face that are folded: they turn by over 120
degrees, and no density that this program offers turns so far in one step."""


@dataclass(frozen=True)
class Defects:
    """Counts of a mesh's defects.

    Args:
        flat: triangles without area.
        folded: pairs of adjacent facets of one face, with area, that turn by over 120 degrees.
        single: sides of one triangle only: borders of an open shell, or gaps.
        crowded: sides where more than two triangles meet, or two that look opposite ways.
    """

    flat: int
    folded: int
    single: int
    crowded: int


def find_defects(mesh: FacedMesh) -> Defects:
    """Count the defects of a mesh."""
    normal, height = facet_normals(mesh)
    flat = flat_triangles(mesh, height)
    first, second = adjacent_facets(mesh.triangles)
    turned = np.einsum("ij,ij->i", normal[first], normal[second]) < _FOLD_COSINE
    sound = ~flat[first] & ~flat[second] & (mesh.face[first] == mesh.face[second])
    single, crowded = _sides(mesh.triangles)
    return Defects(int(flat.sum()), int((turned & sound).sum()), single, crowded)


def flat_triangles(mesh: FacedMesh, height: FloatArray) -> BoolArray:
    """(m,) triangles without area, by their least ``height`` (m,), mm."""
    flat: BoolArray = height <= _FLAT * float(np.linalg.norm(np.ptp(mesh.vertices, axis=0)))
    return flat


def facet_normals(mesh: FacedMesh) -> tuple[FloatArray, FloatArray]:
    """(m, 3) unit normals of the triangles, 0 for one without area, and (m,) their least heights,
    mm."""
    corner = mesh.vertices[mesh.triangles]
    cross = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    double_area = np.linalg.norm(cross, axis=1)
    longest = np.linalg.norm(np.roll(corner, -1, axis=1) - corner, axis=2).max(axis=1)
    safe = np.where(double_area > 0, double_area, 1.0)
    return cross / safe[:, None], double_area / np.where(longest > 0, longest, 1.0)


def adjacent_facets(triangles: IntArray) -> tuple[IntArray, IntArray]:
    """Both triangles of every side that has two."""
    order, start, count = _by_side(triangles)
    start = start[count == 2]
    return order[start] // 3, order[start + 1] // 3


def _by_side(triangles: IntArray) -> tuple[IntArray, IntArray, IntArray]:
    """Flat indices 3·triangle + side sorted by side; where each begins there; its triangles."""
    tail, head = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    key = np.minimum(tail, head) * np.int64(triangles.max(initial=0) + 1) + np.maximum(tail, head)
    order = np.argsort(key, kind="stable")
    start = np.flatnonzero(np.diff(key[order], prepend=-1))
    return order, start, np.diff(np.r_[start, len(key)])


def _sides(triangles: IntArray) -> tuple[int, int]:
    """Sides of one triangle, and sides of more than two or of two that run the same way."""
    order, start, count = _by_side(triangles)
    up: BoolArray = (triangles < np.roll(triangles, -1, axis=1)).ravel()[order]
    two = start[count == 2]
    same_way = up[two] == up[two + 1]
    return int((count == 1).sum()), int((count > 2).sum() + same_way.sum())
