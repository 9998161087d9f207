# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facet normals averaged as far as the noise asks for, but not across creases."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_matrix, csr_matrix

from gpswb.core.mesh import FloatArray, Mesh

SWEEPS = 10
"""Rounds of averaging: each reaches one facet further."""

COMMON = 0.4
"""Share of a normal's variance that a round leaves at least: neighbours have vertices in common, so
that their normals are not independent."""

BEND = 0.25
"""Turn (rad) that neighbours on one smooth surface may have: coarse meshes turn by 0.26 rad."""


def normal_variance(mesh: Mesh, sigma: float) -> FloatArray:
    """(m,) variance (rad²) of each facet's normal that noise of sigma (mm) at its corners gives.

    A corner that moves by sigma tilts the facet by sigma over the altitude on it.
    """
    edges = np.linalg.norm(mesh.corners - np.roll(mesh.corners, 1, axis=1), axis=2)
    altitude = 2.0 * mesh.areas[:, None] / np.maximum(edges, 1e-300)
    tilt = (sigma / np.maximum(altitude, 1e-300)) ** 2
    variance: FloatArray = np.minimum(tilt.sum(axis=1), 10.0)
    return variance


def guidance_normals(mesh: Mesh, sigma: float) -> FloatArray:
    """(m, 3) unit normals of the facets, denoised by a bilateral filter.

    Neighbours share a vertex. They count by the inverse of their variance, and the less the more
    they turn beyond what noise and smooth bending explain (after Zheng, Fu, Au, Tai: "Bilateral
    normal filtering for mesh denoising", 2011).

    Args:
        mesh: the mesh.
        sigma: noise of the vertices, mm.
    """
    m = len(mesh.triangles)
    normal = mesh.facet_normals
    variance = normal_variance(mesh, sigma)
    around = _sharing_a_vertex(mesh)
    row, col = around.nonzero()
    weight = 1.0 / (variance + BEND**2)
    for _ in range(SWEEPS):
        gap = ((normal[row] - normal[col]) ** 2).sum(axis=1)
        allowed = BEND**2 + variance[row] + variance[col]
        share = weight[col] * np.exp(-0.5 * gap / allowed)
        mixing = csr_matrix((share, (row, col)), shape=(m, m))
        total = mixing @ normal
        length = np.linalg.norm(total, axis=1)
        usable = length > 1e-12
        normal = np.where(usable[:, None], total / np.maximum(length, 1e-300)[:, None], normal)
        sums = np.maximum(np.bincount(row, share, m), 1e-300)
        mixed = np.bincount(row, share**2 * variance[col], m) / sums**2
        variance = np.maximum(mixed, COMMON * variance)
        weight = 1.0 / (variance + BEND**2)
    return normal


def _sharing_a_vertex(mesh: Mesh) -> csr_matrix:
    """(m, m) which facets have a vertex in common, themselves included."""
    m = len(mesh.triangles)
    facet = np.repeat(np.arange(m), 3)
    corner = coo_matrix(
        (np.ones(3 * m, dtype=np.int32), (facet, mesh.triangles.ravel())),
        shape=(m, len(mesh.vertices)),
    ).tocsr()
    return (corner @ corner.T).tocsr()
