# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tori and spheres that were taken for the cones between their rings of vertices."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import BoolArray, FloatArray, Mesh
from gpswb.core.robust.evidence import PROFILE
from gpswb.core.robust.growth import Grown, flood, vertices_of
from gpswb.core.robust.surfaces import Kind
from gpswb.core.robust.topology import FacetGraph

TURN = np.deg2rad(40.0)
"""Angle between two bands from which their ring is an edge: coarse exports turn by 28.6 degrees."""

NEAR = 10.0
"""Tolerances within which points of the meridian are of one ring."""

REGULAR = 1e-3
"""Share by which the chords of four rings may differ to prove a circle: any three lie on one, and
four of a symmetric profile do, but only a tessellated one has them at equal steps."""


def stacked_bands(
    mesh: Mesh, graph: FacetGraph, found: list[Grown], allowed: BoolArray, tolerance: float
) -> list[Grown]:
    """The tori and spheres that go through the rings of neighbouring coaxial cones and cylinders.

    On a coarse mesh every two rings of a torus lie on a cone exactly, and prove it.

    Args:
        mesh: the mesh.
        graph: its adjacency.
        found: regions, without common facets.
        allowed: (m,) facets that may be taken.
        tolerance: distance that counts as none, mm.

    Returns:
        New regions, which overlap those that they are made of.
    """
    owner = np.full(len(mesh.triangles), -1, dtype=np.int64)
    for i, g in enumerate(found):
        if g.kind in ("cylinder", "cone"):
            owner[g.facets] = i
    ends = owner[graph.pairs[np.abs(graph.pair_dihedral) < TURN]]
    ends = np.sort(ends[(ends >= 0).all(axis=1) & (ends[:, 0] != ends[:, 1])], axis=1)
    out: list[Grown] = []
    taken = np.zeros(len(found), dtype=bool)
    for a, b in np.unique(ends, axis=0).tolist():
        if taken[a] and taken[b]:
            continue
        both = np.concatenate([found[a].facets, found[b].facets])
        larger = a if len(found[a].facets) >= len(found[b].facets) else b
        ring = _rings(found[larger].surface, vertices_of(mesh, both), 3, NEAR * tolerance)
        circle = None if ring is None else _circle(ring)
        if circle is None:
            continue
        kind: Kind = "torus" if abs(circle[0]) > tolerance else "sphere"
        surface = found[larger].surface.copy()
        surface[:3] += circle[1] * surface[3:6]
        surface[6:8] = circle[[0, 2]] if kind == "torus" else circle[[2, 0]]
        facets = flood(mesh, graph, kind, surface, both, allowed, tolerance)
        if len(facets) > len(both) and _is_profile(surface, vertices_of(mesh, facets), tolerance):
            out.append(Grown(kind, surface, facets))
            taken[np.unique(owner[facets][owner[facets] >= 0])] = True
    return out


def _rings(surface: FloatArray, points: FloatArray, most: int, near: float) -> FloatArray | None:
    """(k, 2) places (radius, height) of the meridian about an axis at which (n, 3) points lie; None
    if there are more than so many, or fewer than three."""
    x = points - surface[:3]
    height = x @ surface[3:6]
    radius = np.linalg.norm(x - np.outer(height, surface[3:6]), axis=1)
    left = np.stack([radius, height], axis=1)
    places: list[FloatArray] = []
    while len(left):
        if len(places) == most:
            return None
        places.append(left[0])
        left = left[np.linalg.norm(left - left[0], axis=1) > near]
    return np.array(places) if len(places) >= 3 else None


def _circle(places: FloatArray) -> FloatArray | None:
    """Centre's radius (beyond the axis, negative) and height, and radius of the circle through
    (3, 2) places of the meridian; None if they lie on a line."""
    chords = places[1:] - places[0]
    if abs(np.linalg.det(chords)) < 1e-6 * float(np.prod(np.linalg.norm(chords, axis=1))):
        return None
    centre = np.linalg.solve(chords, 0.5 * np.einsum("ij,ij->i", chords, chords))
    return np.append(places[0] + centre, np.linalg.norm(centre))


def _is_profile(surface: FloatArray, points: FloatArray, tolerance: float) -> bool:
    """Whether the rings at which (n, 3) points lie are too many, or too regular, for chance."""
    ring = _rings(surface, points, PROFILE, NEAR * tolerance)
    if ring is None or len(ring) >= PROFILE:
        return True
    if len(ring) < 4:
        return False
    # From one end of the profile to the other: no place is farther from the middle than an end.
    end = ring[np.argmax(np.linalg.norm(ring - ring.mean(axis=0), axis=1))]
    order = np.argsort(np.linalg.norm(ring - end, axis=1))
    chord = np.linalg.norm(np.diff(ring[order], axis=0), axis=1)
    return bool(np.ptp(chord) < REGULAR * chord.max())
