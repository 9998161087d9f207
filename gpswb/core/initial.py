# SPDX-License-Identifier: LGPL-2.1-or-later
"""First step on facets: curvature, shape types, voting and growing (paper, 4 and 5.2, mended)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gpswb.core.blocks import blocks
from gpswb.core.curvature import Curvature, curvedness, estimate_curvature, shape_index
from gpswb.core.facet_edges import edge_lengths
from gpswb.core.facet_geometry import dot
from gpswb.core.growing import grow_regions
from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.normals import wedge_normals
from gpswb.core.projection import number_facet_regions, vertices_from_facets
from gpswb.core.shape_types import SHARP_EDGE, plane_by_sagitta, shape_types
from gpswb.core.sharp_edges import feature_edges
from gpswb.core.stages import StageClock
from gpswb.core.tolerances import Tolerances
from gpswb.core.voting import vote
from gpswb.core.wedges import Wedges, find_wedges


@dataclass(frozen=True, eq=False)
class InitialPartition:
    """Result of the first step.

    Args:
        crease: (e,) bool feature edges, aligned with ``mesh.facet_pairs``.
        facet_type: (m,) int shape type -4..5 of each facet.
        region: (m,) int initial region; -1 for degenerate facets.
        count: number of initial regions.
        vertex_type: (n,) int shape type, 6 on feature edges.
        shape_index, curvedness: (n,) at the vertices; on feature edges those of the most curved
            wedge.
        sharp_edge_regions: connected components of feature edges.
    """

    crease: BoolArray
    facet_type: IntArray
    region: IntArray
    count: int
    vertex_type: IntArray
    shape_index: FloatArray
    curvedness: FloatArray
    sharp_edge_regions: int


def initial_partition(
    mesh: Mesh, sigma: float, tolerances: Tolerances, clock: StageClock
) -> InitialPartition:
    """Label facets by shape type and grow initial regions that stop at feature edges.

    Args:
        mesh: the mesh.
        sigma: noise of the vertices, mm.
        tolerances: thresholds.
        clock: takes the times of the stages `curvature` and `initial`.
    """
    with clock.stage("curvature"):
        crease = feature_edges(mesh, tolerances)
        wedges, curvature = curvature_between(mesh, crease, sigma)
    with clock.stage("initial"):
        types = _facet_types(mesh, curvature, sigma, tolerances)
        smooth = mesh.facet_pairs[~crease]
        types, _ = vote(types, smooth, max_sweeps=tolerances.vote_sweeps)
        region, count = number_facet_regions(grow_regions(types, smooth)[0], mesh)
        index, curved = _strongest(mesh, wedges, curvature)
        vertex_type = vertices_from_facets(types, mesh)
        on_edge = np.unique(mesh.pair_edges[crease])
        vertex_type[on_edge] = SHARP_EDGE
        part, _ = grow_regions(np.zeros(len(mesh.vertices), np.int64), mesh.pair_edges[crease])
    return InitialPartition(
        crease=crease,
        facet_type=types,
        region=region,
        count=count,
        vertex_type=vertex_type,
        shape_index=index,
        curvedness=curved,
        sharp_edge_regions=len(np.unique(part[on_edge])),
    )


def curvature_between(mesh: Mesh, crease: BoolArray, sigma: float) -> tuple[Wedges, Curvature]:
    """Wedges between creases and the curvature there, averaged as the noise asks for.

    Args:
        mesh: the mesh.
        crease: (e,) bool feature edges.
        sigma: noise of the vertices, mm.
    """
    wedges = find_wedges(mesh, crease)
    normals = wedge_normals(mesh, wedges)
    return wedges, estimate_curvature(mesh, wedges, normals, sweeps=noise_sweeps(mesh, sigma))


def unvoted_types(mesh: Mesh, sigma: float, tolerances: Tolerances | None = None) -> IntArray:
    """(m,) shape type of each facet before voting, for a picture of what voting mends."""
    tolerances = tolerances or Tolerances()
    _, curvature = curvature_between(mesh, feature_edges(mesh, tolerances), sigma)
    return _facet_types(mesh, curvature, sigma, tolerances)


def noise_sweeps(mesh: Mesh, sigma: float) -> int:
    """Averaging sweeps that a noise asks for: none on a nominal mesh, at most 12.

    Noise of sigma on edges of length l turns normals by sigma / l; k sweeps average over a ball of
    about k facets, so that k grows with the square of the turn against 1 degree.
    """
    if sigma <= 0.0 or not len(mesh.pair_edges):
        return 0
    length = float(np.median(edge_lengths(mesh)))
    turn = sigma / max(length, 1e-300) / np.radians(1.0)
    return int(np.clip(np.ceil(turn**2), 0, 12)) if turn > 0.1 else 0


def _facet_types(
    mesh: Mesh, curvature: Curvature, sigma: float, tolerances: Tolerances
) -> IntArray:
    """Shape type of each facet."""
    limit = max(tolerances.sagitta * mesh.diagonal, 3.0 * sigma)
    types = np.empty(len(mesh.triangles), dtype=np.int64)
    for part in blocks(len(types)):
        corner = mesh.columns.take(mesh.triangles[part].T, axis=1)
        side = corner[:, [1, 2, 0]] - corner
        longest = np.sqrt(dot(side, side).max(axis=0))
        mean, difference = curvature.facet_mean[part], curvature.facet_difference[part]
        k_max, k_min = mean + difference, mean - difference
        plane = plane_by_sagitta(curvedness(k_max, k_min), longest, limit)
        types[part] = shape_types(shape_index(k_max, k_min), plane)
    return types


def _strongest(mesh: Mesh, wedges: Wedges, curvature: Curvature) -> tuple[FloatArray, FloatArray]:
    """Shape index and curvedness (n,) of each vertex's most curved wedge; 0 where it has none."""
    order = np.argsort(curvature.curvedness, kind="stable")
    index, curved = np.zeros(len(mesh.vertices)), np.zeros(len(mesh.vertices))
    index[wedges.vertex[order]] = curvature.shape_index[order]
    curved[wedges.vertex[order]] = curvature.curvedness[order]
    return index, curved
