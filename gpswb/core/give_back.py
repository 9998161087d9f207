# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facets along tangent borders, given back to the surface that they lie on (design, section 5)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from gpswb.core.core_facets import core_facets
from gpswb.core.facet_edges import edge_lengths
from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.quotient import quotient_coordinates
from gpswb.core.reference import Reference, estimate_references, spread
from gpswb.core.region_samples import RegionSample, confined_normals, region_samples
from gpswb.core.tolerances import Tolerances

_SWEEPS = 10  # a border leaks by a row or two; ten rows are more than it ever takes
_TRIMS = 4  # rounds of refitting without the quarter of the area that stands off most
_KEPT = 0.75
_MOST = 0.8  # share of a region's area that must lie on a surface to speak for the region

_SAMPLES = 1000  # corners that a surface is fitted to

_EXPLICIT: tuple[InvarianceClass, ...] = ("planar", "spherical", "cylindrical")


@dataclass(frozen=True, eq=False)
class _Surface:
    """A plane, sphere or cylinder: its class, situation, radius and how near counts as on it."""

    name: InvarianceClass
    reference: Reference
    radius: float
    tolerance: float

    def distance(self, points: FloatArray) -> FloatArray:
        """(n,) distance of points (n, 3), mm."""
        ray = points - self.reference.point
        if self.name == "planar":
            return np.asarray(np.abs(ray @ self.reference.direction), dtype=np.float64)
        if self.name == "cylindrical":
            ray = np.asarray(np.cross(ray, self.reference.direction), dtype=np.float64)
        rho = np.linalg.norm(ray, axis=1)
        return np.asarray(np.abs(rho - self.radius), dtype=np.float64)


def give_back(
    mesh: Mesh, region: IntArray, crease: BoolArray, sigma: float, tolerances: Tolerances
) -> IntArray:
    """Move facets across smooth borders to the surface that they lie on.

    Where two surfaces touch, normals at the border mix both, so the first row of the flatter one is
    labelled with the rounder. Regions that lie on a plane, sphere or cylinder for the most part get
    that surface. A facet whose corners are off its own region's surface, or whose region has none,
    moves to a neighbour whose surface it lies on; off its own surface, also to a neighbour without.
    Regions of a few facets then go to the large neighbour they share most border with, unless it
    has a surface that they are off: leftovers of a tangent border have no shape of their own.

    Args:
        mesh: the mesh.
        region: (m,) int; -1 for degenerate facets.
        crease: (e,) bool feature edges.
        sigma: noise of the vertices, mm.
        tolerances: thresholds.

    Returns:
        (m,) int64 the regions, moved.
    """
    region = region.copy()
    surfaces = _surfaces(mesh, region, crease, sigma, tolerances)
    known = np.zeros(int(region.max(initial=-1)) + 1, dtype=bool)
    known[list(surfaces)] = True
    pairs = mesh.facet_pairs[~crease]
    pairs = np.concatenate([pairs, pairs[:, ::-1]])
    for _ in range(_SWEEPS):
        here, there = region[pairs].T
        across = pairs[(here != there) & (here >= 0) & (there >= 0)]
        if not len(across):
            break
        facet, own, target = across[:, 0], region[across[:, 0]], region[across[:, 1]]
        off = ~_lies_on(mesh, facet, own, surfaces)
        on = _lies_on(mesh, facet, target, surfaces)
        moved = off & (on | (known[own] & ~known[target]))
        if not moved.any():
            break
        # A neighbour whose surface fits comes last and so stays.
        order = np.argsort(on[moved], kind="stable")
        region[facet[moved][order]] = target[moved][order]
    return _absorb(mesh, region, crease, surfaces, tolerances)


