# SPDX-License-Identifier: LGPL-2.1-or-later
"""The regions that a piece may be of: what it smoothly continues into, and how."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gpswb.core.mesh import BoolArray, IntArray, Mesh
from gpswb.core.robust.curvature_jumps import curvature_jumps
from gpswb.core.robust.growth import Grown
from gpswb.core.robust.surfaces import distance
from gpswb.core.robust.topology import SMOOTH, FacetGraph


def sides_that_go_on(mesh: Mesh, graph: FacetGraph, label: IntArray) -> BoolArray:
    """(m, 3) sides at which another label begins and curvature is seen not to jump."""
    rim = np.flatnonzero(graph.smooth & (label[graph.pairs[:, 0]] != label[graph.pairs[:, 1]]))
    _, none = curvature_jumps(mesh, graph, rim, graph.smooth)
    return graph.sides(rim[none])


@dataclass(frozen=True)
class Host:
    """A region that a piece may be of.

    Args:
        number: its label.
        size: its facets.
        smooth: share of the piece's border that is smooth.
        only: share of that which is with this region.
        seen: share of the piece's border with it across which curvature is seen not to jump.
        far: how far the piece's corners are off its surface, mm; infinite where it has none.
        extent: how far they are apart, mm.
    """

    number: int
    size: int
    smooth: float
    only: float
    seen: float
    far: float
    extent: float


def hosts_of(
    mesh: Mesh,
    graph: FacetGraph,
    label: IntArray,
    facets: IntArray,
    goes_on: BoolArray,
    surfaces: Sequence[Grown],
) -> list[Host]:
    """What facets smoothly continue into, of what shares half as much border as what shares most.

    Args:
        mesh: the mesh.
        graph: its adjacency.
        label: (m,) region of each facet, -1 for none; the first are those of ``surfaces``.
        facets: (k,) facets of one label.
        goes_on: (m, 3) see ``sides_that_go_on``.
        surfaces: what the facets of a label lie on.

    Returns:
        The region with the nearest surface first, then the largest.
    """
    own = label[facets[0]]
    neighbour = graph.neighbour[facets]
    other = np.where(neighbour >= 0, label[np.maximum(neighbour, 0)], -1)
    border = other != own
    corners = mesh.corners_of(facets)
    length = np.linalg.norm(corners[:, [1, 2, 0]] - corners, axis=2)
    turn = graph.dihedral[facets]
    # A facet that is folded over lies in the region beside it all the same.
    smooth = border & (other >= 0) & (np.minimum(turn, np.pi - turn) < SMOOTH)
    if not smooth.any():
        return []
    total = np.bincount(other[smooth], length[smooth])
    around = max(float(length[border].sum()), 1e-300)
    points = corners.reshape(-1, 3)
    extent = float(np.linalg.norm(np.ptp(points, axis=0)))
    hosts = []
    # Another piece may share more of the border: it is the larger region that is continued.
    for number in np.flatnonzero(total >= 0.5 * total.max()).tolist():
        far = np.inf
        if number < len(surfaces):
            g = surfaces[number]
            far = float(np.abs(distance(g.kind, g.surface[None], points[None])[0]).max())
        hosts.append(
            Host(
                number=number,
                size=int((label == number).sum()),
                smooth=float(total.sum()) / around,
                only=float(total[number] / total.sum()),
                seen=float(length[goes_on[facets] & (other == number)].sum()) / around,
                far=far,
                extent=extent,
            )
        )
    return sorted(hosts, key=lambda host: (host.far, -host.size))
