# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facets along tangent borders, given back to the surface that they lie on (design, section 5)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from gpswb.core.core_facets import core_facets
from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.quotient import quotient_coordinates
from gpswb.core.recognition import weigh
from gpswb.core.reference import Reference
from gpswb.core.region_samples import confined_normals, region_samples
from gpswb.core.tolerances import Tolerances

_SWEEPS = 10  # a border leaks by a row or two; ten rows are more than it ever takes

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
            ray = np.cross(ray, self.reference.direction)
        rho: FloatArray = np.linalg.norm(ray, axis=1)
        away: FloatArray = np.abs(rho - self.radius)
        return away


def give_back(
    mesh: Mesh, region: IntArray, crease: BoolArray, sigma: float, tolerances: Tolerances
) -> IntArray:
    """Move facets across smooth borders to the plane, sphere or cylinder that all their corners lie
    on.

    Where two surfaces touch, normals at the border mix both, so the first row of the flatter one is
    labelled with the rounder. A facet moves when its corners lie on the neighbour's surface and not
    on its own region's.

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
    if not surfaces:
        return region
    pairs = mesh.facet_pairs[~crease]
    pairs = np.concatenate([pairs, pairs[:, ::-1]])
    for _ in range(_SWEEPS):
        here, there = region[pairs].T
        across = pairs[(here != there) & (here >= 0) & (there >= 0)]
        if not len(across):
            break
        facet, target = across[:, 0], region[across[:, 1]]
        moved = _lies_on(mesh, facet, target, surfaces) & ~_lies_on(
            mesh, facet, region[facet], surfaces
        )
        if not moved.any():
            break
        region[facet[moved]] = target[moved]
    return region


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
        away = surface.distance(mesh.corners[facet[chosen]].reshape(-1, 3)).reshape(-1, 3)
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
        evidence = weigh(sample, sigma, tolerances, _EXPLICIT)
        name = next((n for n in _EXPLICIT if evidence.fits(n)), None)
        if name is None:
            continue
        reference = evidence.references[name]
        radius = float(quotient_coordinates(sample.vertices, name, reference).mean())
        found[number] = _Surface(name, reference, radius, 2.0 * evidence.distance[name])
    return found