def _absorb(
    mesh: Mesh,
    region: IntArray,
    crease: BoolArray,
    surfaces: Mapping[int, _Surface],
    tolerances: Tolerances,
) -> IntArray:
    """Give regions of fewer facets than a confident one has to a confident smooth neighbour."""
    inside = region >= 0
    count = int(region.max(initial=-1)) + 1
    size = np.bincount(region[inside], minlength=count)
    length = np.tile(edge_lengths(mesh, np.flatnonzero(~crease)), 2)
    pairs = mesh.facet_pairs[~crease]
    pairs = np.concatenate([pairs, pairs[:, ::-1]])
    own, other = region[pairs].T
    few = tolerances.confident_facets
    border = (own != other) & (own >= 0) & (other >= 0)
    border[border] &= (size[own[border]] < few) & (size[other[border]] >= few)
    if not border.any():
        return region
    facet, own, other = pairs[border, 0], own[border], other[border]
    explicit = np.isin(other, np.array(list(surfaces), dtype=np.int64))
    fits = ~explicit | _lies_on(mesh, facet, other, surfaces)
    key, inverse = np.unique(own * count + other, return_inverse=True)
    shared = np.bincount(inverse.ravel(), weights=length[border])
    agrees = np.bincount(inverse.ravel(), weights=~fits) == 0
    target = np.arange(count)
    order = np.argsort(shared[agrees], kind="stable")
    chosen = key[agrees][order]
    target[chosen // count] = chosen % count
    return np.where(inside, target[region], -1)


def _lies_on(
    mesh: Mesh, facet: IntArray, label: IntArray, surfaces: Mapping[int, _Surface]
) -> BoolArray:
    """Whether each facet's corners all lie on the surface of the region with that label."""
    result = np.zeros(len(facet), dtype=bool)
    for number in np.unique(label).tolist():
        surface = surfaces.get(number)
        if surface is None:
            continue
        chosen = label == number
        away = surface.distance(mesh.corners_of(facet[chosen]).reshape(-1, 3)).reshape(-1, 3)
        result[chosen] = away.max(axis=1) <= surface.tolerance
    return result


def _surfaces(
    mesh: Mesh, region: IntArray, crease: BoolArray, sigma: float, tolerances: Tolerances
) -> dict[int, _Surface]:
    """Surfaces of the regions that are large enough to have one, from their inner facets."""
    core = np.where(core_facets(mesh, region, crease), region, -1)
    count = int(region.max(initial=-1)) + 1
    normals = confined_normals(mesh, region, crease)
    found: dict[int, _Surface] = {}
    for number, sample in enumerate(region_samples(mesh, core, count, normals)):
        if len(sample.facets) < tolerances.confident_facets:
            continue
        tolerance = max(3.0 * sigma, 2.0 * tolerances.distance * sample.size)
        for name in _EXPLICIT:
            surface = _trimmed_fit(sample, name, tolerance)
            if surface is not None:
                found[number] = surface
                break
    return found


def _trimmed_fit(sample: RegionSample, name: InvarianceClass, tolerance: float) -> _Surface | None:
    """The surface of a class that most of a region's area lies on, if there is one."""
    chosen = spread(len(sample.points), _SAMPLES)
    points, normals = sample.points[chosen], sample.normals[chosen]
    weights = sample.weights[chosen]
    kept = np.ones(len(points), dtype=bool)
    for _ in range(_TRIMS):
        reference = estimate_references(points[kept], normals[kept], weights[kept], (name,))[name]
        coordinate = quotient_coordinates(points, name, reference)[:, 0]
        radius = float(np.average(coordinate[kept], weights=weights[kept]))
        surface = _Surface(name, reference, radius, tolerance)
        away = surface.distance(points)
        near = float(weights[away <= tolerance].sum() / weights.sum())
        if near >= _MOST:
            return surface
        order = np.argsort(away)
        share = np.cumsum(weights[order]) / weights.sum()
        kept = np.zeros(len(points), dtype=bool)
        kept[order[: max(12, int(np.searchsorted(share, _KEPT)))]] = True
    return None
