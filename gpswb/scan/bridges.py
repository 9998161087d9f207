# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facets that bridge the edges of a part, in a mesh that was laid through a cloud."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from gpswb.core.partition import Partition
from gpswb.core.projection import facets_from_vertices
from gpswb.scan.point_regions import region_of_points


def without_bridges(partition: Partition) -> Partition:
    """The partition without regions that no point belongs to.

    No measured point lies on an edge of the part, and so a strip of facets runs from the last
    points of one surface to the first of the next. They lie on neither, and end in small regions
    of their own. Points decide: the facets of a region that is no point's main one
    (`region_of_points`) go to the region of most of their corners. The points keep their regions,
    in ``vertex_region``: the facets that came cannot outvote them.
    """
    n = len(partition.mesh.vertices)
    of_vertex = region_of_points(partition, np.arange(n))
    own = np.bincount(of_vertex[of_vertex >= 0], minlength=len(partition.regions)) > 0
    if own.all() or not own.any():
        return partition
    loose = ~np.r_[own, True][partition.region]
    by_corners = facets_from_vertices(of_vertex, partition.mesh.triangles, of_vertex < 0)
    number = np.r_[np.where(own, np.cumsum(own) - 1, -1), -1]
    region = number[np.where(loose, by_corners, partition.region)]
    inside = region >= 0
    count = int(own.sum())
    area = np.bincount(region[inside], partition.mesh.areas[inside], minlength=count)
    triangles = np.bincount(region[inside], minlength=count)
    kept = [r for r, mine in zip(partition.regions, own, strict=True) if mine]
    regions = tuple(
        replace(r, id=i, area=float(area[i]), triangles=int(triangles[i]))
        for i, r in enumerate(kept)
    )
    return replace(partition, region=region, regions=regions, vertex_region=number[of_vertex])
