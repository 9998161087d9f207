# SPDX-License-Identifier: LGPL-2.1-or-later
"""Noise of a mesh's vertices, estimated from the mesh itself."""

from __future__ import annotations

import numpy as np
from scipy.sparse import csr_matrix

from gpswb.core.curvature import tangent_frame
from gpswb.core.mesh import FloatArray, Mesh
from gpswb.core.reference import spread
from gpswb.core.wedges import Wedges

_SAMPLES = 2000
_MOST = 24
_SHAPE = 0.1  # a rest below this share of kappa^2 r^3 may be the surface's own shape


def estimate_noise(mesh: Mesh, wedges: Wedges, normals: FloatArray) -> float:
    """Standard deviation of the vertices across the surface, mm.

    At sampled vertices away from creases a full quadric of the tangent plane is fitted to the two
    rings around; what is left, with the six fitted degrees of freedom taken off, is noise, unless
    it is so small beside the curvature that it may be the surface's third derivatives. The lower
    quartile over the samples is taken: the flattest quarter of the part decides, on which a nominal
    mesh leaves rounding only.

    Args:
        mesh: the mesh.
        wedges: corners joined across smooth edges.
        normals: (w, 3) their normals.

    Returns:
        sigma >= 0; 0 where no vertex has enough neighbours.
    """
    n = len(mesh.vertices)
    ends = mesh.pair_edges
    row, col = np.concatenate([ends, ends[:, ::-1]]).T
    graph = csr_matrix((np.ones(len(row)), (row, col)), shape=(n, n))
    creased = (np.bincount(wedges.vertex, minlength=n) > 1).astype(np.float64)
    inner = (creased == 0.0) & (graph @ creased == 0.0) & (np.diff(graph.indptr) >= 4)
    candidates = np.flatnonzero(inner)
    if not len(candidates):
        return 0.0
    chosen = candidates[spread(len(candidates), _SAMPLES)]
    rings = (graph[chosen] + graph[chosen] @ graph).tocsr()
    degree = np.diff(rings.indptr)
    chosen, start, degree = (a[degree >= 10] for a in (chosen, rings.indptr[:-1], degree))
    if not len(chosen):
        return 0.0
    slot = np.arange(_MOST)
    count = np.minimum(degree, _MOST)
    # Rings longer than that are thinned evenly.
    pick = np.minimum(slot * degree[:, None] // count[:, None], degree[:, None] - 1)
    near = rings.indices[start[:, None] + pick]
    present = (slot < count[:, None]).astype(np.float64)
    wedge = np.zeros(n, dtype=np.int64)
    wedge[wedges.vertex] = np.arange(wedges.count)
    normal = normals[wedge[chosen]]
    ray = mesh.vertices[near] - mesh.vertices[chosen][:, None]
    height = np.einsum("ski,si->sk", ray, normal)
    u, v = tangent_frame(normal)
    x, y = np.einsum("ski,si->sk", ray, u), np.einsum("ski,si->sk", ray, v)
    scale = np.maximum(np.sqrt((x**2 + y**2).max(axis=1, keepdims=True)), 1e-300)
    x, y = x / scale, y / scale
    design = np.stack([np.ones_like(x), x, y, x * x, x * y, y * y], axis=2) * present[:, :, None]
    height = height * present
    gram = np.swapaxes(design, 1, 2) @ design + 1e-9 * np.eye(6)
    right = np.einsum("skc,sk->sc", design, height)
    fitted = np.linalg.solve(gram, right[:, :, None])[:, :, 0]
    rest = height - np.einsum("skc,sc->sk", design, fitted)
    variance = (rest**2).sum(axis=1) / np.maximum(count - 6, 1)
    # kappa r^2 from the second derivatives: a smooth surface leaves a share of kappa^2 r^3.
    bend = np.sqrt(4.0 * (fitted[:, 3] ** 2 + fitted[:, 5] ** 2) + 2.0 * fitted[:, 4] ** 2)
    shape = _SHAPE * bend**2 / scale[:, 0]
    return float(np.sqrt(np.quantile(np.where(variance > shape**2, variance, 0.0), 0.25)))
