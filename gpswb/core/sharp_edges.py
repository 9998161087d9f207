# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sharp edges: by curvedness as printed (paper, equations 6 and 7), and by dihedral angle."""

from __future__ import annotations

import numpy as np

from gpswb.core.blocks import blocks
from gpswb.core.facet_edges import edge_lengths, edges_of_sides, sides_across
from gpswb.core.half_edges import next_in_facet
from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.tolerances import Tolerances


def sharp_vertices_by_curvedness(curvedness: FloatArray, coefficient: float = 1.0) -> BoolArray:
    """Vertices on sharp edges as printed: c - c_min > lambda (c_max + c_min) / 2.

    The largest curvedness comes from the shortest edge of the mesh, so edges whose facets are wider
    fall below the threshold and are missed: a defect of the print that is kept here.

    Args:
        curvedness: (n,) curvedness of each vertex, 1/mm.
        coefficient: lambda of equation (7).

    Returns:
        (n,) bool.
    """
    if not len(curvedness):
        return np.zeros(0, dtype=bool)
    low, high = float(curvedness.min()), float(curvedness.max())
    sharp: BoolArray = curvedness - low > coefficient * (high + low) / 2.0
    return sharp


def feature_edges(mesh: Mesh, tolerances: Tolerances | None = None) -> BoolArray:
    """Edges that turn further than the smooth surface beside them (design, section 5).

    The curvature on each side of an edge is taken from the edges of the facets around that share no
    vertex with it; a chord of that surface turns by half of each side's curvature times the width
    of its facet. An edge that turns much further than that, and than most edges around, is a
    feature edge.

    Args:
        mesh: the mesh.
        tolerances: thresholds; the defaults if not given.

    Returns:
        (e,) bool aligned with ``mesh.facet_pairs``.
    """
    tol = tolerances or Tolerances()
    angle = mesh.turning
    sharp: BoolArray = angle > tol.always_sharp
    doubtful = np.flatnonzero((angle > tol.never_sharp) & ~sharp)
    if not len(doubtful):
        return sharp
    rate = np.where(sharp, 0.0, angle) * edge_lengths(mesh)
    rate /= np.maximum(2.0 * mesh.areas[mesh.facet_pairs].min(axis=1), 1e-300)
    edge_of, across = edges_of_sides(mesh), sides_across(mesh)
    for part in blocks(len(doubtful)):
        edges = doubtful[part]
        expected = _expected_turning(mesh, edges, angle, rate, edge_of, across)
        sharp[edges] = angle[edges] > tol.sharp_factor * expected + tol.never_sharp
    return sharp


def _expected_turning(
    mesh: Mesh,
    edges: IntArray,
    angle: FloatArray,
    rate: FloatArray,
    edge_of: IntArray,
    across: IntArray,
) -> FloatArray:
    """(d,) rad by which a smooth surface would turn at some edges.

    Args:
        mesh: the mesh.
        edges: (d,) the edges.
        angle: (e,) turning angle of every edge; ``rate`` (e,) over the lesser height beside it,
            1/mm, 0 where the edge is sharp whatever surrounds it.
        edge_of, across: (3 m,) see `edges_of_sides` and `sides_across`.
    """
    vertex = mesh.triangles.ravel()
    ends = mesh.pair_edges[edges].T
    length = edge_lengths(mesh, edges)
    expected = np.zeros(len(edges))
    nearby = np.full((12, len(edges)), np.nan)
    column = 0
    for side in (0, 1):
        half = mesh.half_edge_pairs[edges, side]
        opposite = mesh.facet_pairs[edges, 1 - side]
        after = next_in_facet(half)
        largest = np.zeros(len(edges))
        # The other two sides of the facet, each with the edge's end that it begins or ends at.
        for own, shared in ((after, vertex[after]), (next_in_facet(after), vertex[half])):
            beyond = across[own]
            there = (beyond >= 0) & (beyond // 3 != opposite)
            following = next_in_facet(beyond)
            last = next_in_facet(following)
            for candidate in (edge_of[own], edge_of[following], edge_of[last]):
                usable = there & (candidate >= 0) & (candidate != edges)
                nearby[column] = np.where(usable, angle[candidate], np.nan)
                column += 1
            # Of the facet beyond, one edge shares no vertex with the edge, as a rule.
            far = edge_of[np.where(vertex[beyond] == shared, following, last)]
            apex = vertex[last]
            usable = there & (far >= 0) & (apex != ends[0]) & (apex != ends[1])
            np.maximum(largest, np.where(usable, rate[far], 0.0), out=largest)
        height = 2.0 * mesh.areas[half // 3] / np.maximum(length, 1e-300)
        expected += 0.5 * height * largest
    # Most edges around a crease are none: their median is how rough the surface is.
    return expected + np.nan_to_num(_row_medians(nearby.T))


def _row_medians(values: FloatArray) -> FloatArray:
    """Lower median of each row, NaN left out; NaN for a row of NaN."""
    ordered = np.sort(values, axis=1)
    count = np.isfinite(ordered).sum(axis=1)
    median: FloatArray = ordered[np.arange(len(values)), np.maximum(count - 1, 0) // 2]
    return median
