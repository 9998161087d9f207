# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows of a table that belong together."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import IntArray


def groups(key: IntArray) -> list[tuple[tuple[int, ...], IntArray]]:
    """Rows of ``key`` (r, c) that are equal: the row and the indices where it stands."""
    if not len(key):
        return []
    order = np.lexsort(key.T)
    ordered = key[order]
    new = np.r_[True, (ordered[1:] != ordered[:-1]).any(axis=1)]
    start = np.flatnonzero(new)
    return [
        (tuple(int(x) for x in ordered[s]), group)
        for s, group in zip(start, np.split(order, start[1:]), strict=True)
    ]
