# SPDX-License-Identifier: LGPL-2.1-or-later
"""The region of every measured point, from the regions of a mesh through some of them."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import IntArray
from gpswb.core.partition import Partition
from gpswb.core.projection import vertices_from_facets


def region_of_points(partition: Partition, vertex_of_point: IntArray) -> IntArray:
    """(n,) index into the partition's regions; -1 for points set aside.

    A vertex belongs to the region with the largest product of its area at the vertex and its area
    in all: no facet of a cloud's mesh ends at an edge of the part, so that a strip of facets
    bridges each edge; their vertices lie on the large surfaces beside it.

    Args:
        partition: of the mesh.
        vertex_of_point: (n,) the vertex of each point, -1 for none.
    """
    of_vertex = partition.vertex_region
    if of_vertex is None:
        area = np.array([region.area for region in partition.regions] + [0.0])
        weights = partition.mesh.areas * area[partition.region]
        of_vertex = vertices_from_facets(partition.region, partition.mesh, weights)
    return np.where(vertex_of_point >= 0, of_vertex[vertex_of_point], -1)
