# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mode `paper`: the hybrid process as printed, on vertices, so that its behaviour can be
studied."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from gpswb.core.curvature import curvedness, shape_index
from gpswb.core.discrete_curvature import discrete_curvatures
from gpswb.core.growing import grow_regions
from gpswb.core.invariance import InvarianceClass
from gpswb.core.merging import merge_regions
from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.normals import wedge_normals
from gpswb.core.partition import Partition, Region
from gpswb.core.printed_rule import PrintedRule, printed_motion_matrices
from gpswb.core.projection import facets_from_vertices, fill_facets, number_facet_regions
from gpswb.core.recognition import Evidence, recognise
from gpswb.core.region_samples import confined_normals, region_samples
from gpswb.core.shape_types import SHARP_EDGE, plane_by_curvedness, shape_types
from gpswb.core.sharp_edges import sharp_vertices_by_curvedness
from gpswb.core.stages import Progress, StageClock
from gpswb.core.tolerances import PaperSettings, Tolerances
from gpswb.core.voting import vote
from gpswb.core.wedges import find_wedges

RANKED: tuple[InvarianceClass, ...] = (
    "planar",
    "cylindrical",
    "spherical",
    "revolute",
    "prismatic",
    "complex",
)
"""The classes ranked by likelihood: the paper leaves helical out of its rankings (section 6.1)."""


def by_likelihood(
    evidence: Evidence, likelihoods: Mapping[InvarianceClass, float]
) -> InvarianceClass:
    """The class with the largest likelihood (paper, 5.4)."""
    return max(RANKED, key=lambda name: likelihoods[name])


def partition_as_printed(
    mesh: Mesh,
    sigma: float,
    settings: PaperSettings | None = None,
    progress: Progress | None = None,
) -> Partition:
    """Partition as printed.

    Vertices are labelled: curvature by discretised operators, sharp edges by equations (6)-(7),
    shape types by equation (8) with p_c in 1/mm, synchronous voting (9)-(11) with a cap, growing
    along mesh edges, merging by equations (1)-(3) and (12)-(13) for k = 3, 2, 1, and the class with
    the largest printed likelihood. Facets then take the label of most of their vertices; vertices
    on sharp edges give way.

    Args:
        mesh: the mesh, mm: the result depends on the unit and on the origin, as the print does.
        sigma: noise of the vertices, mm; it only enters the reported residuals.
        settings: constants; the defaults if not given.
        progress: listener.
    """
    settings = settings or PaperSettings()
    clock = StageClock(progress)
    with clock.stage("curvature"):
        wedges = find_wedges(mesh)
        normals = wedge_normals(mesh, wedges)
        k_max, k_min = discrete_curvatures(mesh, normals)
        index, curved = shape_index(k_max, k_min), curvedness(k_max, k_min)
    with clock.stage("initial"):
        used = np.bincount(mesh.triangles.ravel(), minlength=len(mesh.vertices)) > 0
        pairs = _vertex_pairs(mesh)
        sharp: BoolArray = np.zeros(len(mesh.vertices), dtype=bool)
        sharp[used] = sharp_vertices_by_curvedness(curved[used], settings.edge_coefficient)
        plane = plane_by_curvedness(curved, settings.plane_curvedness)
        types = np.where(sharp, SHARP_EDGE, shape_types(index, plane))
        types, _ = vote(types, pairs, in_place=False, max_sweeps=settings.vote_sweeps)
        grown, count = grow_regions(types, pairs)
        sharp_regions = len(np.unique(grown[sharp & used]))
        initial_count = len(np.unique(grown[used])) - sharp_regions
    with clock.stage("refine"):
        label = np.where(sharp | ~used, -1, grown)
        merged = _merge(mesh, normals, label, count, pairs, settings)
        initial = _on_facets(mesh, grown, sharp)
        region, region_count = number_facet_regions(_on_facets(mesh, merged[grown], sharp), mesh)
    with clock.stage("recognise"):
        regions = _recognise(mesh, region, region_count, initial, sigma, clock)
    return Partition(
        mesh=mesh,
        shape_type=facets_from_vertices(types, mesh.triangles, sharp),
        initial_region=number_facet_regions(initial, mesh)[0],
        region=region,
        regions=regions,
        vertex_shape_type=types,
        shape_index=index,
        curvedness=curved,
        initial_region_count=initial_count,
        sharp_edge_regions=sharp_regions,
        sigma=sigma,
        mode="paper",
        method="hybrid",
        timings=clock.timings,
    )


def _vertex_pairs(mesh: Mesh) -> IntArray:
    """(e, 2) all edges of the mesh, borders too."""
    ends = np.sort(mesh.triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    key = np.unique(ends[:, 0] * np.int64(max(len(mesh.vertices), 1)) + ends[:, 1])
    pairs = np.column_stack(np.divmod(key, max(len(mesh.vertices), 1)))
    proper: IntArray = pairs[pairs[:, 0] != pairs[:, 1]]
    return proper


def _merge(
    mesh: Mesh,
    normals: FloatArray,
    label: IntArray,
    count: int,
    pairs: IntArray,
    settings: PaperSettings,
) -> IntArray:
    """(count,) region that each initial region ends in, after k = 3, 2, 1."""
    result = np.arange(count, dtype=np.int64)
    for k in (3, 2, 1):
        current = np.where(label >= 0, result[label], -1)
        ends = current[pairs]
        ends = ends[(ends >= 0).all(axis=1) & (ends[:, 0] != ends[:, 1])]
        motion = printed_motion_matrices(mesh.vertices, normals, current, count)
        size = np.bincount(current[current >= 0], minlength=count)
        rule = PrintedRule(motion, size, k, settings)
        result = merge_regions(count, ends, rule, settings.similarity)[result]
    return result


def _on_facets(mesh: Mesh, label: IntArray, sharp: BoolArray) -> IntArray:
    """Facet labels; facets with sharp vertices only take a neighbour's."""
    facet = facets_from_vertices(label, mesh.triangles, sharp)
    hidden = sharp[mesh.triangles].all(axis=1)
    return fill_facets(np.where(hidden, -1, facet), mesh)


def _recognise(
    mesh: Mesh, region: IntArray, count: int, initial: IntArray, sigma: float, clock: StageClock
) -> tuple[Region, ...]:
    """Regions of the class with the largest printed likelihood."""
    tolerances = Tolerances()
    crease = np.zeros(len(mesh.facet_pairs), dtype=bool)
    corner_normals = confined_normals(mesh, region, crease)
    regions = []
    for r, sample in enumerate(region_samples(mesh, region, count, corner_normals)):
        merged = len(np.unique(initial[sample.facets]))
        found = recognise(
            r, sample, merged, sigma, tolerances, choose=by_likelihood, densities="printed"
        )
        regions.append(found)
        clock.report("recognise", (r + 1) / count)
    return tuple(regions)
