# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facets labelled by the surfaces they lie on, with short borders: expansion moves by graph cuts.

The energy is that of Isack and Boykov ("Energy-based geometric multi-model fitting", 2012): for
each facet the squared distances of its corners in sigma², for each pair of neighbours with
different labels a price. One expansion move lets one label take any facets at once, and a minimum
cut finds the best such move (Boykov, Veksler, Zabih, 2001).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gpswb.core.mesh import BoolArray, FloatArray, IntArray
from gpswb.core.noisy.best_move import best_move
from gpswb.core.noisy.models import Surface
from gpswb.core.noisy.noisy_mesh import NoisyMesh
from gpswb.core.robust.topology import FacetGraph

BORDER = 1.0
"""Price of a border along one edge, in nats, where the surface is smooth."""

CREASED = 0.25
"""Share of that price that remains at a crease."""

CREASE_TURN = 0.35
"""Turn (rad) of the denoised normals at which two thirds of what a crease saves are saved."""

JUMP = 4.0
"""Factor by which that price grows where tangent surfaces are a sigma apart: where they meet they
are known to about a third of a sigma, and to be off by that is unlikely by half a nat."""

PARALLEL = 0.8
"""Cosine from which surfaces count as tangent to some degree."""

OUTSIDE = 4.0
"""Distance in sigma at which a vertex can't get less likely: it is not of this surface."""

TILT = 1.0
"""Angle (rad) of a denoised normal to the surface, besides the error that noise may leave in it,
from which a facet is not of this surface."""

REACH = 6
"""Facets beyond its border that a label may take in one move."""


def facet_costs(noisy: NoisyMesh, model: Surface, facets: IntArray) -> FloatArray:
    """(k,) nats for facets to lie on a surface.

    A vertex has about two facets of its own: a facet carries half of its corners' mean, so that the
    sum over facets is the vertices' log-likelihood.
    """
    return _placed(noisy, model, facets).cost


@dataclass(frozen=True, eq=False)
class _Placed:
    """Facets seen from one surface each.

    Args:
        cost: (k,) nats for each to lie on it.
        height: (k, 3) signed distances of the corners, in sigma, outside positive.
        normal: (k, 3) outward normal of the surface there; 0 where the facet has no surface.
    """

    cost: FloatArray
    height: FloatArray
    normal: FloatArray

    def take(self, rows: IntArray | BoolArray) -> _Placed:
        """Some of them."""
        return _Placed(self.cost[rows], self.height[rows], self.normal[rows])

    def put(self, rows: IntArray, other: _Placed) -> None:
        """Replace some of them."""
        self.cost[rows] = other.cost
        self.height[rows] = other.height
        self.normal[rows] = other.normal


def _placed(noisy: NoisyMesh, model: Surface, facets: IntArray) -> _Placed:
    mesh = noisy.mesh
    # Facets share corners: each vertex is measured once.
    vertices, corner = np.unique(mesh.triangles[facets], return_inverse=True)
    d = (model.distance(mesh.vertices[vertices])[0] / noisy.sigma)[corner.reshape(-1, 3)]
    cost = 0.25 * np.minimum(d**2, OUTSIDE**2).mean(axis=1)
    toward = model.side * model.distance(mesh.centroids[facets])[1]
    cosine = np.einsum("ik,ik->i", toward, noisy.normals[facets])
    cost[cosine < np.cos(TILT + noisy.normal_error[facets])] = 0.25 * OUTSIDE**2
    return _Placed(cost, model.side * d, toward)


def _jump(mine: _Placed, other: _Placed) -> FloatArray:
    """(k,) how much more a border costs where two surfaces that are nearly parallel lie apart.

    Faces meet: the border of two tangent surfaces is where they touch. Both distances are of the
    same vertices, so that their difference is free of noise.
    """
    gap = np.abs(mine.height - other.height).min(axis=1)
    cosine = np.einsum("ik,ik->i", mine.normal, other.normal)
    parallel = np.clip((cosine - PARALLEL) / (1.0 - PARALLEL), 0.0, 1.0)
    jump: FloatArray = JUMP * np.minimum(gap, 2.0) ** 2 * parallel
    return jump


def border_prices(noisy: NoisyMesh) -> FloatArray:
    """(e,) price of a border along each interior edge, nats."""
    mesh = noisy.mesh
    a, b = noisy.graph.pairs.T
    ends = mesh.vertices[noisy.graph.pair_edges]
    length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    size = np.sqrt(mesh.areas[a] + mesh.areas[b])
    relative = np.minimum(length / np.maximum(size, 1e-300), 3.0)
    smooth = np.exp(-((noisy.pair_turn / CREASE_TURN) ** 2))
    price: FloatArray = BORDER * relative * (CREASED + (1.0 - CREASED) * smooth)
    return price


def expand(
    noisy: NoisyMesh, models: Sequence[Surface], label: IntArray, sweeps: int = 2
) -> IntArray:
    """Label facets anew by expansion moves of every model.

    Args:
        noisy: the mesh and its noise.
        models: the surfaces.
        label: (m,) the number of each facet's model, -1 for none.
        sweeps: rounds over all models.
    """
    label = label.copy()
    graph = noisy.graph
    price = border_prices(noisy)
    m = len(label)
    own = _Placed(np.full(m, 0.25 * OUTSIDE**2), np.zeros((m, 3)), np.zeros((m, 3)))
    order = np.argsort(label, kind="stable")
    bounds = np.searchsorted(label[order], np.arange(len(models) + 1))
    for i, model in enumerate(models):
        facets = order[bounds[i] : bounds[i + 1]]
        if len(facets):
            own.put(facets, _placed(noisy, model, facets))
    for _ in range(sweeps):
        changed = 0
        for i, model in enumerate(models):
            inside = np.flatnonzero(label == i)
            if not len(inside):
                continue
            active = _ring(graph, inside, m)
            placed = _placed(noisy, model, active)
            # What is as unlikely as can be isn't taken, however short the border gets.
            possible = placed.cost < 0.25 * OUTSIDE**2
            active, placed = active[possible], placed.take(possible)
            if not len(active):
                continue
            before = own.take(active)
            jump = 1.0 + _jump(before, placed)
            taken = best_move(graph.pairs, price, label, i, active, before.cost, placed.cost, jump)
            label[active[taken]] = i
            own.put(active[taken], placed.take(taken))
            changed += int(taken.sum())
        if changed < 0.001 * len(label):
            break
    return label


def _ring(graph: FacetGraph, inside: IntArray, m: int) -> IntArray:
    """Facets, of m, within reach of a region that are not of it."""
    seen = np.zeros(m, dtype=bool)
    seen[inside] = True
    front, found = inside, []
    for _ in range(REACH):
        step = graph.neighbour[front].ravel()
        step = np.unique(step[step >= 0])
        step = step[~seen[step]]
        seen[step] = True
        found.append(step)
        front = step
    return np.concatenate(found)
