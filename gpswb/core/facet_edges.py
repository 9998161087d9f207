# SPDX-License-Identifier: LGPL-2.1-or-later
"""What lies at each half-edge (see `half_edges`): its interior edge, and the half-edge across."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import IntArray, Mesh


def edges_of_sides(mesh: Mesh) -> IntArray:
    """(3 m,) row of ``mesh.facet_pairs`` of each half-edge; -1 where it is no interior edge."""
    edge_of = np.full(3 * len(mesh.triangles), -1, dtype=np.int64)
    for half in mesh.half_edge_pairs.T:
        edge_of[half] = np.arange(len(half))
    return edge_of


def sides_across(mesh: Mesh) -> IntArray:
    """(3 m,) half-edge of the neighbouring facet on the same edge; -1 where there is none."""
    across = np.full(3 * len(mesh.triangles), -1, dtype=np.int64)
    first, second = mesh.half_edge_pairs.T
    across[first], across[second] = second, first
    return across
