# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slippage analysis of regions: moments that add up, and slippable motions (paper, 3.3).

A twist x = (omega, t) moves a point p with velocity omega x p + t. With a = (p x n, n) and
J = (-[p]x, I), the moments M = sum w a a^T and V = sum w J^T J give

* equation (1)-(3) as printed: the eigenvalues of M alone, which mix square millimetres with pure
  numbers and so depend on unit and origin;
* the generalised form M x = mu V x: mu is the mean squared sine of the angle between velocity and
  surface (weighted by squared speed), whatever the origin, pose or unit.

Both moments add over regions, so that a trial merge costs no pass over points.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gpswb.core.facet_geometry import cross_product, dot
from gpswb.core.mesh import FloatArray, IntArray, Mesh
from gpswb.core.outer_sums import outer_sums

# Three interior points of a triangle that integrate quadratics exactly.
_QUADRATURE = np.array([[4.0, 1.0, 1.0], [1.0, 4.0, 1.0], [1.0, 1.0, 4.0]]) / 6.0


@dataclass(frozen=True, eq=False)
class SlippageMoments:
    """Moments of r regions in one frame.

    Args:
        motion: (r, 6, 6) M = sum w a a^T.
        metric: (r, 6, 6) V = sum w J^T J.
    """

    motion: FloatArray
    metric: FloatArray

    @property
    def weight(self) -> FloatArray:
        """(r,) total weight (area) of each region."""
        weight: FloatArray = self.metric[:, 3, 3]
        return weight

    @property
    def centroid(self) -> FloatArray:
        """(r, 3) weighted mean of each region's points."""
        # The block of V between omega and t is sum w [p]x.
        block = self.metric[:, :3, 3:]
        vector = np.stack([block[:, 2, 1], block[:, 0, 2], block[:, 1, 0]], axis=1)
        centroid: FloatArray = vector / np.maximum(self.weight, 1e-300)[:, None]
        return centroid

    @property
    def gyration(self) -> FloatArray:
        """(r,) radius of gyration of each region about its centroid."""
        weight = np.maximum(self.weight, 1e-300)
        square = np.trace(self.metric[:, :3, :3], axis1=1, axis2=2) / (2.0 * weight)
        about: FloatArray = square - (self.centroid**2).sum(axis=1)
        radius: FloatArray = np.sqrt(np.maximum(about, 0.0))
        return radius

    def moved(self, origin: FloatArray) -> SlippageMoments:
        """The same moments about new origins, (r, 3) or (3,)."""
        shift = twist_shift(np.broadcast_to(origin, (len(self.motion), 3)))
        turned = np.swapaxes(shift, 1, 2)
        return SlippageMoments(turned @ self.motion @ shift, turned @ self.metric @ shift)


def cross_matrices(vectors: FloatArray) -> FloatArray:
    """(n, 3, 3) matrices [v]x with [v]x y = v x y."""
    matrix = np.zeros((len(vectors), 3, 3))
    x, y, z = vectors.T
    matrix[:, 0, 1], matrix[:, 0, 2], matrix[:, 1, 2] = -z, y, -x
    matrix[:, 1, 0], matrix[:, 2, 0], matrix[:, 2, 1] = z, -y, x
    return matrix


def twist_shift(origin: FloatArray) -> FloatArray:
    """(n, 6, 6) matrices T: a twist x' about each origin (n, 3) is x = T x' about zero."""
    shift = np.zeros((len(origin), 6, 6))
    shift[:, range(6), range(6)] = 1.0
    shift[:, 3:, :3] = cross_matrices(origin)
    return shift


