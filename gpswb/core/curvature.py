# SPDX-License-Identifier: LGPL-2.1-or-later
"""Principal curvatures by Rusinkiewicz's per-facet tensor, gathered over wedges (paper, 4.1)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.sparse import csr_matrix

from gpswb.core.blocks import blocks
from gpswb.core.facet_curvature import facet_curvature
from gpswb.core.mesh import FloatArray, Mesh
from gpswb.core.tangent_frames import ComplexArray, tangent_frame, turned_direction
from gpswb.core.wedges import Wedges


@dataclass(frozen=True, eq=False)
class Curvature:
    """Curvature at each wedge and each facet; outward convex is positive.

    A tensor S with dn = S dx, 1/mm, is stored as its mean curvature H and as the complex number D
    that says how it differs with direction: k = H +- |D|, and the direction of k_max is at half the
    angle of D in the frame of `tangent_frame`.

    Args:
        normals: (w, 3) unit normals of the wedges.
        mean: (w,) H; ``difference``: (w,) D.
        facet_mean, facet_difference: (m,) H and |D| of each facet, 1/mm.
    """

    normals: FloatArray
    mean: FloatArray
    difference: ComplexArray
    facet_mean: FloatArray
    facet_difference: FloatArray

    @cached_property
    def k_max(self) -> FloatArray:
        """(w,) largest principal curvature, 1/mm."""
        k_max: FloatArray = self.mean + np.abs(self.difference)
        return k_max

    @cached_property
    def k_min(self) -> FloatArray:
        """(w,) least principal curvature, 1/mm."""
        k_min: FloatArray = self.mean - np.abs(self.difference)
        return k_min

    @property
    def direction(self) -> FloatArray:
        """(w, 3) unit principal direction of ``k_max``."""
        u, v = tangent_frame(self.normals)
        angle = 0.5 * np.angle(self.difference)[:, None]
        return np.asarray(np.cos(angle) * u + np.sin(angle) * v, dtype=np.float64)

    @property
    def shape_index(self) -> FloatArray:
        """(w,) shape index in [-1, 1]."""
        return shape_index(self.k_max, self.k_min)

    @property
    def curvedness(self) -> FloatArray:
        """(w,) curvedness, 1/mm."""
        return curvedness(self.k_max, self.k_min)


def shape_index(k_max: FloatArray, k_min: FloatArray) -> FloatArray:
    """Shape index of equation (4), (2/pi) arctan((k1+k2)/(k1-k2)): +1 on an outward-convex cap.

    ``arctan2`` gives +-1 on umbilics, where the printed quotient divides by zero, and 0 on planes.
    """
    s: FloatArray = np.arctan2(k_max + k_min, np.abs(k_max - k_min)) * (2.0 / np.pi)
    return s


def curvedness(k_max: FloatArray, k_min: FloatArray) -> FloatArray:
    """Curvedness of equation (5), sqrt((k1^2 + k2^2) / 2), in the unit of the curvatures."""
    c: FloatArray = np.sqrt(0.5 * (k_max**2 + k_min**2))
    return c


def estimate_curvature(
    mesh: Mesh, wedges: Wedges, normals: FloatArray, sweeps: int = 0
) -> Curvature:
    """Curvature of each wedge and facet.

    Each facet's tensor is the least-squares fit of dn = S dx to its three edges (Rusinkiewicz
    2004), turned into the tangent plane of each of its wedges and averaged there by corner area.

    Args:
        mesh: the mesh.
        wedges: which corners share a normal and a tensor.
        normals: (w, 3) unit normals of the wedges.
        sweeps: averaging sweeps over the neighbouring wedges, for noise: k sweeps average over a
            ball of about sqrt(k) edge lengths that stops at creases. Facets then have the mean of
            their corners.
    """
    columns = np.ascontiguousarray(normals.T)
    bent = mesh.bent_facets
    bent_mean, bent_difference = np.empty(len(bent)), np.empty(len(bent))
    mean_at, even_at, odd_at = (np.empty((len(bent), 3)) for _ in range(3))
    for part in blocks(len(bent)):
        facets = bent[part]
        corner = mesh.columns.take(mesh.triangles[facets].T, axis=1)
        normal = np.ascontiguousarray(mesh.facet_normals[facets].T)
        target = columns.take(wedges.of_corner[facets].T, axis=1)
        side, mean, even, odd = facet_curvature(corner, target, normal)
        bent_mean[part], bent_difference[part] = mean, np.hypot(even, odd)
        cos, sin = turned_direction(side[:, None], normal[:, None], target)
        # A tensor turns by twice the angle.
        cos, sin = cos * cos - sin * sin, 2.0 * cos * sin
        area = mesh.areas[facets]
        mean_at[part] = (area * mean)[:, None]
        even_at[part] = (area * (even * cos - odd * sin)).T
        odd_at[part] = (area * (even * sin + odd * cos)).T
    facet_mean, facet_difference = np.zeros(len(mesh.areas)), np.zeros(len(mesh.areas))
    facet_mean[bent], facet_difference[bent] = bent_mean, bent_difference
    area = wedges.sum_corners(np.repeat(mesh.areas, 3))
    divisor = np.where(area > 0.0, area, np.inf)
    mean = wedges.sum_corners(mean_at, bent) / divisor
    difference = np.empty(wedges.count, dtype=np.complex128)
    difference.real = wedges.sum_corners(even_at, bent) / divisor
    difference.imag = wedges.sum_corners(odd_at, bent) / divisor
    found = Curvature(normals, mean, difference, facet_mean, facet_difference)
    return _averaged(found, mesh, wedges, area, sweeps) if sweeps else found


def _averaged(
    curvature: Curvature, mesh: Mesh, wedges: Wedges, area: FloatArray, sweeps: int
) -> Curvature:
    """Average tensors over neighbouring wedges, by area, each turned into the wedge's own plane."""
    w = wedges.count
    corner, own = wedges.of_corner, np.arange(w)
    row, col = (
        np.concatenate([corner.ravel(), own]),
        np.concatenate([corner[:, [1, 2, 0]].ravel(), own]),
    )
    graph = csr_matrix((np.ones(len(row)), (row, col)), shape=(w, w))
    graph = (graph + graph.T).tocsr()
    graph.data = area[graph.indices]
    row = np.repeat(own, np.diff(graph.indptr))
    graph.data /= np.maximum(np.bincount(row, graph.data, w), 1e-300)[row]
    start, end = curvature.normals[graph.indices].T, curvature.normals[row].T
    first = tangent_frame(curvature.normals)[0][graph.indices].T
    cos, sin = turned_direction(first, start, end)
    turning = graph.astype(np.complex128)
    turning.data *= (cos + 1j * sin) ** 2
    mean, difference = curvature.mean, curvature.difference
    for _ in range(sweeps):
        mean, difference = graph @ mean, turning @ difference
    normal = mesh.facet_normals
    at = [
        difference[corner[:, k]] * _turn(curvature.normals[corner[:, k]], normal) for k in range(3)
    ]
    return Curvature(
        curvature.normals, mean, difference, mean[corner].mean(axis=1), np.abs(sum(at)) / 3.0
    )


def _turn(start: FloatArray, end: FloatArray) -> ComplexArray:
    """(n,) factor that takes the difference of a tensor from one frame (n, 3) to another."""
    cos, sin = turned_direction(tangent_frame(start)[0].T, start.T, end.T)
    factor: ComplexArray = (cos + 1j * sin) ** 2
    return factor
