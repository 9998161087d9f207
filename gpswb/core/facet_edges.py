# SPDX-License-Identifier: LGPL-2.1-or-later
"""The interior edges of each facet."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import IntArray, Mesh


def facet_edges(mesh: Mesh) -> tuple[IntArray, IntArray]:
    """Interior edges of each facet and the facets beyond them, in no particular order.

    Returns:
        edge_of (m, 3), rows of ``mesh.facet_pairs``, and beyond (m, 3), facets; -1 where a facet
        has fewer than three interior edges.
    """
    m, e = len(mesh.triangles), len(mesh.facet_pairs)
    facet = mesh.facet_pairs.T.ravel()
    other = mesh.facet_pairs[:, ::-1].T.ravel()
    row = np.tile(np.arange(e, dtype=np.int64), 2)
    order = np.argsort(facet, kind="stable")
    counts = np.bincount(facet, minlength=m)
    slot = np.arange(2 * e) - np.repeat(np.cumsum(counts) - counts, counts)
    edge_of = np.full((m, 3), -1, dtype=np.int64)
    beyond = np.full((m, 3), -1, dtype=np.int64)
    edge_of[facet[order], slot] = row[order]
    beyond[facet[order], slot] = other[order]
    return edge_of, beyond
