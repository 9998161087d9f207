# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of a mesh within which curvature is seen not to jump: pieces of one face."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import BoolArray, IntArray, Mesh
from gpswb.core.robust.curvature_jumps import curvature_jumps
from gpswb.core.robust.topology import FacetGraph

LEAST = 64
"""Facets of a part that is asked about: to fit the pieces of a smaller one costs no more."""

HITS = 8.0
"""Edges of a border that are looked at, about: a border through a part of n edges has some √n."""

FAINT = 0.1
"""Jump that is one: surfaces that join smoothly differ by more."""

CLEAR = 0.9
"""Share of the edges at which there must be seen to be no jump: where the mesh is too coarse to
tell, nothing is said of the part."""


def unbroken_parts(
    mesh: Mesh, graph: FacetGraph, part: IntArray, joined: BoolArray, asked: BoolArray
) -> BoolArray:
    """Which parts have no border inside.

    Args:
        mesh: the mesh; nominal, see ``curvature_jumps``.
        graph: its adjacency.
        part: (m,) part of each facet, -1 for none.
        joined: (e,) pairs across which parts hang together.
        asked: (k,) parts to be asked about.

    Returns:
        (k,) bool.
    """
    asked = asked & (np.bincount(part[part >= 0], minlength=len(asked)) >= LEAST)
    out = np.zeros(len(asked), dtype=bool)
    if not asked.any():
        return out
    within = joined & (part[graph.pairs[:, 0]] == part[graph.pairs[:, 1]])
    within &= np.append(asked, False)[part[graph.pairs[:, 0]]]
    edges = np.flatnonzero(within)
    of_edge = part[graph.pairs[edges, 0]]
    edges = edges[np.argsort(of_edge, kind="stable")]
    count = np.bincount(of_edge, minlength=len(asked))
    taken = np.minimum(np.ceil(HITS * np.sqrt(count)), count).astype(np.int64)
    owner = np.repeat(np.arange(len(asked)), taken)
    slot = np.arange(len(owner)) - np.repeat(np.cumsum(taken) - taken, taken)
    start = np.cumsum(count) - count
    chosen = edges[start[owner] + slot * count[owner] // taken[owner]]
    jump, none = curvature_jumps(mesh, graph, chosen, within, FAINT)
    broken = np.bincount(owner, jump > FAINT, minlength=len(asked)) > 0
    clear = np.bincount(owner, none, minlength=len(asked))
    out[:] = asked & ~broken & (clear >= CLEAR * np.maximum(taken, 1))
    return out
