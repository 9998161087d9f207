# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facet adjacency in the form that growing needs."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from gpswb.core.blocks import blocks
from gpswb.core.facet_edges import at_sides
from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh

SMOOTH = 0.35
"""Turning angle (rad) below which a border may be one within a smooth face."""


@dataclass(frozen=True, eq=False)
class FacetGraph:
    """Neighbours of facets across their edges.

    Args:
        neighbour: (m, 3) int32 facet across each edge, -1 at a border or a non-manifold edge.
        dihedral: (m, 3) angle between the two normals, rad; 0 without a neighbour.
        pairs: (e, 2) facets of each interior edge; ``pair_dihedral`` (e,) their angle.
        pair_sides: (e, 2) which side of which facet each edge is: 3 * facet + side.
        pair_edges: (e, 2) vertices of each interior edge.
    """

    neighbour: npt.NDArray[np.int32]
    dihedral: FloatArray
    pairs: IntArray
    pair_sides: IntArray
    pair_edges: IntArray
    pair_dihedral: FloatArray

    @classmethod
    def of(cls, mesh: Mesh) -> FacetGraph:
        """The adjacency of a mesh."""
        m = len(mesh.triangles)
        neighbour = np.full(3 * m, -1, dtype=np.int32)
        for side in (0, 1):
            half = mesh.half_edge_pairs[:, side]
            neighbour[half] = mesh.facet_pairs[:, 1 - side]
        return cls(
            neighbour.reshape(m, 3),
            at_sides(mesh, mesh.turning),
            mesh.facet_pairs,
            mesh.half_edge_pairs,
            mesh.pair_edges,
            mesh.turning,
        )

    def components(self, joined: BoolArray, m: int) -> IntArray:
        """(m,) component of each facet where ``joined`` (e,) says which pairs hang together."""
        # Half the size, and what scipy would copy them to.
        first, second = self.pairs[joined].astype(np.int32).T
        graph = coo_array((np.ones(len(first), dtype=np.int8), (first, second)), shape=(m, m))
        label: IntArray = connected_components(graph, directed=False)[1].astype(np.int64)
        return label

    @cached_property
    def smooth(self) -> BoolArray:
        """(e,) pairs between which there is no crease."""
        smooth: BoolArray = self.pair_dihedral < SMOOTH
        return smooth

    def within(self, marked: BoolArray) -> BoolArray:
        """(e,) pairs both of which are marked (m,)."""
        both = np.empty(len(self.pairs), dtype=bool)
        for part in blocks(len(both)):
            first, second = marked.take(self.pairs[part].T)
            np.logical_and(first, second, out=both[part])
        return both

    def borders(self, label: IntArray) -> BoolArray:
        """(e,) pairs of two different regions, by their (m,) labels, -1 for none."""
        border = np.empty(len(self.pairs), dtype=bool)
        for part in blocks(len(border)):
            first, second = label.take(self.pairs[part].T)
            border[part] = (first != second) & (np.minimum(first, second) >= 0)
        return border

    def passable(self, free: BoolArray, facets: IntArray, crease: float) -> BoolArray:
        """(..., 3) sides of facets behind which a free one (m,) turns by less than a crease."""
        neighbour = self.neighbour[facets]
        passable: BoolArray = (neighbour >= 0) & free[neighbour]
        passable &= self.dihedral[facets] < crease
        return passable

    def sides(self, edges: IntArray) -> BoolArray:
        """(m, 3) the sides of facets that are some (k,) edges, numbered as ``pairs``."""
        out = np.zeros(self.neighbour.shape, dtype=bool)
        out.reshape(-1)[self.pair_sides[edges]] = True
        return out
