# SPDX-License-Identifier: LGPL-2.1-or-later
"""Third step: recognition of the refined regions, and the result put together (paper, 5.4)."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from gpswb.core.initial import InitialPartition
from gpswb.core.mesh import IntArray, Mesh
from gpswb.core.partition import Partition, Region
from gpswb.core.projection import number_facet_regions
from gpswb.core.recognition import Choice, by_parsimony, recognise
from gpswb.core.region_samples import RegionSample, confined_normals, region_samples
from gpswb.core.stages import StageClock
from gpswb.core.tolerances import Tolerances


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
    """Recognise the refined regions and gather the result.

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
