# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coplanar facets joined to polygons, and which of them can only be planes."""

from __future__ import annotations

from itertools import combinations

import numpy as np

from gpswb.core.blocks import blocks
from gpswb.core.distinct import distinct
from gpswb.core.facet_edges import edge_lengths, heights_across
from gpswb.core.facet_geometry import dot
from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.robust.topology import FacetGraph

FLAT = 2e-3
"""Turning angle (rad) of two facets of a plane at most: a fine mesh of a large cylinder keeps the
distances, but turns by more."""

STRICT = 1e-3
"""Share of both tolerances by which what was joined to more than a plane is joined again: a plane
that ends at a tiny curved face is exact, the facets of that face are not."""

GENTLE = 5 * FLAT
"""Turning angle (rad) at a polygon's border that says the surface goes on."""

MANY = 60
"""Facets of a polygon that no nearly flat place of a curved surface reaches."""

GENTLE_SHARE = 0.3
"""Share of its border at which the surface may go on beyond a true plane: beside a flat fillet."""


def coplanar_polygons(mesh: Mesh, graph: FacetGraph, tolerance: float) -> IntArray:
    """Join facets whose vertices lie in one plane.

    Args:
        mesh: the mesh.
        graph: its adjacency.
        tolerance: distance from the plane that counts as none, mm.

    Returns:
        (m,) int64 polygon of each facet, 0-based.
    """
    m = len(mesh.triangles)
    joined = np.empty(len(graph.pairs), dtype=bool)
    normals = np.ascontiguousarray(mesh.facet_normals.T)
    for part in blocks(len(joined)):
        joined[part] = _coplanar(mesh, normals, graph, part, tolerance, FLAT)
    label = graph.components(joined, m)
    # Small steps add up along a gently curved surface: such chains fall apart again.
    loose = (_deviation(mesh, label) > 3.0 * tolerance)[label]
    if loose.any():
        again = np.flatnonzero(joined & loose[graph.pairs[:, 0]])
        for part in blocks(len(again)):
            joined[again[part]] = _coplanar(
                mesh, normals, graph, again[part], STRICT * tolerance, STRICT * FLAT
            )
        label = graph.components(joined, m)
        loose = (_deviation(mesh, label) > 3.0 * tolerance)[label]
        label[loose] = label.max() + 1 + np.arange(int(loose.sum()))
    number = np.cumsum(np.bincount(label) > 0) - 1
    polygon: IntArray = number[label]
    return polygon


def _coplanar(
    mesh: Mesh,
    normals: FloatArray,
    graph: FacetGraph,
    part: slice | IntArray,
    tolerance: float,
    flat: float,
) -> BoolArray:
    """Which pairs of facets, of some of them, lie in one plane.

    Args:
        mesh: the mesh.
        normals: (3, m) facet normals, axis by axis.
        graph: its adjacency.
        part: which pairs.
        tolerance: see `coplanar_polygons`; ``flat`` rad, their turning angle at most.
    """
    length = np.maximum(edge_lengths(mesh, part), 1e-300)
    altitude = 2.0 * mesh.areas[graph.pairs[part]].T / length
    # A sliver's plane is only known as well as its altitude: it tilts by tolerance / altitude.
    lever = altitude[::-1] / np.maximum(altitude, 1e-300)
    joined = (heights_across(mesh, normals, part) <= tolerance * np.maximum(1.0, lever)).all(axis=0)
    turn = flat + 0.04 * tolerance / np.maximum(altitude.min(axis=0), 1e-300)
    # Where a thin ring is meshed more coarsely than it is wide, facets fold over in their plane.
    angle = graph.pair_dihedral[part]
    joined &= np.minimum(angle, np.pi - angle) < np.minimum(turn, 0.5)
    return np.asarray(joined, dtype=bool)


