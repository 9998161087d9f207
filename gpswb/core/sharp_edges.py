# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sharp edges: by curvedness as printed (paper, equations 6 and 7), and by dihedral angle."""

from __future__ import annotations

from collections.abc import Iterator

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
    edge_of = edges_of_sides(mesh)
    far = np.empty((2, 2, len(doubtful)), dtype=np.int64)
    for part in blocks(len(doubtful)):
        far[..., part] = _edges_beyond(mesh, doubtful[part], edge_of)
    rate = _rates_of_turning(mesh, far, np.where(sharp, 0.0, angle))
    for part in blocks(len(doubtful)):
        edges = doubtful[part]
        expected = _turning_of_chords(mesh, edges, rate[far[..., part]].max(axis=1))
        # Most edges turn no further than the surface beside them, whatever else is around.
        left = angle[edges] > tol.sharp_factor * expected + tol.never_sharp
        edges, expected = edges[left], expected[left]
        expected += _roughness(mesh, edges, angle, edge_of)
        sharp[edges] = angle[edges] > tol.sharp_factor * expected + tol.never_sharp
    return sharp


def _edges_beyond(mesh: Mesh, edges: IntArray, edge_of: IntArray) -> IntArray:
    """Edges that share no vertex with an edge, of the facets around its two facets.

    Args:
        mesh: the mesh.
        edges: (d,) the edges.
        edge_of: (3 m,) see `edges_of_sides`.

    Returns:
        (2, 2, d): beyond either side of either facet; -1 where there is none.
    """
    vertex = mesh.triangles.ravel()
    start, end = mesh.pair_edges[edges].T
    found = np.empty((2, 2, len(edges)), dtype=np.int64)
    for side, (half, opposite) in enumerate(_either_side(mesh, edges)):
        after = next_in_facet(half)
        # The other two sides of the facet, each with the edge's end that it begins or ends at.
        for k, (own, shared) in enumerate(
            ((after, vertex[after]), (next_in_facet(after), vertex[half]))
        ):
            beyond = sides_across(mesh, own, edge_of)
            following = next_in_facet(beyond)
            last = next_in_facet(following)
            # Of the facet beyond, one edge shares no vertex with the edge, as a rule.
            far = edge_of[np.where(vertex[beyond] == shared, following, last)]
            apex = vertex[last]
            usable = (beyond >= 0) & (beyond // 3 != opposite) & (apex != start) & (apex != end)
            found[side, k] = np.where(usable, far, -1)
    return found


def _rates_of_turning(mesh: Mesh, edges: IntArray, angle: FloatArray) -> FloatArray:
    """(e + 1,) angle of some edges over the lesser height beside each, 1/mm; 0 elsewhere and last.

    Args:
        mesh: the mesh.
        edges: the edges, of any shape; -1 for none.
        angle: (e,) rad.
    """
    asked = np.zeros(len(angle) + 1, dtype=bool)
    asked[edges] = True
    chosen = np.flatnonzero(asked[:-1])
    least = 2.0 * mesh.areas[mesh.facet_pairs[chosen]].min(axis=1)
    rate = np.zeros(len(asked))
    rate[chosen] = angle[chosen] * edge_lengths(mesh, chosen) / np.maximum(least, 1e-300)
    return rate


def _turning_of_chords(mesh: Mesh, edges: IntArray, rate: FloatArray) -> FloatArray:
    """(d,) rad by which the chords on either side of some edges (d,) would turn, where the surface
    turns at a rate (2, d), 1/mm."""
    facets = mesh.facet_pairs[edges].T
    height = 2.0 * mesh.areas[facets] / np.maximum(edge_lengths(mesh, edges), 1e-300)
    turning: FloatArray = (0.5 * height * rate).sum(axis=0)
    return turning


def _roughness(mesh: Mesh, edges: IntArray, angle: FloatArray, edge_of: IntArray) -> FloatArray:
    """(d,) rad by which the edges around some edges (d,) turn: their median, as most edges around
    a crease are none; 0 where there are none."""
    nearby = np.full((12, len(edges)), np.nan)
    column = 0
    for half, opposite in _either_side(mesh, edges):
        after = next_in_facet(half)
        for own in (after, next_in_facet(after)):
            beyond = sides_across(mesh, own, edge_of)
            there = (beyond >= 0) & (beyond // 3 != opposite)
            following = next_in_facet(beyond)
            for side in (own, following, next_in_facet(following)):
                candidate = edge_of[side]
                usable = there & (candidate >= 0) & (candidate != edges)
                nearby[column] = np.where(usable, angle[candidate], np.nan)
                column += 1
    return np.nan_to_num(_row_medians(nearby.T))


def _either_side(mesh: Mesh, edges: IntArray) -> Iterator[tuple[IntArray, IntArray]]:
    """Half-edges (d,) of some edges (d,) in one of their facets, and the other facets (d,)."""
    for side in (0, 1):
        yield mesh.half_edge_pairs[edges, side], mesh.facet_pairs[edges, 1 - side]


def _row_medians(values: FloatArray) -> FloatArray:
    """Lower median of each row, NaN left out; NaN for a row of NaN."""
    ordered = np.sort(values, axis=1)
    count = np.isfinite(ordered).sum(axis=1)
    median: FloatArray = ordered[np.arange(len(values)), np.maximum(count - 1, 0) // 2]
    return median
