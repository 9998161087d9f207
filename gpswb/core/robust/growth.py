# SPDX-License-Identifier: LGPL-2.1-or-later
"""The facets around a seed that lie on one surface."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gpswb.core.distinct import distinct
from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.robust.fitting import fit, fit_patches
from gpswb.core.robust.surfaces import UNKNOWNS, Kind, distance, largest_curvature
from gpswb.core.robust.topology import FacetGraph

TURN_SHARE = 1.2
"""A facet with its corners on a surface turns from it by about the angle that its circumradius
spans, obtuse slivers included; much more means that it only touches the surface."""

LARGEST_TURN = 1.25
"""Facets that turn by more (rad) say nothing: the caps of a cylinder have their rims on it."""

REFITS = 4
"""Rounds of fitting and growing; exact data settle in two."""

AHEAD = 256
"""Facets around a region that are tested together, at least: numpy takes as long for a few."""

MOST_RINGS = 16
"""Rings of facets around a region that are tested together, at most."""

SAMPLE = 1500
"""Vertices used to fit a grown region: more don't make exact data more exact."""

SPARE = 8
"""Points beyond a surface's unknowns that show how far the others stand off it, at least."""


@dataclass(frozen=True, eq=False)
class Grown:
    """A surface and the connected facets that lie on it."""

    kind: Kind
    surface: FloatArray
    facets: IntArray


def on_surface(
    mesh: Mesh, kind: Kind, surface: FloatArray, facets: IntArray, tolerance: float, side: float
) -> BoolArray:
    """(k,) whether the given facets lie on a surface, by position first and then by normal.

    Args:
        mesh: the mesh.
        kind: kind of the surface.
        surface: (8,), see ``surfaces``.
        facets: (k,) facet indices.
        tolerance: largest distance of a corner, mm.
        side: +1 or -1, which side of the surface is outside; 0 for either.
    """
    corners = mesh.corners_of(facets)
    # The corners for their distance and the centroid for the normal there.
    points = np.concatenate([corners, corners.mean(axis=1, keepdims=True)], axis=1)
    d, normal = distance(kind, surface[None], points.reshape(1, -1, 3))
    near = np.abs(d).reshape(-1, 4)[:, :3].max(axis=1) <= tolerance
    own = mesh.facet_normals[facets]
    cosine = np.einsum("ik,ik->i", normal[0].reshape(-1, 4, 3)[:, 3], own)
    cosine = cosine * side if side else np.abs(cosine)
    sides = corners - corners[:, [2, 0, 1]]
    edges = np.sqrt(np.einsum("fkx,fkx->fk", sides, sides))
    area = np.maximum(mesh.areas[facets], 1e-300)
    bend = edges.prod(axis=1) / (4.0 * area) * largest_curvature(kind, surface, points[:, 3])
    altitude = 2.0 * area / np.maximum(edges.max(axis=1), 1e-300)
    # A sliver's normal is only known to tolerance / altitude.
    slack = 0.02 + 2.0 * tolerance / np.maximum(altitude, 1e-300)
    # The facet turns by no more than an angle that is far from 0, so that cosines tell it exactly.
    lies: BoolArray = near & (cosine >= np.cos(np.minimum(TURN_SHARE * bend + slack, LARGEST_TURN)))
    # A facet without area turns from nothing.
    lies |= near & (mesh.areas[facets] <= 0.0)
    return lies


