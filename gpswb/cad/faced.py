# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh whose triangles know their face: what every mesher delivers in the end."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gpswb.core.mesh import BoolArray, FloatArray, IntArray


@dataclass(frozen=True, eq=False)
class FacedMesh:
    """(n, 3) vertices in mm, (m, 3) triangles counter-clockwise from outside, (m,) face of each."""

    vertices: FloatArray
    triangles: IntArray
    face: IntArray

    def compact(self) -> FacedMesh:
        """The same without vertices that no triangle uses."""
        used, triangles = np.unique(self.triangles, return_inverse=True)
        return FacedMesh(self.vertices[used], triangles.reshape(-1, 3), self.face)


def join(meshes: Sequence[FacedMesh]) -> FacedMesh:
    """Put meshes side by side; nothing is welded."""
    offset = np.cumsum([0, *(len(m.vertices) for m in meshes)])
    return FacedMesh(
        np.concatenate([np.empty((0, 3)), *(m.vertices for m in meshes)]),
        np.concatenate(
            [
                np.empty((0, 3), np.int64),
                *(m.triangles + o for m, o in zip(meshes, offset, strict=False)),
            ]
        ),
        np.concatenate([np.empty(0, np.int64), *(m.face for m in meshes)]),
    )


def open_sides(triangles: IntArray) -> BoolArray:
    """(m, 3) sides that belong to one triangle only."""
    ends = np.sort(np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2), axis=2)
    key = ends[..., 0].ravel() * np.int64(triangles.max(initial=0) + 1) + ends[..., 1].ravel()
    _, inverse, count = np.unique(key, return_inverse=True, return_counts=True)
    single: BoolArray = (count[inverse.ravel()] == 1).reshape(-1, 3)
    return single
