# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rim of a region, and what is inside it."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import IntArray, Mesh
from gpswb.core.robust.topology import FacetGraph


def inner_vertices(mesh: Mesh, graph: FacetGraph, facets: IntArray) -> IntArray:
    """(n,) vertices of facets that aren't on their rim."""
    within = np.zeros(len(mesh.triangles), dtype=bool)
    within[facets] = True
    neighbour = graph.neighbour[facets]
    row, side = np.nonzero((neighbour < 0) | ~within[np.maximum(neighbour, 0)])
    triangles = mesh.triangles[facets]
    rim = np.concatenate([triangles[row, side], triangles[row, (side + 1) % 3]])
    return np.setdiff1d(triangles, rim)
