# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thinning of a point cloud by a grid of cubes."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import FloatArray, IntArray

_TRIALS = 40


def thin(points: FloatArray, most: int) -> tuple[IntArray, IntArray, float]:
    """Keep one point in each cube of a grid, the one nearest to the mean of the cube's points.

    The cubes are as small as ``most`` allows, within a few per cent. Kept points are measured ones:
    averages would lie off curved surfaces and cut edges off.

    Args:
        points: (n, 3) finite, mm.
        most: number of points to keep at most, at least 1.

    Returns:
        (k,) indices of the kept points, rising; (n,) for each point the position in the first of
        the one that stands for it; the cubes' edge, mm, 0 where nothing had to go.
    """
    n = len(points)
    if n <= most:
        return np.arange(n), np.arange(n), 0.0
    low = points.min(axis=0)
    span = float(np.ptp(points, axis=0).max())
    # Points on a surface fill about (span / edge)² cubes; the search mends the guess.
    large, small = 2.0 * span, 0.0
    edge = span / np.sqrt(most)
    for _ in range(_TRIALS):
        count = len(np.unique(_cells(points, low, edge)))
        if count > most:
            small = edge
        else:
            large = edge
            if count > 0.95 * most:
                break
        if large - small < 1e-3 * large:
            break
        guess = edge * np.sqrt(count / (0.98 * most))
        edge = guess if small < guess < large else 0.5 * (small + large)
    cell, stands = np.unique(_cells(points, low, large), return_inverse=True)
    stands = stands.reshape(-1)
    size = np.bincount(stands)
    mean = np.column_stack([np.bincount(stands, points[:, k]) / size for k in range(3)])
    off = ((points - mean[stands]) ** 2).sum(axis=1)
    order = np.lexsort((off, stands))
    kept = order[np.r_[0, np.cumsum(size)[:-1]]]
    rank = np.argsort(kept)
    place = np.empty(len(cell), dtype=np.int64)
    place[rank] = np.arange(len(cell))
    return kept[rank].astype(np.int64), place[stands], float(large)


def _cells(points: FloatArray, low: FloatArray, edge: float) -> IntArray:
    """(n,) number of the cube that holds each point."""
    cell = np.floor((points - low) / edge).astype(np.int64)
    size = cell.max(axis=0) + 1
    number: IntArray = (cell[:, 0] * size[1] + cell[:, 1]) * size[2] + cell[:, 2]
    return number