def certain_planes(mesh: Mesh, graph: FacetGraph, polygon: IntArray, tolerance: float) -> BoolArray:
    """Which polygons are planes whatever lies around them.

    Four vertices of a tessellated cylinder lie in a plane too, as do all vertices between two
    rulings: a polygon proves a plane when it has five vertices that don't lie on two lines, and
    when the mesh doesn't leave it as gently as a nearly flat surface would.

    Returns:
        (k,) bool for the k polygons.
    """
    k = int(polygon.max()) + 1 if len(polygon) else 0
    count = np.bincount(polygon, minlength=k)
    order = np.argsort(polygon, kind="stable")
    start = np.r_[0, np.cumsum(count)]
    certain = np.zeros(k, dtype=bool)
    for i in np.flatnonzero(count >= 3):
        vertices = distinct(mesh.triangles[order[start[i] : start[i + 1]]].ravel())
        if len(vertices) >= 5:
            certain[i] = not _on_two_lines(mesh.vertices[vertices], tolerance)
    goes_on = _gentle_share(mesh, graph, polygon, k) >= GENTLE_SHARE
    return certain & ~(goes_on & (count < MANY))


def _gentle_share(mesh: Mesh, graph: FacetGraph, polygon: IntArray, k: int) -> FloatArray:
    """(k,) share of each polygon's border length at which the mesh hardly turns."""
    a, b = polygon[graph.pairs].T
    across = a != b
    ends = mesh.vertices[graph.pair_edges[across]]
    length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    gentle = length * (graph.pair_dihedral[across] < GENTLE)
    both = np.concatenate([a[across], b[across]])
    total = np.bincount(both, np.tile(length, 2), k)
    share: FloatArray = np.bincount(both, np.tile(gentle, 2), k) / np.maximum(total, 1e-300)
    return share


def _on_two_lines(points: FloatArray, tolerance: float) -> bool:
    """Whether all points lie on two lines: of any five on two lines, three are collinear."""
    for triple in combinations(range(5), 3):
        p, q, r = points[list(triple)]
        sides = ((p, q), (q, r), (p, r))
        far = max(sides, key=lambda s: float(np.sum((s[1] - s[0]) ** 2)))
        off = _off_line(points, far[0], far[1])
        if off[list(triple)].max() > tolerance:
            continue
        rest = points[off > tolerance]
        if len(rest) <= 2:
            return True
        spread = np.argmax(np.sum((rest - rest[0]) ** 2, axis=1))
        if _off_line(rest, rest[0], rest[spread]).max() <= tolerance:
            return True
    return False


def _off_line(points: FloatArray, p: FloatArray, q: FloatArray) -> FloatArray:
    u = (q - p) / max(float(np.linalg.norm(q - p)), 1e-300)
    x = points - p
    off: FloatArray = np.linalg.norm(x - np.outer(x @ u, u), axis=1)
    return off


def _deviation(mesh: Mesh, label: IntArray) -> FloatArray:
    """(k,) largest distance of a component's vertices from its mean plane."""
    k = int(label.max()) + 1
    normal = np.array(
        [np.bincount(label, mesh.facet_normals[:, i] * mesh.areas, k) for i in range(3)]
    )
    normal /= np.maximum(np.sqrt(dot(normal, normal)), 1e-300)
    count = np.maximum(np.bincount(label, minlength=k), 1)
    centre = np.array([np.bincount(label, mesh.centroids[:, i], k) for i in range(3)]) / count
    top, bottom = np.full(k, -np.inf), np.full(k, np.inf)
    for part in blocks(len(label)):
        own = label[part]
        corner = mesh.columns.take(mesh.triangles[part].T, axis=1)
        height = dot(corner - centre.take(own, axis=1)[:, None], normal.take(own, axis=1)[:, None])
        np.maximum.at(top, own, height.max(axis=0))
        np.minimum.at(bottom, own, height.min(axis=0))
    deviation: FloatArray = 0.5 * (top - bottom)
    return deviation
