# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rival `slippage`: Gelfand and Guibas 2004, from patches of equal size (paper, section
3.3)."""

from __future__ import annotations

import numpy as np

from gpswb.core.initial import InitialPartition, initial_partition
from gpswb.core.invariance import InvarianceClass
from gpswb.core.merging import merge_regions
from gpswb.core.mesh import FloatArray, IntArray, Mesh
from gpswb.core.partition import Partition
from gpswb.core.patches import equal_patches
from gpswb.core.recognised_partition import recognised_partition
from gpswb.core.recognition import Choice, always
from gpswb.core.region_samples import RegionSample
from gpswb.core.similarity import confidence, signature_similarity
from gpswb.core.slippage import (
    SlippageMoments,
    facet_samples,
    printed_signature,
    slippage_moments,
)
from gpswb.core.stages import Progress, StageClock
from gpswb.core.tolerances import PaperSettings, Tolerances

SEARCHED_PATCHES = (1600, 800, 400, 200)
"""Numbers of patches that the search for a size tries; none has fewer than four facets."""


def partition_by_slippage(
    mesh: Mesh,
    sigma: float,
    patch_facets: int | None = None,
    progress: Progress | None = None,
) -> Partition:
    """Merge patches of equal size by slippage signature, k = 3, 2, 1; the signature gives the
    class.

    Signatures are taken after shifting a pair to its centroid and scaling by its radius, as Gelfand
    and Guibas do, with the usual condition number. Nothing knows of edges: patches straddle them,
    and the result depends on the patch size most of all. Without a size several are tried, and the
    one with the least share of area without any motion plus the least share of patches left is
    kept.

    Args:
        mesh: the mesh.
        sigma: noise of the vertices, mm; it only enters the reported residuals.
        patch_facets: facets in a patch; searched if not given.
        progress: listener.
    """
    settings, clock = PaperSettings(), StageClock(progress)
    first = initial_partition(mesh, sigma, Tolerances(), clock)
    with clock.stage("refine"):
        facets = len(mesh.triangles)
        searched = sorted({max(4, round(facets / patches)) for patches in SEARCHED_PATCHES})
        sizes = searched if patch_facets is None else [patch_facets]
        best: tuple[float, IntArray, IntArray] | None = None
        for done, size in enumerate(sizes):
            patch = equal_patches(mesh, size)
            region, cost = _merge(mesh, patch, size, settings)
            if best is None or cost < best[0]:
                best = (cost, patch, region)
            clock.report("refine", (done + 1) / len(sizes))
        assert best is not None
        _, patch, region = best
    patch = np.where(mesh.areas > 0.0, patch, -1)
    started = InitialPartition(
        **{**first.__dict__, "region": patch, "count": len(np.unique(patch[patch >= 0]))}
    )

    def choose(sample: RegionSample) -> Choice:
        return always(class_by_signature(_moments_of(mesh, sample.facets), settings))

    return recognised_partition(
        mesh, started, region, sigma, Tolerances(), clock, "corrected", "slippage", choose
    )


class GelfandRule:
    """Sim = G C C in the frame of each pair's union: centred, scaled to unit mean radius.

    Args:
        moments: additive moments of the patches.
        size: (r,) facets.
        k: motions that must agree.
        patch_facets: N of equation (13), the size of a patch.
        settings: the constants.
    """

    def __init__(
        self,
        moments: SlippageMoments,
        size: IntArray,
        k: int,
        patch_facets: int,
        settings: PaperSettings,
    ) -> None:
        self._motion, self._metric = moments.motion.copy(), moments.metric.copy()
        self._size, self._k, self._patch = size.copy(), k, patch_facets
        self._settings = settings

    def score(self, first: IntArray, second: IntArray) -> FloatArray:
        """Similarity of equation (12)."""
        union = SlippageMoments(
            self._motion[first] + self._motion[second], self._metric[first] + self._metric[second]
        )
        centre, radius = union.centroid, union.gyration
        result = np.ones(len(first))
        vectors = []
        for index in (first, second):
            own = SlippageMoments(self._motion[index], self._metric[index]).moved(centre)
            count, _, vector = printed_signature(
                _unit(own.motion, radius), self._settings.condition_number
            )
            result *= confidence(self._size[index], count, self._k, self._patch)
            vectors.append(vector[:, :, : self._k])
        width = self._settings.signature_width
        similarity: FloatArray = result * signature_similarity(
            vectors[0], vectors[1], self._k, width
        )
        return similarity

    def join(self, kept: IntArray, gone: IntArray) -> None:
        """Add the moments and sizes."""
        for array in (self._motion, self._metric, self._size):
            array[kept] += array[gone]


def class_by_signature(moments: SlippageMoments, settings: PaperSettings) -> InvarianceClass:
    """Class from the number and kind of the slippable motions of one region.

    Three: spherical if they are rotations, else planar. Two: cylindrical. One: prismatic, revolute
    or helical as its rotation, its pitch or neither vanishes. None: complex.
    """
    radius = moments.gyration
    motion = _unit(moments.moved(moments.centroid).motion, radius)
    count, _, vectors = printed_signature(motion, settings.condition_number)
    number = int(count[0])
    if number == 0:
        return "complex"
    omega, t = vectors[0, :3, :number], vectors[0, 3:, :number]
    if number >= 3:
        return "spherical" if np.linalg.svd(omega[:, :3])[1][2] > 0.3 else "planar"
    if number == 2:
        return "cylindrical"
    turn = float(np.linalg.norm(omega))
    if turn < 0.1:
        return "prismatic"
    pitch = abs(float(omega[:, 0] @ t[:, 0])) / turn**2
    return "revolute" if pitch < 0.02 else "helical"


def _unit(motion: FloatArray, radius: FloatArray) -> FloatArray:
    """M with lengths divided by each radius."""
    scale = np.ones((len(motion), 6))
    scale[:, :3] = 1.0 / np.maximum(radius, 1e-300)[:, None]
    unit: FloatArray = motion * scale[:, :, None] * scale[:, None, :]
    return unit


def _moments_of(mesh: Mesh, facets: IntArray) -> SlippageMoments:
    part = Mesh(mesh.vertices, mesh.triangles[facets])
    return _moments(_flat_samples(part), np.zeros(len(facets), dtype=np.int64), 1)


def _flat_samples(mesh: Mesh) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Samples with facet normals: nothing is averaged, so nothing leaks."""
    return facet_samples(mesh, np.repeat(mesh.facet_normals[:, None], 3, axis=1))


def _moments(
    samples: tuple[FloatArray, FloatArray, FloatArray], label: IntArray, count: int
) -> SlippageMoments:
    return slippage_moments(*samples, np.repeat(label, 3), count)


def _merge(
    mesh: Mesh, patch: IntArray, patch_facets: int, settings: PaperSettings
) -> tuple[IntArray, float]:
    """Merged regions and the cost that the search for a size minimises."""
    region, patches = patch.copy(), int(patch.max(initial=-1)) + 1
    samples = _flat_samples(mesh)
    for k in (3, 2, 1):
        moments = _moments(samples, region, patches)
        size = np.bincount(region, minlength=patches)
        rule = GelfandRule(moments, size, k, patch_facets, settings)
        region = merge_regions(patches, region[mesh.facet_pairs], rule, settings.similarity)[region]
    moments = _moments(samples, region, patches)
    motion = _unit(moments.moved(moments.centroid).motion, moments.gyration)
    count, _, _ = printed_signature(motion, settings.condition_number)
    total = max(float(moments.weight.sum()), 1e-300)
    without = float(moments.weight[count == 0].sum()) / total
    return region, without + len(np.unique(region)) / max(patches, 1)
