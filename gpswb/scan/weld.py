# SPDX-License-Identifier: LGPL-2.1-or-later
"""Corners at the same place become one vertex."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from gpswb.core.mesh import Mesh

WELD = 2.0**-21
"""Four units in the last place of single precision, relative to the largest coordinate: what the
writers of STL round away; corners nearer than this are one."""


def weld(mesh: Mesh) -> Mesh:
    """Unite vertices nearer than ``WELD`` and drop those that no triangle uses.

    Triangles that this folds to a line or a point are dropped as well.
    """
    used = mesh.vertices[mesh.triangles.ravel()] + 0.0  # turns -0.0 into 0.0
    vertices, index = np.unique(used, axis=0, return_inverse=True)
    index = index.reshape(-1)
    reach = WELD * float(np.abs(vertices).max(initial=0.0))
    near = cKDTree(vertices).query_pairs(reach, output_type="ndarray")
    if len(near):
        n = len(vertices)
        graph = coo_array((np.ones(len(near)), (near[:, 0], near[:, 1])), shape=(n, n))
        count, label = connected_components(graph, directed=False)
        first = np.full(count, n, dtype=np.int64)
        np.minimum.at(first, label, np.arange(n))
        vertices, index = vertices[first], label[index]
    triangles = index.reshape(-1, 3).astype(np.int64)
    if len(near):
        a, b, c = triangles.T
        triangles = triangles[(a != b) & (b != c) & (c != a)]
    return Mesh(vertices, triangles)
