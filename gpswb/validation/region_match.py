# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions against maximal integral features: F1 at IoU 0.9, over- and under-segmentation."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gpswb.cad.solid import FaceMap
from gpswb.core.mesh import FloatArray, IntArray
from gpswb.core.partition import Partition

IOU = 0.9
"""Intersection over union, by area, from which a region is a feature found (design, section 6)."""

PART = 0.1
"""Share of its area from which a piece counts as over- or under-segmentation."""


@dataclass(frozen=True, eq=False)
class RegionMatch:
    """How the regions cover the maximal features.

    Args:
        overlap: (r, f) float64, mm², common area of each region and each feature.
        features: (f,) int64 number of each column's feature in ``FaceMap.feature_of_face``.
        region_of_feature: (f,) int64 row of the region matched at ``IOU``; -1 where none is.
        iou_of_feature: (f,) float64 best IoU of any region with the feature.
    """

    overlap: FloatArray
    features: IntArray
    region_of_feature: IntArray
    iou_of_feature: FloatArray

    @property
    def true_positives(self) -> int:
        """Features found."""
        return int((self.region_of_feature >= 0).sum())

    @property
    def regions(self) -> int:
        """Regions that hold any area."""
        return int((self.overlap.sum(axis=1) > 0).sum())

    @property
    def f1(self) -> float:
        """2·TP/(regions + features); 1 where there is nothing to find and nothing was found."""
        denominator = self.regions + len(self.features)
        return 2.0 * self.true_positives / denominator if denominator else 1.0

    @property
    def over_segmented(self) -> int:
        """Features of which two regions or more each hold at least ``PART``."""
        whole = self.overlap.sum(axis=0, keepdims=True)
        return int((((self.overlap >= PART * whole) & (self.overlap > 0)).sum(axis=0) > 1).sum())

    @property
    def under_segmented(self) -> int:
        """Regions of which two features or more each hold at least ``PART``."""
        whole = self.overlap.sum(axis=1, keepdims=True)
        return int((((self.overlap >= PART * whole) & (self.overlap > 0)).sum(axis=1) > 1).sum())


def match_regions(partition: Partition, facemap: FaceMap) -> RegionMatch:
    """Match regions and maximal features one to one by area-weighted IoU of at least ``IOU``.

    Above one half IoU a region can match one feature only and the other way round, so that the
    greedy choice is the best one. Triangles of no face take no part.
    """
    features, column = np.unique(facemap.feature_of_face, return_inverse=True)
    r, f = len(partition.regions), len(features)
    area = partition.mesh.areas
    known = facemap.face_of_triangle >= 0
    feature = np.full(len(area), -1, dtype=np.int64)
    feature[known] = column[facemap.face_of_triangle[known]]
    use = known & (partition.region >= 0)
    cell = partition.region[use] * f + feature[use]
    overlap: FloatArray = np.zeros(r * f)
    overlap += np.bincount(cell, area[use], minlength=r * f)
    overlap = overlap.reshape(r, f)
    of_feature = np.bincount(feature[known], area[known], minlength=f)
    of_region = overlap.sum(axis=1)
    union = of_region[:, None] + of_feature[None, :] - overlap
    iou = np.divide(overlap, union, out=np.zeros_like(overlap), where=union > 0)
    best = iou.max(axis=0, initial=0.0)
    matched = np.where(best >= IOU, iou.argmax(axis=0) if r else -1, -1).astype(np.int64)
    return RegionMatch(overlap, features, matched, best)
