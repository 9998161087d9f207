# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the facets that lie on a surface prove it, or would lie on many others too."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import FloatArray, Mesh
from gpswb.core.robust.angles import ends_of
from gpswb.core.robust.growth import SPARE, Grown, stand_off, vertices_of
from gpswb.core.robust.one_profile import is_one_profile
from gpswb.core.robust.rim import inner_vertices
from gpswb.core.robust.surfaces import UNKNOWNS, Kind, distance
from gpswb.core.robust.topology import SMOOTH, FacetGraph

LINES = 4
"""Rulings that make a cylinder or cone: any three parallel lines lie on one cylinder."""

SURE_LINES = 5
"""Rulings that prove it: four of a symmetric profile lie on one cylinder, too."""

POINTS: dict[Kind, int] = {"sphere": 8, "torus": 10}
"""Vertices that prove a sphere (4 unknowns) or a torus (7, and two at each place of a profile)."""

BEND = 20.0
"""Tolerances that a region must bend by: less and it lies on many other surfaces, too."""

DRIFT = 3.0
"""Outside a true border vertices leave the surface at once; on a freeform surface they drift away:
their distance stays within so many tolerances, or within the chord error of the facets inside."""

EXACT = 3e4
"""A region that bends by so many times what its vertices stand off is exact: no patch of another
surface comes near, whatever continues behind its border."""

CHANCE = 1000.0
"""A region that bends by less than so many times what it stands off may be a chance fit: two
tangent surfaces whose curvatures differ by a third leave as much."""

INSIDE = 1e-5
"""Share of the diagonal by which vertices inside a face may be off its surface: those of its edges
hold to the modelling tolerance of exchanged files only, which is wider."""

MOST = 0.9
"""Share of them that must be: a region may have grown a row beyond a border."""

DRIFT_SHARE = 0.3
"""Share of drifting border edges that disproves a surface."""


def enough_evidence(mesh: Mesh, graph: FacetGraph, grown: Grown, tolerance: float) -> bool:
    """Whether a grown region proves its surface."""
    if len(grown.facets) < 4:
        return False
    points = vertices_of(mesh, grown.facets)
    if grown.kind in ("cylinder", "cone"):
        if distinct_rulings(points, grown.surface) < LINES:
            return False
    elif len(points) < POINTS[grown.kind] or (
        grown.kind == "torus" and not is_one_profile(mesh, graph, grown)
    ):
        return False
    if sagitta(mesh, grown) < BEND * tolerance:
        return False
    if is_exact(mesh, grown):
        return True
    return holds_inside(mesh, graph, grown, tolerance) and not drifts(mesh, graph, grown, tolerance)


def is_exact(mesh: Mesh, grown: Grown) -> bool:
    """Whether a region bends far more than it deviates, and has rulings enough to prove it."""
    points = vertices_of(mesh, grown.facets)
    if sagitta(mesh, grown) < EXACT * stand_off(grown, points):
        return False
    if grown.kind not in ("cylinder", "cone"):
        return True
    return distinct_rulings(points, grown.surface) >= SURE_LINES


def distinct_rulings(points: FloatArray, surface: FloatArray) -> int:
    """Number of different angles about the axis at which (n, 3) points lie."""
    u = surface[3:6]
    e1 = np.cross(u, [1.0, 0.0, 0.0] if abs(u[0]) < 0.7 else [0.0, 1.0, 0.0])
    e1 /= np.linalg.norm(e1)
    x = points - surface[:3]
    angle = np.sort(np.arctan2(x @ np.cross(u, e1), x @ e1))
    return max(1, int(ends_of(angle).sum()))


def sagitta(mesh: Mesh, grown: Grown) -> float:
    """How far the region's vertices leave their mean plane, mm: a flat one proves no curvature."""
    points = vertices_of(mesh, grown.facets)
    x = points - points.mean(axis=0)
    normal = np.linalg.eigh(x.T @ x)[1][:, 0]
    return float(np.ptp(x @ normal))


def holds_inside(mesh: Mesh, graph: FacetGraph, grown: Grown, tolerance: float) -> bool:
    """Whether the vertices inside a region are on its surface, however wide the tolerance.

    A region with hardly any, such as a strip, is not told by them.
    """
    limit = INSIDE * mesh.diagonal
    if tolerance <= limit:
        return True
    inner = inner_vertices(mesh, graph, grown.facets)
    if len(inner) < UNKNOWNS[grown.kind] + SPARE:
        return True
    d, _ = distance(grown.kind, grown.surface[None], mesh.vertices[inner][None])
    off = float(np.quantile(np.abs(d), MOST))
    return off <= limit and sagitta(mesh, grown) >= CHANCE * off


def drifts(mesh: Mesh, graph: FacetGraph, grown: Grown, tolerance: float) -> bool:
    """Whether the mesh leaves the surface slowly behind many of the smooth border edges."""
    inside = np.zeros(len(mesh.triangles), dtype=bool)
    inside[grown.facets] = True
    neighbour = graph.neighbour[grown.facets]
    border = (neighbour >= 0) & ~inside[np.maximum(neighbour, 0)]
    border &= graph.dihedral[grown.facets] < SMOOTH
    outside = neighbour[border]
    if not len(outside):
        return False
    d, _ = distance(grown.kind, grown.surface[None], mesh.corners_of(outside).reshape(1, -1, 3))
    far = np.abs(d).reshape(-1, 3).max(axis=1)
    chord, _ = distance(grown.kind, grown.surface[None], mesh.centroids[grown.facets][None])
    slow = (far > tolerance) & (far < max(DRIFT * tolerance, float(np.median(np.abs(chord)))))
    return float(slow.mean()) >= DRIFT_SHARE
