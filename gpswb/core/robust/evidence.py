# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the facets that lie on a surface prove it, or would lie on many others too."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.robust.growth import SPARE, Grown, stand_off, vertices_of
from gpswb.core.robust.surfaces import UNKNOWNS, Kind, distance
from gpswb.core.robust.topology import SMOOTH, FacetGraph

LINES = 4
"""Rulings that make a cylinder or cone: any three parallel lines lie on one cylinder."""

SURE_LINES = 5
"""Rulings that prove it: four of a symmetric profile lie on one cylinder, too."""

POINTS: dict[Kind, int] = {"sphere": 8, "torus": 10}
"""Vertices that prove a sphere (4 unknowns) or a torus (7, and two at each place of a profile)."""

PROFILE = 5
"""Different places on the tube that prove a torus: any three rings of vertices lie on one torus,
and four of a symmetric profile do. Three do where none is an edge (see ``is_one_profile``)."""

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

BULGE = 1e-3
"""Share of the chord from the first ring of a profile to the last by which those between must leave
it: vertices of a cone or cylinder that are off it by modelling tolerance leave it by less."""

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
    return max(1, int(_ends(angle).sum()))


def is_one_profile(mesh: Mesh, graph: FacetGraph, grown: Grown) -> bool:
    """Whether a torus has rings of vertices enough, or none that could be an edge between two.

    Where one face ends and another begins the mesh has an edge all along. A ring inside the region
    that facets reach across, from a ring before it to one behind it, is within a face; if it is
    clearly off the cone through those two.
    """
    corners = mesh.triangles[grown.facets]
    place = places_on_tube(mesh.vertices[corners].reshape(-1, 3), grown.surface).reshape(-1, 3)
    count = int(place.max()) + 1
    if count >= PROFILE or count < 3:
        return count >= PROFILE
    inside = np.isin(corners, inner_vertices(mesh, graph, grown.facets))
    low, high = place.min(axis=1), place.max(axis=1)
    for ring in range(1, count - 1):
        if not (((low < ring) & (ring < high)).any() and inside[place == ring].any()):
            return False
    return _bulge(grown.surface, mesh.vertices[corners], place) > BULGE


def _bulge(surface: FloatArray, corners: FloatArray, place: IntArray) -> float:
    """How far (k, 3, 3) corners at the rings between the first and the last one, by their (k, 3)
    place, are off the cone through these two, as share of its length."""
    x = corners - surface[:3]
    height = x @ surface[3:6]
    radius = np.linalg.norm(x - height[..., None] * surface[3:6], axis=2)
    first, last = place == 0, place == place.max()
    start = np.array([radius[first].mean(), height[first].mean()])
    chord = np.array([radius[last].mean(), height[last].mean()]) - start
    between = np.stack([radius, height], axis=-1)[~first & ~last] - start
    across = np.abs(between @ np.array([-chord[1], chord[0]])).min()
    return float(across / max(float(chord @ chord), 1e-300))


def places_on_tube(points: FloatArray, surface: FloatArray) -> IntArray:
    """(n,) number of the ring about a torus's tube at which each of (n, 3) points lies."""
    x = points - surface[:3]
    t = x @ surface[3:6]
    rho = np.linalg.norm(x - np.outer(t, surface[3:6]), axis=1)
    angle = np.arctan2(t, rho - surface[6])
    order = np.argsort(angle, kind="stable")
    new = _ends(angle[order])
    # The largest gap is where the tube is open.
    first = (int(np.argmax(_gaps(angle[order]))) + 1) % len(order)
    place = np.empty(len(order), dtype=np.int64)
    place[np.roll(order, -first)] = np.r_[0, np.cumsum(np.roll(new, -first)[:-1])]
    return place


def _gaps(angle: FloatArray) -> FloatArray:
    """(n,) gap behind each of sorted angles."""
    return np.diff(np.r_[angle, angle[0] + 2 * np.pi])


def _ends(angle: FloatArray) -> BoolArray:
    """(n,) whether a cluster of sorted angles ends at each: they are told apart by a small part of
    what they span."""
    gaps = _gaps(angle)
    span = 2 * np.pi - float(gaps.max())
    ends: BoolArray = gaps > max(1e-3 * span, 1e-9)
    return ends


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


def inner_vertices(mesh: Mesh, graph: FacetGraph, facets: IntArray) -> IntArray:
    """(n,) vertices of facets that aren't on their rim."""
    within = np.zeros(len(mesh.triangles), dtype=bool)
    within[facets] = True
    neighbour = graph.neighbour[facets]
    row, side = np.nonzero((neighbour < 0) | ~within[np.maximum(neighbour, 0)])
    triangles = mesh.triangles[facets]
    rim = np.concatenate([triangles[row, side], triangles[row, (side + 1) % 3]])
    return np.setdiff1d(triangles, rim)


def drifts(mesh: Mesh, graph: FacetGraph, grown: Grown, tolerance: float) -> bool:
    """Whether the mesh leaves the surface slowly behind many of the smooth border edges."""
    inside = np.zeros(len(mesh.triangles), dtype=bool)
    inside[grown.facets] = True
    neighbour = graph.neighbour[grown.facets]
    border = (neighbour >= 0) & ~inside[np.maximum(neighbour, 0)]
    border &= np.abs(graph.dihedral[grown.facets]) < SMOOTH
    outside = neighbour[border]
    if not len(outside):
        return False
    d, _ = distance(grown.kind, grown.surface[None], mesh.corners_of(outside).reshape(1, -1, 3))
    far = np.abs(d).reshape(-1, 3).max(axis=1)
    chord, _ = distance(grown.kind, grown.surface[None], mesh.centroids[grown.facets][None])
    slow = (far > tolerance) & (far < max(DRIFT * tolerance, float(np.median(np.abs(chord)))))
    return float(slow.mean()) >= DRIFT_SHARE
