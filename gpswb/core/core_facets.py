# SPDX-License-Identifier: LGPL-2.1-or-later
"""The facets of a region that its neighbours can't have touched."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import BoolArray, IntArray, Mesh


def core_facets(mesh: Mesh, region: IntArray, crease: BoolArray) -> BoolArray:
    """Facets that share no smooth vertex with another region, in regions that have enough of them.

    Normals at a tangent border mix both sides, and the first row of facets may lie on the wrong
    one; three facets in ten must be left, or the whole region speaks for itself.

    Returns:
        (m,) bool.
    """
    smooth = mesh.facet_pairs[~crease]
    ends = mesh.pair_edges[~crease]
    border = region[smooth[:, 0]] != region[smooth[:, 1]]
    touched = np.zeros(len(mesh.vertices), dtype=bool)
    touched[ends[border].ravel()] = True
    inner = ~touched[mesh.triangles].any(axis=1) & (region >= 0)
    count = int(region.max(initial=-1)) + 1
    inside = region >= 0
    total = np.bincount(region[inside], minlength=count)
    left = np.bincount(region[inside & inner], minlength=count)
    thin = left < 0.3 * total
    core = inner.copy()
    core[inside] |= thin[region[inside]]
    return core
