# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the analysis of failures asks of faces: tangency, strips, parallel and coaxial surfaces."""

from __future__ import annotations

from collections.abc import Set as AbstractSet

import numpy as np

from gpswb.cad.solid import FaceMap, FaceTruth
from gpswb.core.mesh import Mesh

TANGENT_DEG = 5.0
"""Two faces meeting at less than this, or at no more than they turn inside, are tangent."""

SAME_DIRECTION = 1e-6
"""Sine of the angle below which two directions are one."""

SAME_PLACE = 1e-6
"""Distance, mm, relative to the size of the coordinates, below which two places are one."""


class FaceGeometry:
    """Borders between the faces of a tessellated shape and the turning inside each face."""

    def __init__(self, mesh: Mesh, facemap: FaceMap) -> None:
        f = len(facemap.faces)
        self.total_area = float(mesh.areas.sum())
        self._face = facemap.face_of_triangle
        self._normals = mesh.facet_normals
        a, b = mesh.facet_pairs.T
        fa, fb = self._face[a], self._face[b]
        n0, n1 = mesh.facet_normals[a], mesh.facet_normals[b]
        angle = np.degrees(
            np.arctan2(np.linalg.norm(np.cross(n0, n1), axis=1), np.einsum("ij,ij->i", n0, n1))
        )
        solid = (mesh.areas[a] > 0) & (mesh.areas[b] > 0) & (fa >= 0) & (fb >= 0)
        inside = solid & (fa == fb)
        self._pairs_inside = (a[inside], b[inside])
        turn = np.zeros(f)
        np.maximum.at(turn, fa[inside], angle[inside])
        across = solid & (fa != fb)
        low, high = np.minimum(fa, fb)[across], np.maximum(fa, fb)[across]
        pair, inverse = np.unique(low * f + high, return_inverse=True)
        order = np.lexsort((angle[across], inverse))
        start = np.searchsorted(inverse[order], np.arange(len(pair)))
        size = np.bincount(inverse, minlength=len(pair))
        median = angle[across][order[start + size // 2]] if len(pair) else np.zeros(0)
        one, two = np.divmod(pair, max(f, 1))
        smooth = median <= np.maximum(TANGENT_DEG, np.maximum(turn[one], turn[two]))
        self._tangent: list[set[int]] = [set() for _ in range(f)]
        for i, j in zip(one[smooth].tolist(), two[smooth].tolist(), strict=True):
            self._tangent[i].add(j)
            self._tangent[j].add(i)

    def tangent_to_any(self, i: int, others: AbstractSet[int]) -> bool:
        """Face ``i`` shares a border at which the surface does not bend with one of ``others``."""
        return not self._tangent[i].isdisjoint(others)

    def is_strip(self, i: int, turn_deg: float) -> bool:
        """One open row of triangles whose normals stay within ``turn_deg`` of one another."""
        mine = np.flatnonzero(self._face == i)
        a, b = self._pairs_inside
        inside = self._face[a] == i
        degree = np.bincount(np.searchsorted(mine, np.r_[a[inside], b[inside]]), minlength=1)
        if degree.max(initial=0) > 2 or inside.sum() >= len(mine):
            return False
        n = self._normals[mine]
        widest = float((n @ n.T).min()) if len(mine) <= 2000 else -1.0
        return bool(widest > np.cos(np.radians(turn_deg)))


def _line(truth: FaceTruth) -> tuple[np.ndarray, np.ndarray] | None:
    point, direction = truth.parameters.get("point"), truth.parameters.get("direction")
    if point is None or direction is None:
        return None
    return np.array(point), np.array(direction)


def _sizes(truth: FaceTruth) -> dict[str, list[float]]:
    """The surface's lengths and angles, to nine digits."""
    return {
        name: [float(f"{value:.9g}") for value in values]
        for name, values in truth.parameters.items()
        if name not in ("point", "direction")
    }


def parallel_planes(a: FaceTruth, b: FaceTruth) -> bool:
    """Two planes that are parallel but not coplanar."""
    one, two = _line(a), _line(b)
    if a.surface != "Plane" or b.surface != "Plane" or one is None or two is None:
        return False
    (p, n), (q, m) = one, two
    scale = max(1.0, float(np.abs([p, q]).max()))
    parallel = np.linalg.norm(np.cross(n, m)) < SAME_DIRECTION
    return bool(parallel and abs((q - p) @ n) > SAME_PLACE * scale)


def coaxial(a: FaceTruth, b: FaceTruth) -> bool:
    """Two surfaces of different kind or size, not planes, with one axis."""
    one, two = _line(a), _line(b)
    if "Plane" in (a.surface, b.surface) or one is None or two is None:
        return False
    if a.surface == b.surface and _sizes(a) == _sizes(b):
        return False
    (p, d), (q, e) = one, two
    scale = max(1.0, float(np.abs([p, q]).max()))
    parallel = np.linalg.norm(np.cross(d, e)) < SAME_DIRECTION
    return bool(parallel and np.linalg.norm(np.cross(q - p, d)) < SAME_PLACE * scale)
