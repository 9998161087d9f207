# SPDX-License-Identifier: LGPL-2.1-or-later
"""Merging of adjacent regions, most similar first (paper, 5.3; Gelfand and Guibas 2004)."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from gpswb.core.mesh import FloatArray, IntArray


class MergeRule(Protocol):
    """What decides a merge: regions are numbers, and everything about them adds up."""

    def score(self, first: IntArray, second: IntArray) -> FloatArray:
        """Similarity (p,) of pairs of regions; 0 forbids the merge."""

    def join(self, kept: IntArray, gone: IntArray) -> None:
        """Make each region ``kept`` (p,) the union with ``gone`` (p,), which is asked for no more.

        No region is in two of the pairs.
        """


def merge_regions(count: int, pairs: IntArray, rule: MergeRule, least: float) -> IntArray:
    """Merge the most similar adjacent regions until no pair reaches the least similarity.

    In rounds: all pairs that are each other's most similar neighbours merge at once, then all
    neighbours of the unions are scored anew, in one batch. One pair at a time, the most similar of
    all first, would give the same but where a union far away becomes a better neighbour still.

    Args:
        count: number of regions.
        pairs: (p, 2) int adjacent regions; repeats and self-pairs are ignored.
        rule: scores pairs and keeps what it knows of each region.
        least: least similarity, > 0.

    Returns:
        (count,) int64: the region each one ended in, by the number of the region that was kept.
    """
    parent = np.arange(count, dtype=np.int64)
    edges, _ = _distinct(pairs, count)
    score, stale = np.zeros(len(edges)), np.ones(len(edges), dtype=bool)
    while stale.any():
        score[stale] = rule.score(*edges[stale].T)
        chosen = edges[_mutual(edges, score, least, count)]
        if not len(chosen):
            break
        # The one with more neighbours is kept.
        degree = np.bincount(edges.ravel(), minlength=count)
        swap = degree[chosen[:, 0]] < degree[chosen[:, 1]]
        kept, gone = np.where(swap, chosen.T[::-1], chosen.T)
        rule.join(kept, gone)
        parent[gone] = kept
        touched = np.zeros(count, dtype=bool)
        touched[kept] = True
        edges, first = _distinct(parent[edges], count)
        score = score[first]
        stale = touched[edges[:, 0]] | touched[edges[:, 1]]
    while True:
        grand = parent[parent]
        if np.array_equal(grand, parent):
            return parent
        parent = grand


def _mutual(edges: IntArray, score: FloatArray, least: float, count: int) -> IntArray:
    """Indices of the edges that no edge at either end surpasses; the lower numbers win a tie."""
    order = np.lexsort((edges[:, 1], edges[:, 0], -score))
    order = order[score[order] >= least]
    best = np.full(count, -1, dtype=np.int64)
    # Written from the worst to the best: the best stays.
    best[edges[order[::-1]].T] = order[::-1]
    mutual: IntArray = order[(best[edges[order]] == order[:, None]).all(axis=1)]
    return mutual


def _distinct(pairs: IntArray, count: int) -> tuple[IntArray, IntArray]:
    """The different pairs (e, 2) of two regions, lower first, and where each stood first (e,)."""
    two = np.flatnonzero(pairs[:, 0] != pairs[:, 1])
    low, high = pairs[two].min(axis=1), pairs[two].max(axis=1)
    key, first = np.unique(low * count + high, return_index=True)
    return np.column_stack(np.divmod(key, max(count, 1))), two[first]
