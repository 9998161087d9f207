# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a torus is one face, or a chance fit to two that meet at a ring of vertices."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import FloatArray, IntArray, Mesh
from gpswb.core.robust.angles import ends_of, gaps_of
from gpswb.core.robust.growth import Grown
from gpswb.core.robust.rim import inner_vertices
from gpswb.core.robust.topology import FacetGraph

PROFILE = 5
"""Different places on the tube that prove a torus: any three rings of vertices lie on one torus,
and four of a symmetric profile do. Three do where none is an edge (see ``is_one_profile``)."""

BULGE = 1e-3
"""Share of the chord from the first ring of a profile to the last by which those between must leave
it, and sine of the angle between two chords of three rings, from which they are no line: vertices
of a cone or cylinder that are off it by modelling tolerance leave it by less."""


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
    new = ends_of(angle[order])
    # The largest gap is where the tube is open.
    first = (int(np.argmax(gaps_of(angle[order]))) + 1) % len(order)
    place = np.empty(len(order), dtype=np.int64)
    place[np.roll(order, -first)] = np.r_[0, np.cumsum(np.roll(new, -first)[:-1])]
    return place
