# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facet adjacency in the form that growing needs."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh


@dataclass(frozen=True, eq=False)
class FacetGraph:
    """Neighbours of facets across their edges.

    Args:
        neighbour: (m, 3) int64 facet across each edge, -1 at a border or a non-manifold edge.
        dihedral: (m, 3) signed angle between the two normals, rad; positive where the edge is
            convex, 0 without a neighbour.
        pairs: (e, 2) facets of each interior edge; ``pair_dihedral`` (e,) their angle.
        pair_edges: (e, 2) vertices of each interior edge.
    """

    neighbour: IntArray
    dihedral: FloatArray
    pairs: IntArray
    pair_edges: IntArray
    pair_dihedral: FloatArray

    @classmethod
    def of(cls, mesh: Mesh) -> FacetGraph:
        """The adjacency of a mesh."""
        m = len(mesh.triangles)
        pairs, edges = mesh.facet_pairs, mesh.pair_edges
        n = mesh.facet_normals
        a, b = pairs.T if len(pairs) else np.zeros((2, 0), dtype=np.int64)
        cross = np.linalg.norm(np.cross(n[a], n[b]), axis=1)
        angle = np.arctan2(cross, np.einsum("ek,ek->e", n[a], n[b]))
        # A neighbour below the facet's plane makes the edge convex.
        below = np.einsum("ek,ek->e", n[a], mesh.centroids[b] - mesh.centroids[a]) < 0
        angle = np.where(below, angle, -angle)
        neighbour = np.full((m, 3), -1, dtype=np.int64)
        dihedral = np.zeros((m, 3))
        for facet, other in ((a, b), (b, a)):
            corner = mesh.triangles[facet]
            # The edge opposite to the corner that isn't on it; column k is the edge (k, k+1).
            on = (corner[:, :, None] == edges[:, None, :]).any(axis=2)
            opposite = np.argmin(on, axis=1)
            column = (opposite + 1) % 3
            neighbour[facet, column] = other
            dihedral[facet, column] = angle
        return cls(neighbour, dihedral, pairs, edges, angle)

    def components(self, joined: BoolArray, m: int) -> IntArray:
        """(m,) component of each facet where ``joined`` (e,) says which pairs hang together."""
        from scipy.sparse import coo_array
        from scipy.sparse.csgraph import connected_components

        p = self.pairs[joined]
        graph = coo_array((np.ones(len(p), dtype=np.int8), (p[:, 0], p[:, 1])), shape=(m, m))
        label: IntArray = connected_components(graph, directed=False)[1].astype(np.int64)
        return label
