# SPDX-License-Identifier: LGPL-2.1-or-later
"""The triangle mesh that every algorithm reads."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.int64]
BoolArray = npt.NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Mesh:
    """A triangle mesh: an immutable value; what is derived from it is computed once.

    Args:
        vertices: (n, 3) float64, mm, finite.
        triangles: (m, 3) int64 indices into ``vertices``, counter-clockwise seen from outside.

    Raises:
        ValueError: wrong shapes, non-finite coordinates, or an index out of range.
    """

    vertices: FloatArray
    triangles: IntArray

    def __post_init__(self) -> None:
        vertices = np.ascontiguousarray(self.vertices, dtype=np.float64)
        triangles = np.ascontiguousarray(self.triangles, dtype=np.int64)
        if vertices.ndim != 2 or vertices.shape[1] != 3:
            raise ValueError(f"vertices must have shape (n, 3), not {vertices.shape}")
        if triangles.ndim != 2 or triangles.shape[1] != 3:
            raise ValueError(f"triangles must have shape (m, 3), not {triangles.shape}")
        if not np.isfinite(vertices).all():
            bad = int((~np.isfinite(vertices).all(axis=1)).sum())
            raise ValueError(
                f"{bad} of {len(vertices)} vertices have a coordinate that is not finite"
            )
        if len(triangles) and (triangles.min() < 0 or triangles.max() >= len(vertices)):
            raise ValueError(
                f"triangles refer to vertices {triangles.min()}..{triangles.max()}, "
                f"but there are {len(vertices)}"
            )
        # Views, so that freezing them does not freeze the caller's own arrays.
        vertices, triangles = vertices.view(), triangles.view()
        vertices.flags.writeable = False
        triangles.flags.writeable = False
        object.__setattr__(self, "vertices", vertices)
        object.__setattr__(self, "triangles", triangles)

    @cached_property
    def corners(self) -> FloatArray:
        """(m, 3, 3) coordinates of each facet's corners, mm."""
        return self.vertices[self.triangles]

    @cached_property
    def _cross(self) -> FloatArray:
        c = self.corners
        cross = np.cross(c[:, 1] - c[:, 0], c[:, 2] - c[:, 0])
        return np.asarray(cross, dtype=np.float64)

    @cached_property
    def areas(self) -> FloatArray:
        """(m,) facet areas, mm²."""
        area: FloatArray = 0.5 * np.linalg.norm(self._cross, axis=1)
        return area

    @cached_property
    def facet_normals(self) -> FloatArray:
        """(m, 3) unit facet normals; zero for a degenerate facet."""
        length = 2.0 * self.areas[:, None]
        normals: FloatArray = np.divide(
            self._cross, length, out=np.zeros(self._cross.shape), where=length > 0
        )
        return normals

    @cached_property
    def centroids(self) -> FloatArray:
        """(m, 3) facet centroids, mm."""
        centroids: FloatArray = self.corners.mean(axis=1)
        return centroids

    @cached_property
    def diagonal(self) -> float:
        """Diagonal of the bounding box, mm; 0 for an empty mesh."""
        if not len(self.vertices):
            return 0.0
        return float(np.linalg.norm(np.ptp(self.vertices, axis=0)))

    @cached_property
    def facet_pairs(self) -> IntArray:
        """(e, 2) facets that share a manifold interior edge, first < second."""
        return self._edge_tables[0]

    @cached_property
    def pair_edges(self) -> IntArray:
        """(e, 2) vertices of the edge shared by each row of ``facet_pairs``."""
        return self._edge_tables[1]

    @cached_property
    def _edge_tables(self) -> tuple[IntArray, IntArray]:
        m = len(self.triangles)
        ends = self.triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
        ends = np.sort(ends, axis=1)
        key = ends[:, 0] * np.int64(max(len(self.vertices), 1)) + ends[:, 1]
        order = np.argsort(key, kind="stable")
        sorted_key = key[order]
        start = np.flatnonzero(np.r_[True, sorted_key[1:] != sorted_key[:-1]])
        count = np.diff(np.r_[start, len(sorted_key)])
        # An edge of three or more facets has no single neighbour across it: it is left as a border.
        first = start[count == 2]
        facet = np.repeat(np.arange(m, dtype=np.int64), 3)
        pairs = np.sort(np.column_stack([facet[order[first]], facet[order[first + 1]]]), axis=1)
        return pairs, ends[order[first]]
