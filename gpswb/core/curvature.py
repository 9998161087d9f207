# SPDX-License-Identifier: LGPL-2.1-or-later
"""Principal curvatures by Rusinkiewicz's per-facet tensor, gathered over wedges (paper, 4.1)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.sparse import csr_matrix

from gpswb.core.mesh import FloatArray, Mesh
from gpswb.core.wedges import Wedges


@dataclass(frozen=True, eq=False)
class Curvature:
    """Curvature at each wedge; outward convex is positive.

    Args:
        normals: (w, 3) unit normals.
        tensor: (w, 3, 3) symmetric tensor S with dn = S dx, 1/mm, S n = 0.
        k_max, k_min: (w,) principal curvatures, 1/mm, ``k_max >= k_min``.
        direction: (w, 3) unit principal direction of ``k_max``.
    """

    normals: FloatArray
    tensor: FloatArray
    k_max: FloatArray
    k_min: FloatArray
    direction: FloatArray

    @cached_property
    def shape_index(self) -> FloatArray:
        """(w,) shape index in [-1, 1]."""
        return shape_index(self.k_max, self.k_min)

    @cached_property
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
    """Curvature tensor of each wedge.

    Each facet's tensor is the least-squares fit of dn = S dx to its three edges (Rusinkiewicz
    2004), turned into the tangent plane of each of its wedges and averaged there by corner area.

    Args:
        mesh: the mesh.
        wedges: which corners share a normal and a tensor.
        normals: (w, 3) unit normals of the wedges.
        sweeps: averaging sweeps over the neighbouring wedges, for noise: k sweeps average over a
            ball of about sqrt(k) edge lengths that stops at creases.
    """
    facet_tensor = facet_tensors(mesh, normals[wedges.of_corner])
    weight = np.repeat(mesh.areas[:, None] / 3.0, 3, axis=1)
    axis = mesh.facet_normals
    target = normals[wedges.of_corner]
    turned = np.stack([_turn(facet_tensor, axis, target[:, k]) for k in range(3)], axis=1)
    total = wedges.sum_corners(weight[:, :, None, None] * turned)
    area = wedges.sum_corners(weight[:, :, None])[:, 0]
    tensor = np.divide(
        total, area[:, None, None], out=np.zeros_like(total), where=area[:, None, None] > 0
    )
    if sweeps:
        tensor = _diffuse(tensor, normals, wedges, area, sweeps)
    k_max, k_min, direction = principal(tensor, normals)
    return Curvature(normals, tensor, k_max, k_min, direction)


def facet_tensors(mesh: Mesh, corner_normals: FloatArray) -> FloatArray:
    """Tensor of each facet from the normals at its corners.

    Args:
        mesh: the mesh.
        corner_normals: (m, 3, 3) unit normals.

    Returns:
        (m, 3, 3) symmetric tensors in the facet's plane, 1/mm; zero for a degenerate facet.
    """
    u, v = tangent_frame(mesh.facet_normals)
    frame = np.stack([u, v], axis=1)
    edges = np.roll(mesh.corners, -1, axis=1) - mesh.corners
    change = np.roll(corner_normals, -1, axis=1) - corner_normals
    x = np.einsum("fak,fik->fia", frame, edges)
    y = np.einsum("fak,fik->fia", frame, change)
    xx, xy, yy = ((x[:, :, a] * x[:, :, b]).sum(axis=1) for a, b in ((0, 0), (0, 1), (1, 1)))
    r0 = (x[:, :, 0] * y[:, :, 0]).sum(axis=1)
    r1 = (x[:, :, 1] * y[:, :, 0] + x[:, :, 0] * y[:, :, 1]).sum(axis=1)
    r2 = (x[:, :, 1] * y[:, :, 1]).sum(axis=1)
    # Normal equations [[xx, xy, 0], [xy, xx+yy, xy], [0, xy, yy]] (e, f, g) = (r0, r1, r2):
    # their determinant is (xx + yy) (xx yy - xy^2), so the closed form needs one inverse.
    trace, det2 = xx + yy, xx * yy - xy * xy
    det = trace * det2
    usable = det2 > 1e-20 * trace * trace
    inverse = np.divide(1.0, det, out=np.zeros_like(det), where=usable)
    e = ((trace * yy - xy * xy) * r0 - xy * yy * r1 + xy * xy * r2) * inverse
    f = (-xy * yy * r0 + xx * yy * r1 - xx * xy * r2) * inverse
    g = (xy * xy * r0 - xx * xy * r1 + (trace * xx - xy * xy) * r2) * inverse
    local = np.stack([np.stack([e, f], axis=1), np.stack([f, g], axis=1)], axis=1)
    tensor: FloatArray = np.einsum("fai,fab,fbj->fij", frame, local, frame, optimize=True)
    return tensor


def principal(tensor: FloatArray, normals: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Closed-form eigenvalues of tangent tensors: k_max (n,), k_min (n,), direction of k_max (n,
    3)."""
    u, v = tangent_frame(normals)
    su, sv = np.einsum("nij,nj->ni", tensor, u), np.einsum("nij,nj->ni", tensor, v)
    a = np.einsum("ni,ni->n", u, su)
    b = np.einsum("ni,ni->n", v, su)
    d = np.einsum("ni,ni->n", v, sv)
    mean, half = 0.5 * (a + d), 0.5 * (a - d)
    radius = np.hypot(half, b)
    angle = 0.5 * np.arctan2(b, half)
    direction = np.cos(angle)[:, None] * u + np.sin(angle)[:, None] * v
    return mean + radius, mean - radius, direction


