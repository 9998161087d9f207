# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facets that may be curved: most of a part is planes, and needs no curvature estimated."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from gpswb.core.half_edges import single_sides

if TYPE_CHECKING:
    from gpswb.core.mesh import IntArray, Mesh

ROUNDING = 1e-9
"""Turning angle, rad, that rounding of coordinates may make between facets of one plane (1e-12 was
the most on the benchmark part, whose least real one was above 1e-6). The sagitta of a facet that
bends by less is below 1e-9 of its size, which counts as plane everywhere."""


def bent_facets(mesh: Mesh) -> IntArray:
    """(k,) facets with a corner at which the mesh isn't plane, ascending.

    Where it can't be told, beside degenerate facets and at sides without a single neighbour, the
    mesh isn't taken for plane.

    Args:
        mesh: the mesh.
    """
    bent = np.zeros(len(mesh.vertices), dtype=bool)
    bent[mesh.pair_edges.take(np.flatnonzero(mesh.turning > ROUNDING), axis=0)] = True
    bent[mesh.triangles[mesh.areas == 0.0]] = True
    bent[mesh.triangles[single_sides(mesh) // 3]] = True
    first, second, third = bent.take(mesh.triangles).T
    return np.flatnonzero(first | second | third)
