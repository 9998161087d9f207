# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stray facets that no surface explains, given to the surface around them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gpswb.core.mesh import IntArray
from gpswb.core.noisy.models import Surface
from gpswb.core.noisy.noisy_mesh import NoisyMesh

FEW = 30
"""Facets that may be unexplained together by chance: a vertex that is off by four sigma spoils the
six facets around it."""


def absorb(noisy: NoisyMesh, models: Sequence[Surface], label: IntArray) -> IntArray:
    """Give small groups of unexplained facets, from the rim inwards, to the nearest neighbour.

    Args:
        noisy: the mesh and its noise.
        models: the surfaces.
        label: (m,) the number of each facet's surface, -1 for none.
    """
    label = label.copy()
    graph = noisy.graph
    unexplained = label < 0
    part = graph.components(np.logical_and(*unexplained[graph.pairs].T), len(label))
    todo = unexplained & (np.bincount(part, minlength=len(label))[part] <= FEW)
    facet = np.concatenate([graph.pairs[:, 0], graph.pairs[:, 1]])
    other = np.concatenate([graph.pairs[:, 1], graph.pairs[:, 0]])
    while True:
        rim = todo[facet] & (label[other] >= 0)
        if not rim.any():
            return label
        best = np.full(len(label), np.inf)
        taken = label.copy()
        for i in np.unique(label[other[rim]]):
            at = np.unique(facet[rim & (label[other] == i)])
            corners = noisy.mesh.corners[at].reshape(-1, 3)
            d = models[i].distance(corners)[0].reshape(-1, 3)
            cost = (d**2).sum(axis=1)
            nearer = cost < best[at]
            best[at[nearer]] = cost[nearer]
            taken[at[nearer]] = i
        label = taken
        todo &= label < 0
