# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mode `corrected`: the paper's flow with its errors mended."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from gpswb.core.initial import InitialPartition, initial_partition
from gpswb.core.mesh import IntArray, Mesh
from gpswb.core.partition import Partition, Region
from gpswb.core.projection import number_facet_regions
from gpswb.core.recognition import Choice, by_parsimony, recognise
from gpswb.core.refine import refine_regions
from gpswb.core.region_samples import RegionSample, confined_normals, region_samples
from gpswb.core.stages import Progress, StageClock
from gpswb.core.tolerances import Tolerances


def partition_corrected(
    mesh: Mesh,
    sigma: float,
    tolerances: Tolerances | None = None,
    progress: Progress | None = None,
) -> Partition:
    """Partition by the paper's three steps, mended.

    What differs from the print, and why:

    * facets are labelled, not vertices: a mesh as exported has no vertex inside a face;
    * curvature stops at creases, and sharp edges are found by dihedral angle against the smooth
      turning beside them: c_max comes from the shortest edge, so (6)-(7) miss the others;
    * a facet is plane by its sagitta, a length over a length: p_c = 1e-5 carries a unit;
    * votes are swept in place and capped: synchronous updates oscillate;
    * slippage solves M x = mu V x, free of unit, origin and pose, where (2)-(3) are not;
    * signatures are compared in one frame, the metric of the union;
    * no confident region loses a motion, and a union must lie on one surface: merging down to
      k = 1 as printed swallows tangent chains;
    * facets that a tangent border took along are given back to the surface they lie on;
    * the likelihoods carry the right Jacobians, and the class is decided by parsimony among the
      classes that fit, since nested classes tie.

    Args:
        mesh: the mesh.
        sigma: noise of the vertices, mm; 0 for a nominal mesh.
        tolerances: thresholds; the defaults if not given.
        progress: listener.
    """
    tol = tolerances or Tolerances()
    clock = StageClock(progress)
    first = initial_partition(mesh, sigma, tol, clock)
    with clock.stage("refine"):
        refined = refine_regions(mesh, first.region, first.crease, sigma, tol)
    return recognised_partition(mesh, first, refined, sigma, tol, clock, "corrected", "hybrid")


def recognised_partition(
    mesh: Mesh,
    first: InitialPartition,
    refined: IntArray,
    sigma: float,
    tolerances: Tolerances,
    clock: StageClock,
    mode: str,
    method: str,
    choose: Callable[[RegionSample], Choice] = lambda _: by_parsimony,
) -> Partition:
    """Third step: recognise the refined regions and gather the result.

    Args:
        mesh: the mesh.
        first: the first step's result.
        refined: (m,) int refined region of each facet, -1 for none.
        sigma: noise of the vertices, mm.
        tolerances: thresholds.
        clock: takes the time of the stage `recognise`, and gives those of all.
        mode, method: as they stand in the result.
        choose: gives what decides the class of a region.
    """
    with clock.stage("recognise"):
        region, count = number_facet_regions(refined, mesh)
        regions: list[Region] = []
        normals = confined_normals(mesh, region, first.crease)
        for r, sample in enumerate(region_samples(mesh, region, count, normals)):
            merged = len(np.unique(first.region[sample.facets]))
            regions.append(recognise(r, sample, merged, sigma, tolerances, choose=choose(sample)))
            clock.report("recognise", (r + 1) / count)
    return Partition(
        mesh=mesh,
        shape_type=first.facet_type,
        initial_region=first.region,
        region=region,
        regions=tuple(regions),
        vertex_shape_type=first.vertex_type,
        shape_index=first.shape_index,
        curvedness=first.curvedness,
        initial_region_count=first.count,
        sharp_edge_regions=first.sharp_edge_regions,
        sigma=sigma,
        mode=mode,
        method=method,
        timings=clock.timings,
    )
