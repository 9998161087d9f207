# SPDX-License-Identifier: LGPL-2.1-or-later
"""The merge rule as printed (paper, equations 1 to 3, 12 and 13)."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import FloatArray, IntArray
from gpswb.core.outer_sums import outer_sums
from gpswb.core.similarity import confidence, signature_similarity
from gpswb.core.slippage import printed_signature
from gpswb.core.tolerances import PaperSettings


class PrintedRule:
    """Sim = G(sigma_{k+1}) C(P_i, k) C(P_j, k) on signatures of M_c as it comes.

    Eigenvectors mix millimetres with pure numbers and depend on the origin: so do the merges.

    Args:
        motion: (r, 6, 6) matrices M_c of equation (2).
        size: (r,) points of each patch.
        k: number of slippable motions that must agree.
        settings: the constants.
    """

    def __init__(self, motion: FloatArray, size: IntArray, k: int, settings: PaperSettings) -> None:
        self._motion, self._size = motion.copy(), size.copy()
        self._k, self._settings = k, settings
        self._motions, _, self._vectors = printed_signature(motion, settings.condition_number)

    def score(self, first: IntArray, second: IntArray) -> FloatArray:
        """Similarity of equation (12)."""
        k, settings = self._k, self._settings
        angle = signature_similarity(
            self._vectors[first, :, :k], self._vectors[second, :, :k], k, settings.signature_width
        )
        each = [
            confidence(self._size[i], self._motions[i], k, settings.component_size)
            for i in (first, second)
        ]
        similarity: FloatArray = angle * each[0] * each[1]
        return similarity

    def join(self, kept: IntArray, gone: IntArray) -> None:
        """Add M_c and the sizes; decompose anew."""
        self._motion[kept] += self._motion[gone]
        self._size[kept] += self._size[gone]
        count, _, vectors = printed_signature(self._motion[kept], self._settings.condition_number)
        self._motions[kept], self._vectors[kept] = count, vectors


def printed_motion_matrices(
    points: FloatArray, normals: FloatArray, label: IntArray, count: int
) -> FloatArray:
    """(r, 6, 6) matrices M_c of equation (2): sums over points of (p x n, n)(p x n, n)^T."""
    rows = np.concatenate([np.cross(points, normals), normals], axis=1)
    return outer_sums(rows, np.ones(len(rows)), label, count)
