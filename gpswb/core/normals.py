# SPDX-License-Identifier: LGPL-2.1-or-later
"""Normals at the corners of facets, with the weights of Max (1999)."""

from __future__ import annotations

import numpy as np
from scipy.sparse import csc_matrix

from gpswb.core.blocks import blocks
from gpswb.core.facet_geometry import dot
from gpswb.core.mesh import FloatArray, Mesh
from gpswb.core.wedges import Wedges


def wedge_normals(mesh: Mesh, wedges: Wedges) -> FloatArray:
    """Unit normal of each wedge: facet normals weighted by sin(angle) / (|a| |b|).

    Max's weights ("Weights for computing vertex normals from facet normals", 1999) are exact on a
    sphere for any triangulation; area weights are several times worse. A wedge never reaches across
    a crease, so neither does its normal.

    Args:
        mesh: the mesh.
        wedges: which corners share a normal.

    Returns:
        (w, 3) float64 unit vectors; zero for a wedge of degenerate facets only.
    """
    weight = _max_weights(mesh).ravel()
    # A column for each facet, with its three corners: one pass for all axes.
    corners = np.arange(0, len(weight) + 1, 3)
    shape = (wedges.count, len(mesh.triangles))
    normals: FloatArray = (
        csc_matrix((weight, wedges.of_corner.ravel(), corners), shape) @ mesh.facet_normals
    )
    length = np.sqrt(dot(normals.T, normals.T))
    length[length == 0.0] = np.inf
    normals /= length[:, None]
    return normals


def _max_weights(mesh: Mesh) -> FloatArray:
    """(m, 3) sin(angle) / (|a| |b|) = 2 area / (|a|^2 |b|^2) at each corner, 0 without area; 1 in a
    plane, where weights make no difference."""
    weight = np.ones((len(mesh.triangles), 3))
    for part in blocks(len(mesh.bent_facets)):
        facets = mesh.bent_facets[part]
        corner = mesh.columns.take(mesh.triangles[facets].T, axis=1)
        side = corner[:, [1, 2, 0]] - corner
        squared = dot(side, side)
        # Corner k lies between the side that begins there and the one before.
        product = squared * squared[[2, 0, 1]]
        product[product == 0.0] = np.inf
        weight[facets] = (2.0 * mesh.areas[facets] / product).T
    return weight
