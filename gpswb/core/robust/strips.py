# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flat polygons in a row: a curved face coarsely meshed, or just some planes."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import BoolArray, IntArray
from gpswb.core.robust.consensus import CREASE
from gpswb.core.robust.topology import FacetGraph

STRIPS = 5
"""Polygons that smoothly follow each other before they can be a curved face: fewer planes in a row
are planes."""


def few_polygons(
    graph: FacetGraph, polygon: IntArray, rest: BoolArray, crease: BoolArray | None = None
) -> BoolArray:
    """(m,) facets of ``rest`` that hang together smoothly in fewer than ``STRIPS`` polygons.

    Args:
        graph: the adjacency.
        polygon: (m,) coplanar polygon of each facet.
        rest: (m,) the facets looked at; paths don't leave them.
        crease: (e,) pairs that are feature edges besides those that turn by much.
    """
    joined = graph.within(rest)
    smooth = graph.pair_dihedral < CREASE
    if crease is not None:
        smooth &= ~crease
    smooth |= polygon[graph.pairs[:, 0]] == polygon[graph.pairs[:, 1]]
    part = graph.components(joined & smooth, len(rest))
    pieces = np.unique(np.column_stack([part[rest], polygon[rest]]), axis=0)
    count = np.bincount(pieces[:, 0], minlength=len(rest))
    few: BoolArray = rest & (count[part] < STRIPS)
    return few
