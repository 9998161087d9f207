# SPDX-License-Identifier: LGPL-2.1-or-later
"""Normals at the corners of facets, with the weights of Max (1999)."""

from __future__ import annotations

import numpy as np

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
    corners = mesh.corners
    toward_next = np.roll(corners, -1, axis=1) - corners
    toward_previous = np.roll(corners, 1, axis=1) - corners
    squared = np.einsum("fij,fij->fi", toward_next, toward_next) * np.einsum(
        "fij,fij->fi", toward_previous, toward_previous
    )
    twice_area = 2.0 * mesh.areas[:, None]
    weight = np.divide(twice_area, squared, out=np.zeros_like(squared), where=squared > 0)
    total = wedges.sum_corners(weight[:, :, None] * mesh.facet_normals[:, None, :])
    length = np.linalg.norm(total, axis=1, keepdims=True)
    normals: FloatArray = np.divide(total, length, out=np.zeros_like(total), where=length > 0)
    return normals
