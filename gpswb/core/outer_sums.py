# SPDX-License-Identifier: LGPL-2.1-or-later
"""Second moments of labelled rows."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import FloatArray, IntArray


def outer_sums(rows: FloatArray, weights: FloatArray, label: IntArray, count: int) -> FloatArray:
    """Sum w x x^T over the rows x of each label.

    One matrix product a label on sorted rows: several times faster than a bincount for each entry
    of the matrix, as long as labels are far fewer than rows.

    Args:
        rows: (n, d).
        weights: (n,).
        label: (n,) int 0..count-1; rows with a negative label are left out.
        count: number of labels.

    Returns:
        (count, d, d).
    """
    inside = np.flatnonzero(label >= 0)
    order = inside[np.argsort(label[inside], kind="stable")]
    bounds = np.searchsorted(label[order], np.arange(count + 1))
    rows = rows[order]
    weighted = weights[order, None] * rows
    sums = np.zeros((count, rows.shape[1], rows.shape[1]))
    for k in np.flatnonzero(np.diff(bounds)).tolist():
        part = slice(bounds[k], bounds[k + 1])
        sums[k] = rows[part].T @ weighted[part]
    return 0.5 * (sums + np.swapaxes(sums, 1, 2))
