# SPDX-License-Identifier: LGPL-2.1-or-later
"""Initial patches of about equal size, where the shape of a mesh is not looked at."""

from __future__ import annotations

import numpy as np
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import connected_components, dijkstra

from gpswb.core.growing import number_by_first
from gpswb.core.mesh import IntArray, Mesh
from gpswb.core.reference import spread


def equal_patches(mesh: Mesh, facets_each: int) -> IntArray:
    """Decompose a mesh into connected patches of about the same number of facets.

    Voronoi cells of seeds along the facet graph; the seeds are evenly spaced in the order of a
    curve that visits the connected components and, in them, space along a Morton curve.

    Args:
        mesh: the mesh.
        facets_each: wished number of facets in a patch, >= 1.

    Returns:
        (m,) int64 patch of each facet, 0-based.
    """
    m = len(mesh.triangles)
    if m == 0:
        return np.zeros(0, dtype=np.int64)
    first, second = mesh.facet_pairs.T
    length = np.linalg.norm(mesh.centroids[first] - mesh.centroids[second], axis=1) + 1e-300
    row, col = np.concatenate([first, second]), np.concatenate([second, first])
    graph = csr_matrix((np.tile(length, 2), (row, col)), shape=(m, m))
    _, component = connected_components(graph, directed=False)
    order = np.lexsort((_morton(mesh), component))
    seeds = order[spread(m, max(1, round(m / facets_each)))]
    # Every component needs a seed, or its facets are reached from none.
    lone = np.setdiff1d(component, component[seeds])
    extra = [int(np.flatnonzero(component == c)[0]) for c in lone.tolist()]
    seeds = np.unique(np.concatenate([seeds, np.array(extra, dtype=np.int64)]))
    _, _, source = dijkstra(graph, indices=seeds, min_only=True, return_predecessors=True)
    patch, _ = number_by_first(np.where(source < 0, np.arange(m), source))
    return patch


def _morton(mesh: Mesh) -> IntArray:
    """(m,) position of each facet's centroid on a Morton curve of 10 bits an axis."""
    low = mesh.vertices.min(axis=0)
    span = max(float(np.ptp(mesh.vertices, axis=0).max()), 1e-300)
    cell = np.clip((mesh.centroids - low) / span * 1024.0, 0, 1023).astype(np.int64)
    code = np.zeros(len(cell), dtype=np.int64)
    for bit in range(10):
        for axis in range(3):
            code |= ((cell[:, axis] >> bit) & 1) << (3 * bit + axis)
    return code
