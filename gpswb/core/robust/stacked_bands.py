# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tori and spheres that were taken for the cones between their rings of vertices."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.robust.growth import Grown, flood, vertices_of
from gpswb.core.robust.one_profile import BULGE, PROFILE, is_one_profile
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

    On a coarse mesh every two rings of a torus lie on a cone exactly, and prove it. Where a few of
    its vertices are between its two borders, most of its facets lie on that cone still.

    Args:
        mesh: the mesh.
        graph: its adjacency.
        found: regions, without common facets.
        allowed: (m,) facets that may be taken.
        tolerance: distance that counts as none, mm.

    Returns:
        New regions, which overlap those that they are made of.
    """
    out: list[Grown] = []
    covered = np.zeros(len(mesh.triangles), dtype=bool)
    for h in _hypotheses(mesh, graph, found, allowed, tolerance):
        if covered[h.facets].all():
            continue
        facets = flood(mesh, graph, h.kind, h.surface, h.facets, allowed, tolerance)
        grown = Grown(h.kind, h.surface, facets)
        if len(facets) > len(h.facets) and _is_profile(mesh, graph, grown, tolerance):
            out.append(grown)
            covered[facets] = True
    return out


def _hypotheses(
    mesh: Mesh, graph: FacetGraph, found: list[Grown], allowed: BoolArray, tolerance: float
) -> Iterator[Grown]:
    """Tori and spheres through two bands, through a band and a facet beside it that is in no region
    and reaches to a third place, and those beside a band; with the facets that say so."""
    owner = np.full(len(mesh.triangles), -1, dtype=np.int64)
    for i, g in enumerate(found):
        owner[g.facets] = i
    band = np.array([g.kind in ("cylinder", "cone") for g in found] + [False])
    border = owner[graph.pairs[:, 0]] != owner[graph.pairs[:, 1]]
    pairs = graph.pairs[border & (graph.pair_dihedral < TURN)]
    pairs = np.concatenate([pairs, pairs[:, ::-1]])
    round_ = np.array([g.kind in ("sphere", "torus") for g in found] + [False])
    first, second = owner[pairs.T]
    beside = band[first]
    both = np.stack([first, second], axis=1)[beside & band[second]]
    for a, b in np.unique(np.sort(both, axis=1), axis=0).tolist():
        larger, smaller = sorted((found[a], found[b]), key=lambda g: -len(g.facets))
        yield from _through(mesh, larger, smaller.facets, tolerance)
    for i in np.unique(second[beside & round_[second]]).tolist():
        yield found[i]
    free = beside & (second < 0) & allowed[pairs[:, 1]]
    for i in np.unique(first[free]).tolist():
        points = vertices_of(mesh, found[i].facets)
        if _rings(found[i].surface, points, 2, NEAR * tolerance) is None:
            continue
        for facet in np.unique(pairs[free & (first == i), 1]):
            yield from _through(mesh, found[i], np.array([facet]), tolerance)


def _through(mesh: Mesh, band: Grown, other: IntArray, tolerance: float) -> Iterator[Grown]:
    """The torus or sphere about a band's axis, through it and other facets, if they have three
    rings of vertices that aren't on one cone."""
    both = np.concatenate([band.facets, other])
    ring = _rings(band.surface, vertices_of(mesh, both), 3, NEAR * tolerance)
    circle = None if ring is None else _circle(ring)
    if circle is None:
        return
    surface = band.surface.copy()
    surface[:3] += circle[1] * surface[3:6]
    torus = abs(circle[0]) > tolerance
    surface[6:8] = circle[[0, 2]] if torus else circle[[2, 0]]
    yield Grown("torus" if torus else "sphere", surface, both)


def _rings(surface: FloatArray, points: FloatArray, most: int, near: float) -> FloatArray | None:
    """(k, 2) places (radius, height) of the meridian about an axis at which (n, 3) points lie; None
    if there are more than so many, or fewer than two."""
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
    return np.array(places) if len(places) >= 2 else None


def _circle(places: FloatArray) -> FloatArray | None:
    """Centre's radius (beyond the axis, negative) and height, and radius of the circle through
    (3, 2) places of the meridian; None if they are fewer or hardly leave a line."""
    if len(places) < 3:
        return None
    chords = places[1:] - places[0]
    if abs(np.linalg.det(chords)) < BULGE * float(np.prod(np.linalg.norm(chords, axis=1))):
        return None
    centre = np.linalg.solve(chords, 0.5 * np.einsum("ij,ij->i", chords, chords))
    return np.append(places[0] + centre, np.linalg.norm(centre))


def _is_profile(mesh: Mesh, graph: FacetGraph, grown: Grown, tolerance: float) -> bool:
    """Whether the rings at which a region's vertices lie are too many, or too regular, for chance,
    or none of them is an edge."""
    if grown.kind == "torus" and is_one_profile(mesh, graph, grown):
        return True
    points = vertices_of(mesh, grown.facets)
    ring = _rings(grown.surface, points, PROFILE, NEAR * tolerance)
    if ring is None or len(ring) >= PROFILE:
        return True
    if len(ring) < 4:
        return False
    # From one end of the profile to the other: no place is farther from the middle than an end.
    end = ring[np.argmax(np.linalg.norm(ring - ring.mean(axis=0), axis=1))]
    order = np.argsort(np.linalg.norm(ring - end, axis=1))
    chord = np.linalg.norm(np.diff(ring[order], axis=0), axis=1)
    return bool(np.ptp(chord) < REGULAR * chord.max())
