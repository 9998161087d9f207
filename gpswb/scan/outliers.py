# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points of a cloud that lie apart from the others."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from gpswb.core.mesh import BoolArray, FloatArray

NEIGHBOURS = 8
"""Enough for a distance that one stray neighbour doesn't decide; small against a feature."""

APART = 3.0
"""How many times farther than its neighbours' neighbours are a point's own may be. In a random
sample of a surface the ratio exceeds 2 for one point in some thousands, at its border too; a ratio,
so that a scan's density may vary from place to place."""


def lonely(points: FloatArray) -> BoolArray:
    """(n,) bool: points whose neighbours are ``APART`` times as far as their neighbours' are.

    The local distance is the mean to the ``NEIGHBOURS`` nearest (a k-distance as in Breunig's
    local outlier factor, 2000), compared with its median among these neighbours.

    Args:
        points: (n, 3), distinct; mm.
    """
    n = len(points)
    if n <= NEIGHBOURS + 1:
        return np.zeros(n, dtype=bool)
    distance, near = cKDTree(points).query(points, k=NEIGHBOURS + 1)
    own = distance[:, 1:].mean(axis=1)
    theirs = np.median(own[near[:, 1:]], axis=1)
    # A pair of strays has only each other near: the others' distances must speak as well.
    return np.asarray(own > APART * np.minimum(theirs, np.quantile(own, 0.98)))
