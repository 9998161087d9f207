# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mode `robust` under noise."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from gpswb.core.initial import initial_partition
from gpswb.core.mesh import Mesh
from gpswb.core.noisy.noisy_mesh import NoisyMesh
from gpswb.core.noisy.segmentation import segment
from gpswb.core.partition import Partition
from gpswb.core.projection import number_facet_regions
from gpswb.core.recognition import always, recognise
from gpswb.core.region_samples import confined_normals, region_samples
from gpswb.core.robust.describe import describe_surface
from gpswb.core.robust.growth import Grown
from gpswb.core.robust.surfaces import Kind
from gpswb.core.stages import Progress, StageClock
from gpswb.core.tolerances import Tolerances

CLASS_OF = {
    "plane": "planar",
    "cylinder": "cylindrical",
    "cone": "revolute",
    "sphere": "spherical",
    "torus": "revolute",
}


def partition_noisy(
    mesh: Mesh,
    sigma: float,
    tolerances: Tolerances | None = None,
    progress: Progress | None = None,
) -> Partition:
    tol = tolerances or Tolerances()
    clock = StageClock(progress)
    first = initial_partition(mesh, sigma, tol, clock)
    with clock.stage("refine"):
        noisy = NoisyMesh.of(mesh, sigma)
        graph = noisy.graph
        models, label = segment(noisy)
        rest = (label == -1)
        joined = rest[graph.pairs].all(axis=1)
        part = graph.components(joined, len(label))
        label = np.where(rest, len(models) + part, label)
    with clock.stage("recognise"):
        region, count = number_facet_regions(np.where(mesh.areas > 0, label, -1), mesh)
        corner = confined_normals(mesh, region, first.crease)
        regions = []
        for r, sample in enumerate(region_samples(mesh, region, count, corner)):
            merged = len(np.unique(first.region[sample.facets]))
            number = int(label[sample.facets[0]])
            if number >= len(models):
                regions.append(recognise(r, sample, merged, sigma, tol))
                continue
            m = models[number]
            found = recognise(r, sample, merged, sigma, tol, choose=always(CLASS_OF[m.kind]))
            kind, situation, intrinsic, residual = describe_surface(
                Grown(m.kind, m.surface, sample.facets), sample.vertices
            )
            regions.append(replace(found, surface=kind, situation=situation, intrinsic=intrinsic, residual=residual))
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
        mode="robust",
        method="hybrid",
        timings=clock.timings,
    )
