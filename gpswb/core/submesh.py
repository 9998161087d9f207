# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part of a mesh as a mesh of its own, so that work on few facets costs little."""

from __future__ import annotations

import numpy as np

from gpswb.core.facet_edges import edges_of_sides
from gpswb.core.mesh import BoolArray, IntArray, Mesh

WORTHWHILE = 0.5
"""Share of a mesh's facets below which a mesh of them alone is made: its tables cost as much as
what they save of a larger one."""


def submesh(mesh: Mesh, facets: IntArray, crease: BoolArray) -> tuple[Mesh, BoolArray]:
    """Some facets of a mesh with their vertices, in their order, and their creases.

    Args:
        mesh: the mesh.
        facets: (k,) different facets.
        crease: (e,) bool aligned with ``mesh.facet_pairs``.

    Returns:
        The mesh of k facets, and its creases: aligned with its own pairs, and true for a pair that
        was none in the whole (an edge of three facets of which one is left out).
    """
    triangles = mesh.triangles[facets]
    used = np.zeros(len(mesh.vertices), dtype=bool)
    used[triangles] = True
    number = np.cumsum(used) - 1
    part = Mesh(mesh.vertices[used], number[triangles])
    facet, side = np.divmod(part.half_edge_pairs[:, 0], 3)
    edge = edges_of_sides(mesh)[3 * facets[facet] + side]
    return part, np.where(edge >= 0, crease[edge], True) if len(crease) else edge < 0
