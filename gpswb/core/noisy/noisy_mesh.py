# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh with its noise and what is derived from both."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.sparse import coo_matrix, csr_matrix, identity

from gpswb.core.mesh import FloatArray, IntArray, Mesh
from gpswb.core.noisy.guidance import guidance_normals, normal_variance
from gpswb.core.robust.topology import FacetGraph


@dataclass(frozen=True, eq=False)
class NoisyMesh:
    """What the steps of the noisy mode share.

    Args:
        mesh: the mesh.
        graph: its adjacency.
        normals: (m, 3) denoised facet normals.
        sigma: noise of the vertices, mm.
        around: (n, n) weights of the vertices within two edges of each, and their squares.
    """

    mesh: Mesh
    graph: FacetGraph
    normals: FloatArray
    sigma: float
    around: csr_matrix
    around_squared: csr_matrix

    @classmethod
    def of(cls, mesh: Mesh, sigma: float) -> NoisyMesh:
        """Derive what the steps need."""
        n = len(mesh.vertices)
        row, col = mesh.pair_edges.T
        ones = np.ones(len(row))
        edge = coo_matrix((ones, (row, col)), shape=(n, n)).tocsr()
        near = edge + edge.T + identity(n, format="csr")
        around = (near @ near).tocsr()
        normals = guidance_normals(mesh, sigma)
        return cls(
            mesh, FacetGraph.of(mesh), normals, sigma, around, around.multiply(around).tocsr()
        )

    @cached_property
    def pair_turn(self) -> FloatArray:
        """(e,) turn (rad, small angles) of the denoised normals across each interior edge."""
        a, b = self.graph.pairs.T
        turn: FloatArray = np.linalg.norm(self.normals[a] - self.normals[b], axis=1)
        return turn

    @cached_property
    def normal_error(self) -> FloatArray:
        """(m,) rad by which a facet's normal is off before it is denoised, a right angle at most:
        where facets are smaller than a few sigma their neighbours' normals say nothing either."""
        tilt = np.sqrt(normal_variance(self.mesh, self.sigma))
        error: FloatArray = np.minimum(tilt, 0.5 * np.pi)
        return error

    def vertices_of(self, facets: IntArray) -> IntArray:
        """The vertices of some facets, each once."""
        return np.unique(self.mesh.triangles[facets])
