# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clusters of angles: the places at which the vertices of a mesh lie about an axis or a tube."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import BoolArray, FloatArray


def gaps_of(angle: FloatArray) -> FloatArray:
    """(n,) gap behind each of sorted angles."""
    return np.diff(np.r_[angle, angle[0] + 2 * np.pi])


def ends_of(angle: FloatArray) -> BoolArray:
    """(n,) whether a cluster of sorted angles ends at each: they are told apart by a small part of
    what they span."""
    gaps = gaps_of(angle)
    span = 2 * np.pi - float(gaps.max())
    ends: BoolArray = gaps > max(1e-3 * span, 1e-9)
    return ends
