# SPDX-License-Identifier: LGPL-2.1-or-later
"""The best expansion move of a label, by a minimum cut (Boykov, Veksler, Zabih, 2001)."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_matrix, csr_matrix
from scipy.sparse.csgraph import breadth_first_order, maximum_flow

from gpswb.core.mesh import BoolArray, FloatArray, IntArray

UNIT = 256.0
"""Capacities are integers: this many of them make a unit of cost."""


def best_move(
    pairs: IntArray,
    price: FloatArray,
    label: IntArray,
    new: int,
    active: IntArray,
    stay: FloatArray,
    move: FloatArray,
    jump: FloatArray,
) -> BoolArray:
    """Which facets take a new label so that the energy falls most.

    Args:
        pairs: (e, 2) neighbours.
        price: (e,) what different labels of neighbours cost.
        label: (m,) labels now.
        new: the label that may be taken.
        active: (k,) facets that may take it, none of which has it.
        stay: (k,) what each of them costs with its own label.
        move: (k,) what it costs with the new one.
        jump: (k,) >= 1, multiplies the price of a border between a facet's own and the new label.

    Returns:
        (k,) bool.
    """
    k = len(active)
    slot = np.full(len(label), -1, dtype=np.int64)
    slot[active] = np.arange(k)
    a, b = pairs.T
    sa, sb = slot[a], slot[b]
    # Unary terms: x = 1 takes the new label.
    zero, one = stay.copy(), move.copy()
    for mine, other in ((sa, b), (sb, a)):
        rim = (mine >= 0) & (slot[other] < 0)
        at = mine[rim]
        own, beyond, w = label[active[at]], label[other[rim]], price[rim]
        zero += np.bincount(at, w * (own != beyond) * np.where(beyond == new, jump[at], 1.0), k)
        one += np.bincount(at, w * (beyond != new) * np.where(beyond == own, jump[at], 1.0), k)
    both = (sa >= 0) & (sb >= 0)
    p, q, w = sa[both], sb[both], price[both]
    differ = w * (label[active[p]] != label[active[q]])
    # E = A + (C - A) x_p + (D - C) x_q + (B + C - A - D)(1 - x_p) x_q with D = 0.
    one += np.bincount(p, w * jump[q] - differ, k)
    zero += np.bincount(q, w * jump[q], k)
    link = w * jump[p] + w * jump[q] - differ
    least = np.minimum(zero, one)
    zero, one = zero - least, one - least
    # Source side: x = 0. Cutting p from the source costs x_p = 1; p -> q is cut for x_p=0, x_q=1.
    source, sink = k, k + 1
    row = np.concatenate([np.full(k, source), np.arange(k), p])
    col = np.concatenate([np.arange(k), np.full(k, sink), q])
    value = np.rint(UNIT * np.concatenate([one, zero, link])).astype(np.int32)
    network = coo_matrix((value, (row, col)), shape=(k + 2, k + 2)).tocsr()
    flow = maximum_flow(network, source, sink).flow
    rest = csr_matrix(network - flow)
    rest.data[rest.data < 0] = 0
    rest.eliminate_zeros()
    reached = breadth_first_order(rest, source, return_predecessors=False)
    taken = np.ones(k + 2, dtype=bool)
    taken[reached] = False
    return taken[:k]