def tangent_frame(normals: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Two unit vectors (n, 3) that complete each unit normal to a right-handed frame.

    Branch on the sign of n_z only (Duff et al. 2017): no normal is near a singularity.
    """
    x, y, z = normals.T
    sign = np.where(z >= 0.0, 1.0, -1.0)
    a = -1.0 / (sign + z)
    b = x * y * a
    u = np.stack([1.0 + sign * x * x * a, sign * b, -sign * x], axis=1)
    v = np.stack([b, sign + y * y * a, -y], axis=1)
    return u, v


def _turn(tensor: FloatArray, start: FloatArray, end: FloatArray) -> FloatArray:
    """Turn tangent tensors by the least rotation that takes unit normals ``start`` to ``end``."""
    rotation = _rotations(start, end)
    turned: FloatArray = rotation @ tensor @ np.swapaxes(rotation, 1, 2)
    return turned


def _rotations(start: FloatArray, end: FloatArray) -> FloatArray:
    """(n, 3, 3) R x = x - (end.x) (start + end) / (1 + start.end), for x perpendicular to start."""
    cosine = np.einsum("ni,ni->n", start, end)
    scale = np.divide(1.0, 1.0 + cosine, out=np.zeros_like(cosine), where=cosine > -0.99)
    total = start + end
    rotation: FloatArray = np.eye(3) - scale[:, None, None] * total[:, :, None] * end[:, None, :]
    return rotation


def _diffuse(
    tensor: FloatArray, normals: FloatArray, wedges: Wedges, area: FloatArray, sweeps: int
) -> FloatArray:
    """Average tensors over neighbouring wedges, by area, each turned into the wedge's own plane."""
    corner = wedges.of_corner
    row = np.concatenate([corner[:, [0, 1, 2]].ravel(), np.arange(wedges.count)])
    col = np.concatenate([corner[:, [1, 2, 0]].ravel(), np.arange(wedges.count)])
    graph = csr_matrix((np.ones(len(row)), (row, col)), shape=(wedges.count, wedges.count))
    graph = (graph + graph.T).tocsr()
    col = graph.indices
    row = np.repeat(np.arange(wedges.count), np.diff(graph.indptr))
    rotation = _rotations(normals[col], normals[row])
    weight = area[col] / np.maximum(np.add.reduceat(area[col], graph.indptr[:-1])[row], 1e-300)
    for _ in range(sweeps):
        turned = rotation @ tensor[col] @ np.swapaxes(rotation, 1, 2)
        tensor = np.add.reduceat(weight[:, None, None] * turned, graph.indptr[:-1], axis=0)
    return tensor
