# SPDX-License-Identifier: LGPL-2.1-or-later
"""Merging of adjacent regions, most similar first (paper, 5.3; Gelfand and Guibas 2004)."""

from __future__ import annotations

import heapq
from typing import Protocol

import numpy as np

from gpswb.core.mesh import FloatArray, IntArray


class MergeRule(Protocol):
    """What decides a merge: regions are numbers, and everything about them adds up."""

    def score(self, first: IntArray, second: IntArray) -> FloatArray:
        """Similarity (p,) of pairs of regions; 0 forbids the merge."""

    def join(self, kept: int, gone: int) -> None:
        """Make region ``kept`` the union of both; ``gone`` is asked for no more."""


def merge_regions(count: int, pairs: IntArray, rule: MergeRule, least: float) -> IntArray:
    """Merge the most similar adjacent pair until no pair reaches the least similarity.

    A heap holds every adjacent pair; a merge scores the union's neighbours anew, all at once, so
    that the cost is E log E score look-ups for E adjacent pairs.

    Args:
        count: number of regions.
        pairs: (p, 2) int adjacent regions; repeats and self-pairs are ignored.
        rule: scores pairs and keeps what it knows of each region.
        least: least similarity, > 0.

    Returns:
        (count,) int64: the region each one ended in, by the number of the region that was kept.
    """
    neighbours: list[set[int]] = [set() for _ in range(count)]
    for a, b in np.unique(np.sort(pairs, axis=1), axis=0).tolist():
        if a != b:
            neighbours[a].add(b)
            neighbours[b].add(a)
    parent = np.arange(count, dtype=np.int64)
    version = [0] * count
    heap: list[tuple[float, int, int, int, int]] = []

    def push(first: list[int], second: list[int]) -> None:
        if not first:
            return
        scores = rule.score(np.array(first, dtype=np.int64), np.array(second, dtype=np.int64))
        for a, b, value in zip(first, second, scores.tolist(), strict=True):
            if value >= least:
                heapq.heappush(heap, (-value, a, b, version[a], version[b]))

    edges = [(a, b) for a in range(count) for b in sorted(neighbours[a]) if a < b]
    push([a for a, _ in edges], [b for _, b in edges])
    while heap:
        _, a, b, version_a, version_b = heapq.heappop(heap)
        if version[a] != version_a or version[b] != version_b:
            continue
        if len(neighbours[a]) < len(neighbours[b]):
            a, b = b, a
        rule.join(a, b)
        parent[b] = a
        version[a] += 1
        version[b] = -1
        neighbours[a] |= neighbours[b]
        neighbours[a] -= {a, b}
        for other in neighbours[b]:
            neighbours[other].discard(b)
            if other != a:
                neighbours[other].add(a)
        neighbours[b] = set()
        around = sorted(neighbours[a])
        push([a] * len(around), around)
    while True:
        grand = parent[parent]
        if np.array_equal(grand, parent):
            return parent
        parent = grand
