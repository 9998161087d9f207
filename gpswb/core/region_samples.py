# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a region's recognition looks at: its vertices, and normals that stay within it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from gpswb.core.facet_edges import facet_edges
from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.normals import wedge_normals
from gpswb.core.sharp_edges import turning_angles
from gpswb.core.wedges import find_wedges

_SINGULAR = 1.5  # turns of the facet's edges that a normal may be off before it is not believed
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


def confined_normals(mesh: Mesh, region: IntArray, crease: BoolArray) -> FloatArray:
    """Corner normals (m, 3, 3) averaged neither across creases nor across region borders.

    Args:
        mesh: the mesh.
        region: (m,) int region of each facet.
        crease: (e,) bool feature edges, aligned with ``mesh.facet_pairs``.
    """
    border = region[mesh.facet_pairs[:, 0]] != region[mesh.facet_pairs[:, 1]]
    wedges = find_wedges(mesh, crease | border)
    normals = wedge_normals(mesh, wedges)[wedges.of_corner]
    return _without_apexes(mesh, normals, crease | border)


def _without_apexes(mesh: Mesh, normals: FloatArray, crease: BoolArray) -> FloatArray:
    """Facet normals where a vertex has none: at the apex of a cone, say.

    On a smooth surface a vertex normal is off its facet's by less than the facet's edges turn. At
    an apex the mean of all sides points along the axis, far off each of them.
    """
    angle = np.where(crease, 0.0, turning_angles(mesh))
    edge_of, _ = facet_edges(mesh)
    turning = np.where(edge_of >= 0, np.append(angle, 0.0)[edge_of], 0.0).max(axis=1)
    sine = np.linalg.norm(np.cross(normals, mesh.facet_normals[:, None]), axis=2)
    cosine = np.einsum("fki,fi->fk", normals, mesh.facet_normals)
    singular = np.arctan2(sine, cosine) > _SINGULAR * turning[:, None] + _ROUNDING
    return np.where(singular[:, :, None], mesh.facet_normals[:, None], normals)


def region_samples(
    mesh: Mesh, region: IntArray, count: int, corner_normals: FloatArray
) -> Iterator[RegionSample]:
    """Sample of each region 0..count-1 in order; degenerate facets are left out.

    Args:
        mesh: the mesh.
        region: (m,) int, -1 for facets of none.
        count: number of regions.
        corner_normals: (m, 3, 3), see `confined_normals`.
    """
    usable = (region >= 0) & (mesh.areas > 0.0)
    facets = np.flatnonzero(usable)
    order = facets[np.argsort(region[facets], kind="stable")]
    bounds = np.searchsorted(region[order], np.arange(count + 1))
    turning, length = _interior_turning(mesh, region, count)
    for r in range(count):
        inside = order[bounds[r] : bounds[r + 1]]
        weights = np.repeat(mesh.areas[inside] / 3.0, 3)
        points = mesh.corners[inside].reshape(-1, 3)
        area = float(mesh.areas[inside].sum())
        centre = weights @ points / max(area, 1e-300)
        spread = weights @ ((points - centre) ** 2).sum(axis=1) / max(area, 1e-300)
        yield RegionSample(
            facets=inside,
            vertices=mesh.vertices[np.unique(mesh.triangles[inside])],
            points=points,
            normals=corner_normals[inside].reshape(-1, 3),
            weights=weights,
            area=area,
            size=float(np.sqrt(spread)),
            turning=float(turning[r]),
            edge_length=float(length[r]),
        )


def _interior_turning(mesh: Mesh, region: IntArray, count: int) -> tuple[FloatArray, FloatArray]:
    """RMS turning angle and RMS length of the edges within each region."""
    first, second = region[mesh.facet_pairs].T
    inside = (first == second) & (first >= 0)
    label = first[inside]
    angle = turning_angles(mesh)[inside]
    ends = mesh.vertices[mesh.pair_edges[inside]]
    squared = ((ends[:, 1] - ends[:, 0]) ** 2).sum(axis=1)
    number = np.maximum(np.bincount(label, minlength=count), 1)
    turning = np.sqrt(np.bincount(label, weights=angle**2, minlength=count) / number)
    length = np.sqrt(np.bincount(label, weights=squared, minlength=count) / number)
    return turning, length
