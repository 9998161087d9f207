# SPDX-License-Identifier: LGPL-2.1-or-later
"""Similarity of slippage signatures (paper, equations 12 and 13)."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import FloatArray, IntArray


def signature_similarity(
    first: FloatArray, second: FloatArray, k: int, width: float = 0.1
) -> FloatArray:
    """G(sigma_{k+1}) of pairs of signatures (equation 12).

    With orthonormal columns A and B the singular values of (A B) are sqrt(1 +- c_i), c_i the
    cosines of the angles between the spans, so that sigma_{k+1} = sqrt(1 - c_k): 0 when both share
    k motions.

    Args:
        first, second: (p, 6, q) signatures in one frame: orthonormal columns, the slippable motions
            first, zero where a region has no more of them.
        k: number of motions that must agree, 1..q.
        width: w in G(x) = exp(-x^2 / (2 w^2)).

    Returns:
        (p,) in [0, 1].
    """
    cosines = np.linalg.svd(np.swapaxes(first, 1, 2) @ second, compute_uv=False)
    squared = 1.0 - np.clip(cosines[:, k - 1], 0.0, 1.0)
    similarity: FloatArray = np.exp(-squared / (2.0 * width**2))
    return similarity


def confidence(size: IntArray, motions: IntArray, k: int, component_size: float) -> FloatArray:
    """C(P, k) = min(1, |P| / N) of a patch with at least k slippable motions, else 0 (equation 13).

    Only the letter N survives in the print of equation 13; the rest is Gelfand and Guibas's.
    """
    return np.where(motions >= k, np.minimum(1.0, size / component_size), 0.0)
