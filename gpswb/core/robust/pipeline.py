# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mode `robust`: planes and simple surfaces by consensus of positions, the rest by slippage."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from gpswb.core.initial import InitialPartition, initial_partition
from gpswb.core.invariance import InvarianceClass
from gpswb.core.known_surface import known_region
from gpswb.core.mesh import BoolArray, IntArray, Mesh
from gpswb.core.noisy.segmentation import segment
from gpswb.core.partition import Partition, Region
from gpswb.core.projection import number_facet_regions
from gpswb.core.recognition import always, recognise
from gpswb.core.region_samples import confined_normals, region_samples
from gpswb.core.robust.absorb import absorb_pieces
from gpswb.core.robust.decide import by_gap, unless_far_better
from gpswb.core.robust.describe import describe_surface
from gpswb.core.robust.enclosed import take_enclosed
from gpswb.core.robust.evidence import CHANCE, EXACT, INSIDE, sagitta
from gpswb.core.robust.growth import Grown, fit_facets, regions_of, stand_off, vertices_of
from gpswb.core.robust.jump_memory import JumpMemory
from gpswb.core.robust.leftover import label_leftover
from gpswb.core.robust.one_face import join_faces
from gpswb.core.robust.polygons import certain_planes, coplanar_polygons
from gpswb.core.robust.rejoin import rejoin
from gpswb.core.robust.simple_surfaces import TIERS, simple_surfaces
from gpswb.core.robust.surfaces import Kind
from gpswb.core.robust.topology import FacetGraph
from gpswb.core.stages import Progress, StageClock
from gpswb.core.tolerances import Tolerances

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
        sigma: noise of the vertices, mm; 0 for a nominal mesh. Where it exceeds what vertices
            inside a face may be off, statistical tests take the place of tolerances.
        tolerances: thresholds of the steps shared with mode `corrected`.
        progress: listener.
    """
    tol = tolerances or Tolerances()
    if sigma == 0.0:
        # Nominal vertices need no allowance for form: a class they don't fit is the wrong one.
        tol = replace(tol, form=tol.distance)
    clock = StageClock(progress)
    first = initial_partition(mesh, sigma, tol, clock)
    with clock.stage("refine"):
        if 3.0 * sigma > INSIDE * mesh.diagonal:
            # No vertex lies on anything to within the tolerance of approximated surfaces.
            surfaces, label, names = segment(mesh, sigma)
            flat = np.zeros(len(label), dtype=bool)
        else:
            surfaces, label, flat = _nominal_regions(mesh, first, sigma, tol, clock)
            names = {}
    with clock.stage("recognise"):
        region, count = number_facet_regions(label, mesh)
        regions = _recognise(mesh, first, region, count, label, flat, surfaces, names, sigma, tol)
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


def _nominal_regions(
    mesh: Mesh, first: InitialPartition, sigma: float, tolerances: Tolerances, clock: StageClock
) -> tuple[list[Grown], IntArray, BoolArray]:
    """Surfaces, (m,) labels that begin with their numbers, (m,) facets that are planes besides."""
    graph = FacetGraph.of(mesh)
    polygon = coplanar_polygons(mesh, graph, TIERS[0] * mesh.diagonal)
    certain = certain_planes(mesh, graph, polygon, TIERS[0] * mesh.diagonal)
    jumps = JumpMemory(mesh, graph)
    surfaces = simple_surfaces(mesh, graph, polygon, certain, first.region, jumps, clock)
    label = np.full(len(mesh.triangles), -1, dtype=np.int64)
    for i, grown in enumerate(surfaces):
        label[grown.facets] = i
    label, flat = label_leftover(mesh, graph, first, polygon, label, jumps, sigma, tolerances)
    alone = label
    label = take_enclosed(mesh, graph, label, tolerances.confident_facets)
    sure = certain[polygon] & (label == alone)
    label = absorb_pieces(mesh, graph, first, label, surfaces, sure, sigma, tolerances)
    surfaces, label = _rejoined(mesh, graph, surfaces, label)
    known = {i: CLASS_OF[g.kind] for i, g in enumerate(surfaces) if _is_settled(mesh, g)}
    label = join_faces(mesh, graph, first, label, known, sure | flat, sigma, tolerances)
    # What a region has taken in is no longer a plane.
    return surfaces, label, flat & (label == alone)


def _rejoined(
    mesh: Mesh, graph: FacetGraph, surfaces: list[Grown], label: IntArray
) -> tuple[list[Grown], IntArray]:
    """Surfaces and labels after pieces were taken in that lay between those of one surface."""
    found = rejoin(mesh, graph, regions_of(label, surfaces), TIERS[0] * mesh.diagonal)
    # The other labels are above those of the surfaces, and these have become no more.
    out = label.copy()
    for i, g in enumerate(found):
        out[g.facets] = i
    return found, out


def _is_settled(mesh: Mesh, grown: Grown) -> bool:
    """Whether the kind of a region's surface is beyond doubt: a narrow band of anything lies nearly
    on a torus or cone, but hardly on a cylinder."""
    if grown.kind == "plane":
        return True
    off = stand_off(grown, vertices_of(mesh, grown.facets))
    return sagitta(mesh, grown) >= (CHANCE if grown.kind == "cylinder" else EXACT) * off


def _recognise(
    mesh: Mesh,
    first: InitialPartition,
    region: IntArray,
    count: int,
    label: IntArray,
    flat: BoolArray,
    surfaces: list[Grown],
    names: Mapping[int, InvarianceClass],
    sigma: float,
    tolerances: Tolerances,
) -> tuple[Region, ...]:
    normals = confined_normals(mesh, region, first.crease)
    regions = []
    for r, sample in enumerate(region_samples(mesh, region, count, normals)):
        merged = len(np.unique(first.region[sample.facets]))
        number = int(label[sample.facets[0]])
        if number < len(surfaces):
            grown = surfaces[number]
        elif flat[sample.facets[0]]:
            grown = Grown("plane", fit_facets(mesh, "plane", sample.facets), sample.facets)
        else:
            choose = always(names[number]) if number in names else by_gap
            regions.append(recognise(r, sample, merged, sigma, tolerances, choose=choose))
            continue
        name = CLASS_OF[grown.kind]
        off = stand_off(grown, sample.vertices)
        if sigma == 0.0 and not _is_settled(mesh, grown):
            choose = unless_far_better(name, off, sample.vertices)
            found = recognise(r, sample, merged, sigma, tolerances, choose=choose)
            if found.invariance_class != name:
                regions.append(found)
                continue
        surface, situation, intrinsic, rms = describe_surface(grown, sample.vertices)
        description = (surface, situation, intrinsic)
        regions.append(known_region(r, sample, merged, name, description, rms, sigma, tolerances))
    return tuple(regions)
