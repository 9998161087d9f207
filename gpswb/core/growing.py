# SPDX-License-Identifier: LGPL-2.1-or-later
"""Region growing by mesh crawling (paper, 5.2.2): connected components of equal label."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from gpswb.core.mesh import IntArray


def grow_regions(labels: IntArray, pairs: IntArray) -> tuple[IntArray, int]:
    """Connected components of equal label.

    The result does not depend on where the paper's crawl would start: components are unique. They
    are numbered by their first element.

    Args:
        labels: (n,) int shape type (or any label) of each vertex or facet.
        pairs: (p, 2) int adjacent elements; leave out the pairs that a feature edge separates.

    Returns:
        (n,) int64 region of each element, and the number of regions.
    """
    n = len(labels)
    alike = pairs[labels[pairs[:, 0]] == labels[pairs[:, 1]]]
    graph = coo_matrix((np.ones(len(alike), np.int8), (alike[:, 0], alike[:, 1])), shape=(n, n))
    _, component = connected_components(graph, directed=False)
    return number_by_first(component.astype(np.int64))


def number_by_first(label: IntArray) -> tuple[IntArray, int]:
    """Renumber labels 0, 1, ... in the order of first appearance; also their number.

    Args:
        label: (n,) int, at least 0 and not much larger than n.
    """
    seen = np.full(int(label.max(initial=-1)) + 1, -1, dtype=np.int64)
    # Written from the last to the first: what stays is the first.
    seen[label[::-1]] = np.arange(len(label))[::-1]
    order = np.argsort(seen, kind="stable")
    order = order[int((seen < 0).sum()) :]
    rank = np.empty(len(seen), dtype=np.int64)
    rank[order] = np.arange(len(order))
    return rank[label], len(order)