def grow(
    mesh: Mesh,
    graph: FacetGraph,
    kind: Kind,
    surface: FloatArray,
    seed: IntArray,
    allowed: BoolArray,
    tolerance: float,
    facets: IntArray | None = None,
) -> Grown:
    """Grow from seed facets over the facets that lie on a surface, refitting it to what was found.

    Args:
        mesh: the mesh.
        graph: its adjacency.
        kind: kind of the surface.
        surface: (8,) hypothesis.
        seed: facets to start from.
        allowed: (m,) facets that may be taken.
        tolerance: largest distance of a vertex, mm.
        facets: what the hypothesis grows to, if that is known already.
    """
    if facets is None:
        facets = flood(mesh, graph, kind, surface, seed, allowed, tolerance)
    for _ in range(REFITS - 1):
        if not len(facets):
            break
        surface = refit(mesh, kind, surface, facets)
        if residual(mesh, Grown(kind, surface, facets)) <= tolerance:
            # All of it is on the new surface still: only what surrounds it is to be asked.
            found = flood(mesh, graph, kind, surface, facets, allowed, tolerance, lying=True)
        else:
            found = flood(mesh, graph, kind, surface, seed, allowed, tolerance)
        if len(found) <= len(facets):
            break
        settled = len(found) < 1.02 * len(facets)
        facets = found
        if settled:
            break
    return Grown(kind, surface, facets)


def refit(mesh: Mesh, kind: Kind, surface: FloatArray, facets: IntArray) -> FloatArray:
    """(8,) the surface fitted to the vertices of facets by least squares."""
    vertices = distinct(mesh.triangles[facets].ravel())
    if len(vertices) > SAMPLE:
        vertices = vertices[np.linspace(0, len(vertices) - 1, SAMPLE).astype(np.int64)]
    points = mesh.vertices[vertices]
    centre = points.mean(axis=0)
    scale = max(float(np.abs(points - centre).max()), 1e-300)
    local = to_local(surface[None], centre[None], np.array([scale]), kind)
    better = fit(kind, local, (points - centre)[None] / scale, np.ones((1, len(points))))
    refitted: FloatArray = to_world(better, centre[None], np.array([scale]), kind)[0]
    return refitted


def fit_facets(mesh: Mesh, kind: Kind, facets: IntArray) -> FloatArray:
    """(8,) the surface of a kind nearest to the vertices of facets, found without a first guess."""
    if len(facets) > SAMPLE:
        facets = facets[np.linspace(0, len(facets) - 1, SAMPLE).astype(np.int64)]
    points = vertices_of(mesh, facets)
    centre = points.mean(axis=0)
    scale = max(float(np.abs(points - centre).max()), 1e-300)
    share = np.sqrt(mesh.areas[facets] / max(float(mesh.areas[facets].sum()), 1e-300))
    local = fit_patches(
        kind,
        (points - centre)[None] / scale,
        np.ones((1, len(points))),
        (mesh.centroids[facets] - centre)[None] / scale,
        (mesh.facet_normals[facets] * share[:, None])[None],
    )
    surface: FloatArray = to_world(local, centre[None], np.array([scale]), kind)[0]
    return surface


def residual(mesh: Mesh, grown: Grown) -> float:
    """Largest distance of a region's vertices from its surface, mm."""
    corners = mesh.corners_of(grown.facets).reshape(1, -1, 3)
    return float(np.abs(distance(grown.kind, grown.surface[None], corners)[0]).max(initial=0.0))


