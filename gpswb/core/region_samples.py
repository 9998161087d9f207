# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a region's recognition looks at: its vertices, and normals that stay within it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from gpswb.core.blocks import blocks
from gpswb.core.distinct import distinct
from gpswb.core.facet_edges import at_sides, edge_lengths
from gpswb.core.facet_geometry import dot
from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.normals import wedge_normals
from gpswb.core.reference import spread
from gpswb.core.submesh import WORTHWHILE, submesh
from gpswb.core.wedges import find_wedges

_SINGULAR = 1.5  # turns to a neighbour that a normal may be off before it is not believed
_ROUNDING = 0.02  # rad, for facets that turn by nothing


@dataclass(frozen=True, eq=False)
class RegionSample:
    """One region of a mesh.

    Args:
        facets: (f,) int its facets.
        vertices: (v, 3) mm, each vertex once.
        points, normals, weights: (c, 3), (c, 3), (c,): its facets' corners, with normals confined
            to the region and a third of the facet's area.
        area: mm^2.
        size: radius of gyration of its corners, mm.
        turning: RMS turning angle of its interior edges, rad: how coarse it is.
        edge_length: root mean square of its edges' lengths, mm.
    """

    facets: IntArray
    vertices: FloatArray
    points: FloatArray
    normals: FloatArray
    weights: FloatArray
    area: float
    size: float
    turning: float
    edge_length: float

    def thinned(self, limit: int) -> RegionSample:
        """The same region with at most so many evenly spaced vertices and corners."""
        corner, vertex = spread(len(self.points), limit), spread(len(self.vertices), limit)
        return replace(
            self,
            vertices=self.vertices[vertex],
            points=self.points[corner],
            normals=self.normals[corner],
            weights=self.weights[corner],
        )


@dataclass(frozen=True, eq=False)
class CornerNormals:
    """Normals at corners of facets, each one stored once.

    Args:
        rows: (k, 3) unit normals.
        row_of_corner: (m, 3) which of them each corner has.
    """

    rows: FloatArray
    row_of_corner: IntArray

    def at(self, facets: IntArray) -> FloatArray:
        """(f, 3, 3) normals at the corners of some facets (f,)."""
        return self.rows.take(self.row_of_corner[facets], axis=0)


def confined_normals(mesh: Mesh, region: IntArray, crease: BoolArray) -> CornerNormals:
    """Corner normals averaged neither across creases nor across region borders.

    Where a vertex has no normal, at the apex of a cone, say, its corners have their facets' own.

    Args:
        mesh: the mesh.
        region: (m,) int region of each facet, -1 for facets of none, which may have any normals.
        crease: (e,) bool feature edges, aligned with ``mesh.facet_pairs``.
    """
    facets = np.flatnonzero(region >= 0)
    if len(facets) < WORTHWHILE * len(region):
        alone, crease = submesh(mesh, facets, crease)
        found = confined_normals(alone, region[facets], crease)
        row_of_corner = np.zeros((len(region), 3), dtype=np.int64)
        row_of_corner[facets] = found.row_of_corner
        return CornerNormals(found.rows, row_of_corner)
    first, second = mesh.facet_pairs.T
    barrier = crease | (region[first] != region[second])
    wedges = find_wedges(mesh, barrier)
    normals = wedge_normals(mesh, wedges)
    turning = _largest_turning(mesh, barrier)
    singular = np.empty((len(region), 3), dtype=bool)
    for part in blocks(len(region)):
        corner = normals.take(wedges.of_corner[part], axis=0)
        facet = mesh.facet_normals[part, None]
        # At an apex the mean of all sides points along the axis, far off each of them.
        cosine = dot(np.moveaxis(corner, 2, 0), np.moveaxis(facet, 2, 0))
        limit = np.minimum(_SINGULAR * turning[part] + _ROUNDING, np.pi)
        singular[part] = cosine < np.cos(limit)[:, None]
    lone, k = np.nonzero(singular)
    if not len(lone):
        return CornerNormals(normals, wedges.of_corner)
    row_of_corner = wedges.of_corner.copy()
    row_of_corner[lone, k] = len(normals) + np.arange(len(lone))
    return CornerNormals(np.concatenate([normals, mesh.facet_normals[lone]]), row_of_corner)


def _largest_turning(mesh: Mesh, barrier: BoolArray) -> FloatArray:
    """(m,) largest angle by which a facet turns to a neighbour, barriers apart, rad.

    On a smooth surface a vertex normal is off its facet's by less than that.
    """
    largest: FloatArray = at_sides(mesh, np.where(barrier, 0.0, mesh.turning)).max(axis=1)
    return largest


def region_samples(
    mesh: Mesh, region: IntArray, count: int, corner_normals: CornerNormals
) -> Iterator[RegionSample]:
    """Sample of each region 0..count-1 in order; degenerate facets are left out.

    Args:
        mesh: the mesh.
        region: (m,) int, -1 for facets of none.
        count: number of regions.
        corner_normals: see `confined_normals`.
    """
    usable = (region >= 0) & (mesh.areas > 0.0)
    facets = np.flatnonzero(usable)
    order = facets[np.argsort(region[facets], kind="stable")]
    bounds = np.searchsorted(region[order], np.arange(count + 1))
    turning, length = _interior_turning(mesh, region, count)
    for r in range(count):
        inside = order[bounds[r] : bounds[r + 1]]
        weights = np.repeat(mesh.areas[inside] / 3.0, 3)
        points = mesh.corners_of(inside).reshape(-1, 3)
        area = float(mesh.areas[inside].sum())
        centre = weights @ points / max(area, 1e-300)
        square = weights @ ((points - centre) ** 2).sum(axis=1) / max(area, 1e-300)
        yield RegionSample(
            facets=inside,
            vertices=mesh.vertices[distinct(mesh.triangles[inside].ravel())],
            points=points,
            normals=corner_normals.at(inside).reshape(-1, 3),
            weights=weights,
            area=area,
            size=float(np.sqrt(square)),
            turning=float(turning[r]),
            edge_length=float(length[r]),
        )


def _interior_turning(mesh: Mesh, region: IntArray, count: int) -> tuple[FloatArray, FloatArray]:
    """RMS turning angle and RMS length of the edges within each region."""
    first, second = mesh.facet_pairs.T
    label = region[first]
    inside = np.flatnonzero((label == region[second]) & (label >= 0))
    label = label[inside]
    number = np.maximum(np.bincount(label, minlength=count), 1)

    def root_mean_square(values: FloatArray) -> FloatArray:
        mean: FloatArray = np.bincount(label, values**2, count) / number
        return np.sqrt(mean)

    return root_mean_square(mesh.turning[inside]), root_mean_square(edge_lengths(mesh, inside))
