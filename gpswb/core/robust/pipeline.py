# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mode `robust`: planes and simple surfaces by consensus of positions, the rest by slippage."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from gpswb.core.initial import InitialPartition, initial_partition
from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import BoolArray, IntArray, Mesh
from gpswb.core.partition import Partition, Region
from gpswb.core.projection import number_facet_regions
from gpswb.core.recognition import recognise
from gpswb.core.refine import refine_regions
from gpswb.core.region_samples import confined_normals, region_samples
from gpswb.core.robust.consensus import find_surfaces
from gpswb.core.robust.describe import describe_surface
from gpswb.core.robust.growth import Grown, fit_facets, grow
from gpswb.core.robust.polygons import certain_planes, coplanar_polygons
from gpswb.core.robust.surfaces import Kind
from gpswb.core.robust.topology import FacetGraph
from gpswb.core.stages import Progress, StageClock
from gpswb.core.tolerances import Tolerances

TIERS: tuple[float, ...] = (1e-7, 1e-6, 1e-5, 1e-4)
"""Distances that count as none, as shares of the diagonal, tried one after the other: analytic
surfaces hold to rounding, the edges of exchanged files only to their modelling tolerance."""

CLASS_OF: dict[Kind, InvarianceClass] = {
    "plane": "planar",
    "cylinder": "cylindrical",
    "cone": "revolute",
    "sphere": "spherical",
    "torus": "revolute",
}


def partition_robust(
    mesh: Mesh,
    sigma: float,
    tolerances: Tolerances | None = None,
    progress: Progress | None = None,
) -> Partition:
    """Partition a mesh by what its vertices lie on.

    Args:
        mesh: the mesh.
        sigma: noise of the vertices, mm; 0 for a nominal mesh.
        tolerances: thresholds of the steps shared with mode `corrected`.
        progress: listener.
    """
    tol = tolerances or Tolerances()
    clock = StageClock(progress)
    first = initial_partition(mesh, sigma, tol, clock)
    with clock.stage("refine"):
        surfaces = simple_surfaces(mesh, clock)
        label = np.full(len(mesh.triangles), -1, dtype=np.int64)
        for i, grown in enumerate(surfaces):
            label[grown.facets] = i
        label = _label_rest(mesh, first, label, len(surfaces), sigma, tol)
    with clock.stage("recognise"):
        region, count = number_facet_regions(label, mesh)
        regions = _recognise(mesh, first, region, count, label, surfaces, sigma, tol)
    return Partition(
        mesh=mesh,
        shape_type=first.facet_type,
        initial_region=first.region,
        region=region,
        regions=regions,
        vertex_shape_type=first.vertex_type,
        shape_index=first.shape_index,
        curvedness=first.curvedness,
        initial_region_count=first.count,
        sharp_edge_regions=first.sharp_edge_regions,
        sigma=sigma,
        mode="robust",
        method="hybrid",
        timings=clock.timings,
    )


def simple_surfaces(mesh: Mesh, clock: StageClock) -> list[Grown]:
    """Planes, cylinders, cones, spheres and tori with the connected facets that prove them."""
    graph = FacetGraph.of(mesh)
    fine = TIERS[0] * mesh.diagonal
    polygon = coplanar_polygons(mesh, graph, fine)
    certain = certain_planes(mesh, polygon, fine)
    whole = mesh.areas > 0.0
    free = whole & ~certain[polygon]
    found: list[Grown] = []
    for number, tier in enumerate(TIERS):
        tolerance = tier * mesh.diagonal
        found = [_regrow(mesh, graph, g, free, tolerance) for g in found]
        found += find_surfaces(mesh, graph, free, tolerance)
        clock.report("refine", (number + 1) / (len(TIERS) + 1))
    planes = []
    order = np.argsort(polygon, kind="stable")
    bounds = np.searchsorted(polygon[order], np.arange(len(certain) + 1))
    for i in np.flatnonzero(certain):
        facets = order[bounds[i] : bounds[i + 1]]
        planes.append(Grown("plane", fit_facets(mesh, "plane", facets), facets))
    return planes + found


def _regrow(
    mesh: Mesh, graph: FacetGraph, grown: Grown, free: BoolArray, tolerance: float
) -> Grown:
    """Take in the facets that a wider tolerance adds, and mark them as no longer free."""
    free[grown.facets] = True
    more = grow(mesh, graph, grown.kind, grown.surface, grown.facets, free, tolerance)
    if len(more.facets) < len(grown.facets):
        more = grown
    free[more.facets] = False
    return more


def _label_rest(
    mesh: Mesh,
    first: InitialPartition,
    label: IntArray,
    used: int,
    sigma: float,
    tolerances: Tolerances,
) -> IntArray:
    """Label what no simple surface explains: merged by slippage, apart from what is explained."""
    rest = (label < 0) & (mesh.areas > 0.0)
    if not rest.any():
        return label
    initial = np.where(rest, first.region, -1)
    refined = refine_regions(mesh, initial, first.crease, sigma, tolerances)
    out = label.copy()
    out[rest] = used + refined[rest]
    return out


def _recognise(
    mesh: Mesh,
    first: InitialPartition,
    region: IntArray,
    count: int,
    label: IntArray,
    surfaces: list[Grown],
    sigma: float,
    tolerances: Tolerances,
) -> tuple[Region, ...]:
    normals = confined_normals(mesh, region, first.crease)
    regions = []
    for r, sample in enumerate(region_samples(mesh, region, count, normals)):
        merged = len(np.unique(first.region[sample.facets]))
        number = int(label[sample.facets[0]])
        if number >= len(surfaces):
            regions.append(recognise(r, sample, merged, sigma, tolerances))
            continue
        grown = surfaces[number]
        name = CLASS_OF[grown.kind]
        found = recognise(r, sample, merged, sigma, tolerances, choose=lambda e, p, n=name: n)
        surface, situation, intrinsic, residual = describe_surface(grown, sample.vertices)
        regions.append(
            replace(
                found,
                surface=surface,
                situation=situation,
                intrinsic=intrinsic,
                residual=residual,
                undecided=(),
            )
        )
    return tuple(regions)