def facet_samples(
    mesh: Mesh, corner_normals: FloatArray, facets: IntArray | None = None
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Three points in each facet with normals interpolated from its corners.

    Args:
        mesh: the mesh.
        corner_normals: (k, 3, 3) unit normals at the corners of the facets sampled.
        facets: (k,) these facets; all if not given.

    Returns:
        Points (3k, 3) mm, unit normals (3k, 3), weights (3k,) mm^2; three rows per facet in order.
    """
    if facets is None:
        facets = np.arange(len(mesh.triangles))
    points = (_QUADRATURE @ mesh.corners_of(facets)).reshape(-1, 3)
    normals = (_QUADRATURE @ corner_normals).reshape(-1, 3)
    length = np.sqrt(dot(normals.T, normals.T))[:, None]
    normals = np.divide(normals, length, out=np.zeros_like(normals), where=length > 0)
    return points, normals, np.repeat(mesh.areas[facets] / 3.0, 3)


def slippage_moments(
    points: FloatArray, normals: FloatArray, weights: FloatArray, label: IntArray, count: int
) -> SlippageMoments:
    """Moments of each region from weighted points with normals.

    Args:
        points, normals: (n, 3).
        weights: (n,).
        label: (n,) int region of each point, 0..count-1; negative for points of none.
        count: number of regions.
    """
    motion = outer_sums(
        np.concatenate([cross_product(points.T, normals.T).T, normals], 1), weights, label, count
    )
    # With a 1 appended, the second moments hold the first and the weight too.
    position = outer_sums(
        np.concatenate([points, np.ones((len(points), 1))], axis=1), weights, label, count
    )
    second, first, total = position[:, :3, :3], position[:, :3, 3], position[:, 3, 3]
    metric = np.zeros((count, 6, 6))
    trace = np.trace(second, axis1=1, axis2=2)
    metric[:, :3, :3] = trace[:, None, None] * np.eye(3) - second
    metric[:, :3, 3:] = cross_matrices(first)
    metric[:, 3:, :3] = np.swapaxes(metric[:, :3, 3:], 1, 2)
    metric[:, 3:, 3:] = total[:, None, None] * np.eye(3)
    return SlippageMoments(motion, metric)


def slippable_motions(moments: SlippageMoments) -> tuple[FloatArray, FloatArray]:
    """Solve M x = mu V x for every region (the repaired equation 2).

    Returns:
        mu (r, 6) ascending in [0, 1], and twists (r, 6, 6) as columns, V-orthonormal up to the
        region's weight, about the origin of the moments. Motions that hardly move the region (a
        rotation about a line-like region's own axis) count as slippable.
    """
    form, inverse, scale = _balanced(moments)
    mu, vector = np.linalg.eigh(form)
    twist = scale[:, :, None] * (np.swapaxes(inverse, 1, 2) @ vector)
    return np.clip(mu, 0.0, None), twist_shift(moments.centroid) @ twist


def slippage_values(moments: SlippageMoments) -> FloatArray:
    """The mu (r, 6) of `slippable_motions` alone, in two thirds of the time."""
    mu = np.linalg.eigvalsh(_balanced(moments)[0])
    return np.asarray(np.clip(mu, 0.0, None), dtype=np.float64)


def _balanced(moments: SlippageMoments) -> tuple[FloatArray, FloatArray, FloatArray]:
    """M in a basis in which V is the identity (r, 6, 6), the basis (r, 6, 6) and the scale (r, 6)
    of its lengths."""
    centred = moments.moved(moments.centroid)
    weight = np.maximum(moments.weight, 1e-300)[:, None, None]
    m, v = centred.motion / weight, centred.metric / weight
    # Balance lengths before the factorisation: unit = radius of gyration of each region.
    gyration = np.sqrt(np.maximum(np.trace(v[:, :3, :3], axis1=1, axis2=2) / 2.0, 1e-300))
    scale = np.ones((len(m), 6))
    scale[:, :3] = 1.0 / gyration[:, None]
    balance = scale[:, :, None] * scale[:, None, :]
    inverse = np.linalg.inv(np.linalg.cholesky(v * balance + 1e-10 * np.eye(6)))
    return inverse @ (m * balance) @ np.swapaxes(inverse, 1, 2), inverse, scale


def printed_signature(
    motion: FloatArray, condition_number: float
) -> tuple[IntArray, FloatArray, FloatArray]:
    """Slippable motions as printed: lambda_6 / lambda_i >= g_set (equations 2 and 3).

    Args:
        motion: (r, 6, 6) covariance matrices M_c, in whatever unit and origin the points have.
        condition_number: g_set.

    Returns:
        Number of slippable motions (r,), eigenvalues (r, 6) ascending, eigenvectors as columns.
    """
    value, vector = np.linalg.eigh(motion)
    slippable = value[:, -1:] >= condition_number * np.maximum(value, 0.0)
    return slippable[:, :5].sum(axis=1), value, vector
