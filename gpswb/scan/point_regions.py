# SPDX-License-Identifier: LGPL-2.1-or-later
"""The region of every measured point, from the regions of a mesh through some of them."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import FloatArray, IntArray, Mesh
from gpswb.core.partition import Partition
from gpswb.core.projection import vertices_from_facets


def region_of_points(partition: Partition, vertex_of_point: IntArray) -> IntArray:
    """(n,) index into the partition's regions; -1 for points set aside: see `largest_region`."""
    area = np.array([region.area for region in partition.regions])
    return largest_region(partition.mesh, partition.region, area, vertex_of_point)


def largest_region(
    mesh: Mesh, region: IntArray, area: FloatArray, vertex_of_point: IntArray
) -> IntArray:
    """(n,) region of each point; -1 for points set aside.

    A vertex belongs to the region with the largest product of its area at the vertex and its area
    in all: no facet of a cloud's mesh ends at an edge of the part, so that a strip of facets
    bridges each edge; their vertices lie on the large surfaces beside it.

    Args:
        mesh: the mesh.
        region: (m,) region of each facet, -1 for none.
        area: (r,) area of each region, mm².
        vertex_of_point: (n,) the vertex of each point, -1 for none.
    """
    weights = mesh.areas * np.r_[area, 0.0][region]
    of_vertex = vertices_from_facets(region, mesh, weights)
    return np.where(vertex_of_point >= 0, of_vertex[vertex_of_point], -1)
