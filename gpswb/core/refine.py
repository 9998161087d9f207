# SPDX-License-Identifier: LGPL-2.1-or-later
"""Second step on facets: merging by slippage for k = 3..0, and give-back (paper, 5.3, mended)."""

from __future__ import annotations

import numpy as np

from gpswb.core.blocks import blocks
from gpswb.core.core_facets import core_facets
from gpswb.core.facet_edges import edge_lengths
from gpswb.core.give_back import give_back
from gpswb.core.growing import grow_regions
from gpswb.core.merging import merge_regions
from gpswb.core.mesh import BoolArray, IntArray, Mesh
from gpswb.core.quadric_moments import quadric_moments
from gpswb.core.region_samples import CornerNormals, confined_normals
from gpswb.core.slippage import facet_samples, slippage_moments
from gpswb.core.slippage_rule import MergeLimits, MergeState, SlippageRule
from gpswb.core.submesh import WORTHWHILE, submesh
from gpswb.core.tolerances import Tolerances

_PASSES = 2  # the second pass works on borders that the first has cleaned


def refine_regions(
    mesh: Mesh, initial: IntArray, crease: BoolArray, sigma: float, tolerances: Tolerances
) -> IntArray:
    """Merge initial regions into refined ones and clean their tangent borders.

    Args:
        mesh: the mesh.
        initial: (m,) int initial regions; -1 for facets left out, the degenerate ones among them.
        crease: (e,) bool feature edges.
        sigma: noise of the vertices, mm.
        tolerances: thresholds.

    Returns:
        (m,) int64 refined regions (numbers with gaps); -1 for facets left out.
    """
    facets = np.flatnonzero(initial >= 0)
    if len(facets) < WORTHWHILE * len(initial):
        part, crease = submesh(mesh, facets, crease)
        region = np.full(len(initial), -1, dtype=np.int64)
        region[facets] = _refined(part, initial[facets], crease, sigma, tolerances)
        return region
    return _refined(mesh, initial, crease, sigma, tolerances)


def _refined(
    mesh: Mesh, initial: IntArray, crease: BoolArray, sigma: float, tolerances: Tolerances
) -> IntArray:
    """What `refine_regions` returns, on a mesh most of which has regions."""
    region = initial.copy()
    for last in range(_PASSES):
        # Freeform pieces merge last of all: until borders are clean, any region may seem to be one.
        motions = (3, 2, 1, 0) if last == _PASSES - 1 else (3, 2, 1)
        region = _merge(mesh, region, crease, motions, sigma, tolerances)
        region = give_back(mesh, region, crease, sigma, tolerances)
        # A border moved may have cut a region in two, or joined pieces of one.
        grown, _ = grow_regions(region, mesh.facet_pairs)
        region = np.where(region >= 0, grown, -1)
    return region


def _merge(
    mesh: Mesh,
    region: IntArray,
    crease: BoolArray,
    motions: tuple[int, ...],
    sigma: float,
    tolerances: Tolerances,
) -> IntArray:
    """One round of merging for each number of motions, across smooth edges."""
    count = int(region.max(initial=-1)) + 1
    first, second = region[mesh.facet_pairs[:, 0]], region[mesh.facet_pairs[:, 1]]
    apart = np.flatnonzero((first != second) & (first >= 0) & (second >= 0) & ~crease)
    border = np.stack([first[apart], second[apart]], axis=1)
    if not len(border):
        return region
    core = np.where(core_facets(mesh, region, crease), region, -1)
    edge = float(np.sqrt((edge_lengths(mesh) ** 2).mean()))
    limits = MergeLimits(
        slippable=max(tolerances.slippable, 4.0 * (sigma / edge) ** 2),
        coarse=tolerances.coarse,
        stand_off=max(tolerances.distance, 3.0 * sigma / mesh.diagonal),
        similarity=tolerances.similarity,
        signature_width=tolerances.signature_width,
        confident_facets=tolerances.confident_facets,
    )
    state = _state(mesh, core, count, confined_normals(mesh, region, crease))
    rule = SlippageRule(state, motions[0], limits)
    kept = np.arange(count, dtype=np.int64)
    for k in motions:
        rule.k = k
        kept = merge_regions(count, kept[border], rule, 1e-12)[kept]
    return np.where(region >= 0, kept[region], -1)


def _state(mesh: Mesh, label: IntArray, count: int, corner_normals: CornerNormals) -> MergeState:
    """Moments of each region in a frame centred in the mesh and scaled by its diagonal."""
    centre = 0.5 * (mesh.vertices.min(axis=0) + mesh.vertices.max(axis=0))
    scale = max(mesh.diagonal, 1e-300)
    motion, metric = np.zeros((count, 6, 6)), np.zeros((count, 6, 6))
    quadric = np.zeros((count, 10, 10))
    order = np.argsort(label, kind="stable")
    order = order[int((label < 0).sum()) :]
    for part in blocks(len(order)):
        facets = order[part]
        # Facets of equal label follow each other, so that a block holds a few labels in a row.
        low, high = int(label[facets[0]]), int(label[facets[-1]]) + 1
        own = np.repeat(label[facets] - low, 3)
        points, normals, weights = facet_samples(mesh, corner_normals.at(facets), facets)
        weights = weights / scale**2
        points = (points - centre) / scale
        moments = slippage_moments(points, normals, weights, own, high - low)
        motion[low:high] += moments.motion
        metric[low:high] += moments.metric
        corners = (mesh.corners_of(facets).reshape(-1, 3) - centre) / scale
        quadric[low:high] += quadric_moments(corners, weights, own, high - low)
    facets = np.bincount(label[label >= 0], minlength=count)
    first, second = label[mesh.facet_pairs].T
    inside = (first == second) & (first >= 0)
    squared = mesh.turning[inside] ** 2
    turning = np.stack(
        [
            np.bincount(first[inside], weights=squared, minlength=count),
            np.bincount(first[inside], minlength=count).astype(np.float64),
        ],
        axis=1,
    )
    return MergeState(motion, metric, quadric, facets, turning)
