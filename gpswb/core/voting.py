# SPDX-License-Identifier: LGPL-2.1-or-later
"""Refinement of shape types by iterative voting among neighbours (paper, equations 9 to 11)."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_matrix

from gpswb.core.mesh import BoolArray, FloatArray, IntArray
from gpswb.core.shape_types import PLANE, SHARP_EDGE

_LABELS = 10  # shape types -4..5 as columns 0..9


def shape_type_differences() -> FloatArray:
    """(10, 10) table of D(T_i, T_j), rows i and columns j for T = -4..5 (equation 9).

    |T_j - T_i| / 8 between non-planar types, 0 between planes, 1/9 from plane to non-planar. A
    planar neighbour of a non-planar point has no vote: its D is 1.
    """
    types = np.arange(-4, PLANE + 1)
    table = np.abs(types[:, None] - types[None, :]) / 8.0
    table[-1, :], table[:, -1], table[-1, -1] = 1.0 / 9.0, 1.0, 0.0
    return table


def vote(
    types: IntArray,
    pairs: IntArray,
    *,
    in_place: bool = True,
    max_sweeps: int = 20,
    fixed: BoolArray | None = None,
) -> tuple[IntArray, int]:
    """Relabel each element to the type with the largest P = (n_j / |N|) (1 - D); ties keep.

    Args:
        types: (n,) int -4..5; elements of type 6 (sharp edges) neither vote nor change.
        pairs: (p, 2) int neighbouring elements.
        in_place: sweep over independent sets of elements, each seeing the votes before it, which
            settles; ``False`` updates all elements at once, as printed, which may oscillate.
        max_sweeps: cap on the sweeps.
        fixed: (n,) bool elements that vote but keep their type.

    Returns:
        The refined types (n,), and the number of sweeps made (``max_sweeps`` if not settled).
    """
    n = len(types)
    current = types.copy()
    votes_cast = types != SHARP_EDGE
    if not votes_cast.all():
        pairs = pairs[votes_cast[pairs[:, 0]] & votes_cast[pairs[:, 1]]]
    one_way = coo_matrix((np.ones(len(pairs), np.int16), tuple(pairs.T)), shape=(n, n)).tocsr()
    graph = (one_way + one_way.T).tocsr()
    free = votes_cast if fixed is None else votes_cast & ~fixed
    sets = _independent_sets(pairs, free) if in_place else [np.flatnonzero(free)]
    similarity = 1.0 - shape_type_differences()
    # An element asks again only once a neighbour has changed; who agrees with all never does.
    asks = np.zeros(n, dtype=bool)
    asks[pairs[current[pairs[:, 0]] != current[pairs[:, 1]]]] = True
    for sweep in range(1, max_sweeps + 1):
        changed = False
        for members in sets:
            asking = members[asks[members]]
            asks[asking] = False
            near = graph[asking]
            line = np.arange(len(asking))
            entry = np.repeat(line, np.diff(near.indptr)) * _LABELS + current[near.indices] + 4
            counts = np.bincount(entry, near.data, len(asking) * _LABELS).reshape(-1, _LABELS)
            own = current[asking] + 4
            possibility = counts * similarity[own]
            best = np.argmax(possibility, axis=1)
            better = possibility[line, best] > possibility[line, own] + 1e-12
            if better.any():
                changed = True
                moved = asking[better]
                current[moved] = best[better] - 4
                asks[moved] = True
                asks[graph[moved].indices] = True
        if not changed:
            return current, sweep
    return current, max_sweeps


def _independent_sets(pairs: IntArray, members: BoolArray) -> list[IntArray]:
    """Sets of members without neighbours among them (Jones and Plassmann, by hashes).

    Every element waits until no neighbour of higher priority does.
    """
    n = len(members)
    # A fixed hash: no neighbours in a row of ascending numbers, the same result every run.
    priority = (np.arange(n, dtype=np.uint64) * np.uint64(0x9E3779B97F4A7C15)).astype(np.int64)
    alone = pairs[:, 0] == pairs[:, 1]
    first, second = (pairs[~alone] if alone.any() else pairs).T
    lower = priority[first] < priority[second]
    beaten, winner = np.where(lower, first, second), np.where(lower, second, first)
    waits = np.ones(n, dtype=bool)
    waiting = np.arange(n)
    sets = []
    while len(waiting):
        free = np.ones(n, dtype=bool)
        free[beaten] = False
        chosen = free[waiting]
        sets.append(waiting[chosen & members[waiting]])
        waits[waiting[chosen]] = False
        waiting = waiting[~chosen]
        left = waits[winner]
        beaten, winner = beaten[left], winner[left]
    return sets