def stand_off(grown: Grown, points: FloatArray) -> float:
    """Standard distance (mm) of (n, 3) points to a surface, by the median: a region may have taken
    in what lies beside its surface, which says nothing of the rest.

    Of few points, those that the surface was fitted to say nothing either.
    """
    offset = np.sort(np.abs(distance(grown.kind, grown.surface[None], points[None])[0][0]))
    last = len(offset) - 1
    told = min(max(last // 2, UNKNOWNS[grown.kind] + SPARE), last)
    return float(offset[told]) / 0.6745


def regions_of(label: IntArray, surfaces: Sequence[Grown]) -> list[Grown]:
    """The surfaces with the facets that have their numbers as (m,) labels, where there are any."""
    order = np.argsort(label, kind="stable")
    bounds = np.searchsorted(label[order], np.arange(len(surfaces) + 1))
    return [
        Grown(g.kind, g.surface, order[start:end])
        for g, start, end in zip(surfaces, bounds[:-1], bounds[1:], strict=True)
        if end > start
    ]


def vertices_of(mesh: Mesh, facets: IntArray) -> FloatArray:
    """(n, 3) mm, the vertices of facets, each once."""
    return mesh.vertices[distinct(mesh.triangles[facets].ravel())]


def to_local(surface: FloatArray, centre: FloatArray, scale: FloatArray, kind: Kind) -> FloatArray:
    """(b, 8) surfaces in coordinates (x - centre) / scale."""
    out = surface.copy()
    out[:, :3] = (out[:, :3] - centre) / scale[:, None]
    out[:, 6] /= scale
    if kind == "torus":
        out[:, 7] /= scale
    return slide(out, np.zeros_like(centre), kind)


def to_world(surface: FloatArray, centre: FloatArray, scale: FloatArray, kind: Kind) -> FloatArray:
    """(b, 8) surfaces from coordinates (x - centre) / scale back to mm."""
    out = slide(surface, np.zeros_like(centre), kind)
    out[:, :3] = out[:, :3] * scale[:, None] + centre
    out[:, 6] *= scale
    if kind == "torus":
        out[:, 7] *= scale
    return out


def slide(surface: FloatArray, target: FloatArray, kind: Kind) -> FloatArray:
    """Move the free point of axes and planes next to (b, 3) targets: the surface stays the same."""
    out = surface.copy()
    u = out[:, 3:6]
    along = np.einsum("bk,bk->b", target - out[:, :3], u)
    if kind in ("cylinder", "cone"):
        out[:, :3] += along[:, None] * u
        if kind == "cone":
            out[:, 6] += along * np.sin(out[:, 7])
    elif kind == "plane":
        out[:, :3] = target - along[:, None] * u
    return out


def flood(
    mesh: Mesh,
    graph: FacetGraph,
    kind: Kind,
    surface: FloatArray,
    seed: IntArray,
    allowed: BoolArray,
    tolerance: float,
    lying: bool = False,
) -> IntArray:
    """(k,) facets connected to the seed that lie on a surface; arguments as in ``grow``, and
    whether the seed is known to lie on it."""
    _, normal = distance(kind, surface[None], mesh.centroids[seed][None])
    side = float(np.sign(np.einsum("ik,ik->", normal[0], mesh.facet_normals[seed])))
    front = seed if lying else seed[on_surface(mesh, kind, surface, seed, tolerance, side)]
    # The last entry is that of the neighbour behind a border, -1: there is none.
    untested, lies = np.append(allowed, False), np.zeros(len(allowed) + 1, dtype=bool)
    untested[seed] = False
    taken = [front]
    most = AHEAD
    while len(front):
        ahead, rings = _rings_ahead(graph, front, untested, lies, most)
        lies[ahead] = on_surface(mesh, kind, surface, ahead, tolerance, side)
        before = len(taken)
        for _ in range(rings):
            front = _step(graph, front, lies)
            lies[front] = False
            taken.append(front)
            if not len(front):
                break
        # Where most was tested in vain, the border is near.
        fruitful = 2 * sum(map(len, taken[before:])) > len(ahead)
        most = 2 * most if fruitful else AHEAD
    return np.concatenate(taken)


def _rings_ahead(
    graph: FacetGraph, front: IntArray, untested: BoolArray, lies: BoolArray, enough: int
) -> tuple[IntArray, int]:
    """Untested facets within some steps over facets that may lie on the surface, or are known to,
    enough of them if there are, and the number of steps; they are no longer untested afterwards."""
    found: list[IntArray] = []
    count = 0
    while len(front) and count < enough and len(found) < MOST_RINGS:
        known = _step(graph, front, lies)
        front = _step(graph, front, untested)
        untested[front] = False
        found.append(front)
        count += len(front)
        front = np.concatenate([front, known])
    return np.concatenate(found), len(found)


def _step(graph: FacetGraph, front: IntArray, among: BoolArray) -> IntArray:
    """The facets next to a front, of those that are marked, each once and ascending."""
    step = graph.neighbour[front].ravel()
    return distinct(step[among[step]])
