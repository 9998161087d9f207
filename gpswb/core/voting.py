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
    pairs = pairs[votes_cast[pairs].all(axis=1)]
    ones = np.ones(2 * len(pairs))
    ends = np.concatenate([pairs, pairs[:, ::-1]])
    graph = coo_matrix((ones, (ends[:, 0], ends[:, 1])), shape=(n, n)).tocsr()
    free = votes_cast & (np.diff(graph.indptr) > 0)
    if fixed is not None:
        free &= ~fixed
    if in_place:
        colours = _colour(pairs, n)
        sets = [np.flatnonzero(free & (colours == c)) for c in range(colours.max(initial=0) + 1)]
    else:
        sets = [np.flatnonzero(free)]
    rows = [graph[members] for members in sets]
    similarity = 1.0 - shape_type_differences()
    for sweep in range(1, max_sweeps + 1):
        changed = False
        for members, row in zip(sets, rows, strict=True):
            if not len(members):
                continue
            one_hot = np.zeros((n, _LABELS))
            one_hot[votes_cast, current[votes_cast] + 4] = 1.0
            counts = row @ one_hot
            own = current[members] + 4
            possibility = counts * similarity[own]
            best = np.argmax(possibility, axis=1)
            line = np.arange(len(members))
            better = possibility[line, best] > possibility[line, own] + 1e-12
            if better.any():
                changed = True
                current[members[better]] = best[better] - 4
        if not changed:
            return current, sweep
    return current, max_sweeps


def _colour(pairs: IntArray, n: int) -> IntArray:
    """Colour a graph so that neighbours differ (Jones and Plassmann, by element number hashes)."""
    colour = np.full(n, -1, dtype=np.int64)
    # A fixed hash: no neighbours in a row of ascending numbers, the same result every run.
    priority = (np.arange(n, dtype=np.uint64) * np.uint64(0x9E3779B97F4A7C15)).astype(np.int64)
    ends = np.concatenate([pairs, pairs[:, ::-1]])
    level = 0
    while (colour < 0).any():
        waiting = colour < 0
        ends = ends[waiting[ends].all(axis=1)]
        beaten = np.zeros(n, dtype=bool)
        beaten[ends[priority[ends[:, 0]] < priority[ends[:, 1]], 0]] = True
        colour[waiting & ~beaten] = level
        level += 1
    return colour
