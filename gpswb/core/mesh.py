# SPDX-License-Identifier: LGPL-2.1-or-later
"""The triangle mesh that every algorithm reads."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

from gpswb.core.bent_facets import bent_facets
from gpswb.core.facet_geometry import areas_and_normals, centroids, turning_angles
from gpswb.core.half_edges import interior_edges

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
    def columns(self) -> FloatArray:
        """(3, n) coordinates of the vertices, axis by axis: gathered and computed with faster."""
        return np.ascontiguousarray(self.vertices.T)

    @cached_property
    def corners(self) -> FloatArray:
        """(m, 3, 3) coordinates of each facet's corners, mm."""
        return self.vertices[self.triangles]

    def corners_of(self, facets: IntArray) -> FloatArray:
        """(k, 3, 3) coordinates of the corners of some facets, mm."""
        return self.vertices[self.triangles[facets]]

    @cached_property
    def _areas_and_normals(self) -> tuple[FloatArray, FloatArray]:
        return areas_and_normals(self.columns, self.triangles)

    @property
    def areas(self) -> FloatArray:
        """(m,) facet areas, mm²."""
        return self._areas_and_normals[0]

    @property
    def facet_normals(self) -> FloatArray:
        """(m, 3) unit facet normals; zero for a degenerate facet."""
        return self._areas_and_normals[1]

    @cached_property
    def centroids(self) -> FloatArray:
        """(m, 3) facet centroids, mm."""
        return centroids(self.columns, self.triangles)

    @cached_property
    def diagonal(self) -> float:
        """Diagonal of the bounding box, mm; 0 for an empty mesh."""
        if not len(self.vertices):
            return 0.0
        return float(np.linalg.norm(np.ptp(self.vertices, axis=0)))

    @cached_property
    def _interior_edges(self) -> tuple[IntArray, IntArray]:
        return interior_edges(self.triangles, len(self.vertices))

    @property
    def half_edge_pairs(self) -> IntArray:
        """(e, 2) half-edges of each manifold interior edge, the lower first."""
        return self._interior_edges[0]

    @property
    def pair_edges(self) -> IntArray:
        """(e, 2) vertices of the edge shared by each row of ``facet_pairs``, lower first."""
        return self._interior_edges[1]

    @cached_property
    def facet_pairs(self) -> IntArray:
        """(e, 2) facets that share a manifold interior edge, first < second."""
        pairs: IntArray = self.half_edge_pairs // 3
        return pairs

    @cached_property
    def turning(self) -> FloatArray:
        """(e,) angle in [0, pi], rad, between the normals of the two facets at each row of
        ``facet_pairs``; 0 beside a degenerate facet."""
        return turning_angles(self.facet_normals, self.facet_pairs)

    @cached_property
    def bent_facets(self) -> IntArray:
        """(k,) facets that don't lie in one plane with all the facets around them, ascending: only
        these can be curved."""
        return bent_facets(self)
