# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the pipeline returns: the partition of a mesh into recognised regions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray, IntArray, Mesh

Situation = Mapping[str, "list[float]"]
"""Situation feature: any of `point` (mm), `direction` (unit), `normal` (unit)."""

Intrinsic = Mapping[str, float]
"""Intrinsic characteristics: `radius`, `major_radius`, `minor_radius`, `half_angle_deg`,
`lead`; lengths in mm, angles in degrees."""


@dataclass(frozen=True, eq=False)
class Region:
    """One refined region and the invariance class recognised for it (paper, 5.4).

    ``residual`` is the RMS distance (mm) of the region's vertices to the recognised surface (for
    prismatic, revolute and helical: the thickness in quotient space). ``margin`` is how many times
    worse the best rejected more symmetric class fits (1 = no better); ``undecided`` lists the
    classes that the data can't tell apart, empty where the class is sure. ``surface`` names the
    shape behind the class: plane, cylinder, sphere, cone, torus, revolution, extrusion, helicoid,
    freeform.
    """

    id: int
    invariance_class: InvarianceClass
    area: float
    triangles: int
    surface: str
    situation: Situation
    intrinsic: Intrinsic
    residual: float
    margin: float
    initial_regions: int
    log_likelihood: Mapping[InvarianceClass, float] = field(default_factory=dict)
    undecided: tuple[InvarianceClass, ...] = ()


@dataclass(frozen=True, eq=False)
class Partition:
    """A mesh's facets in initial regions, refined regions and invariance classes.

    Args:
        mesh: the mesh that was partitioned.
        shape_type: (m,) int: the facet's shape type, -4..4 by shape index (paper, Table 5), 5
            plane, 6 sharp edge.
        initial_region: (m,) int id of each facet's initial region (paper, 5.2), 0-based.
        region: (m,) int index into ``regions``; -1 for a facet in none (degenerate facets).
        regions: the refined regions in order of their id.
        vertex_shape_type: (n,) int, the same per vertex, for the paper's pictures.
        initial_region_count: number of initial regions, sharp-edge regions not counted.
        sharp_edge_regions: connected components of sharp edges.
        sigma: estimated or given standard deviation of the vertices' noise, mm.
        timings: seconds of each stage.
        vertex_region: (n,) index into ``regions``, -1 for none, where vertices were given a region
            of their own (the points of a cloud); else None.
    """

    mesh: Mesh
    shape_type: IntArray
    initial_region: IntArray
    region: IntArray
    regions: tuple[Region, ...]
    vertex_shape_type: IntArray
    shape_index: FloatArray
    curvedness: FloatArray
    initial_region_count: int
    sharp_edge_regions: int
    sigma: float
    mode: str
    method: str
    timings: Mapping[str, float] = field(default_factory=dict)
    vertex_region: IntArray | None = None
