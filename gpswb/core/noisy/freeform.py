# SPDX-License-Identifier: LGPL-2.1-or-later
"""Freeform surfaces of noisy regions: overlapping cubics, as large as the noise lets them be."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

import numpy as np
from scipy.sparse import coo_matrix, csr_matrix
from scipy.sparse.csgraph import dijkstra
from scipy.spatial import cKDTree

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray, IntArray
from gpswb.core.noisy.least_cost import cheapest
from gpswb.core.noisy.noisy_mesh import NoisyMesh
from gpswb.core.reference import axis_frame

CELLS = (800, 560, 400, 280, 200, 140, 100, 70, 50, 35, 25)
"""Vertices of a cell that are tried, on average: the largest that a cubic describes are meant."""

PATIENCE = 3
"""Smaller cells in a row that may be for nothing."""

REACH = 0.5
"""Share of a cell's radius by which its cubic's vertices reach beyond it: it is there that
neighbouring cubics agree, so that the surface is smooth."""

POWERS = np.array([(i, j) for i in range(4) for j in range(4 - i)])
"""(10, 2) powers of the two tangents in the terms of a cubic."""

OUTSIDE = 4.0
"""Distance in sigma beyond which a vertex counts as if it were so far: it is a stray."""


@dataclass(frozen=True, eq=False)
class Freeform:
    """A freeform surface and how well it explains its vertices.

    Args:
        centre: (k, 3) mm middle of each cell.
        frame: (k, 3, 3) two tangents and the outward normal of each, as rows.
        radius: (k,) mm reach of each cubic.
        cubic: (k, 10) height over the tangents: coefficients of the terms.
        freedom: number of independent coefficients: cells overlap.
        chi: sum of the squared distances over sigma², each at most ``OUTSIDE``².
        count: number of vertices n.
    """

    centre: FloatArray
    frame: FloatArray
    radius: FloatArray
    cubic: FloatArray
    freedom: float
    chi: float
    count: int

    invariance_class: ClassVar[InvarianceClass] = "complex"
    side: ClassVar[float] = 1.0

    def price(self, count: int) -> float:
        """What the coefficients cost, in the unit of chi-square."""
        return self.freedom * float(np.log(max(count, 2)))

    @property
    def cost(self) -> float:
        """Chi-square and the price: smaller is likelier."""
        return self.chi + self.price(self.count)

    @cached_property
    def _tree(self) -> cKDTree:
        return cKDTree(self.centre)

    def distance(self, points: FloatArray) -> tuple[FloatArray, FloatArray]:
        """(n,) mm signed distances of points (n, 3), and (n, 3) unit normals of the surface there.

        Beyond the reach of the nearest cubic it is the distance to its rim.
        """
        _, cell = self._tree.query(points)
        frame = self.frame[cell]
        x, y, z = np.einsum("nik,nk->in", frame, points - self.centre[cell])
        height, slope = _height(self.cubic[cell], x, y, z)
        steep = np.linalg.norm(slope, axis=1)
        height = height / steep
        beyond = np.maximum(np.hypot(x, y) - self.radius[cell], 0.0)
        off = np.where(height < 0.0, -1.0, 1.0) * np.hypot(height, beyond)
        return off, np.einsum("nik,ni->nk", frame, slope / steep[:, None])


def fit_freeform(noisy: NoisyMesh, facets: IntArray) -> Freeform | None:
    """The likeliest freeform surface through some facets.

    Args:
        noisy: the mesh and its noise.
        facets: (k,) connected facets.

    Returns:
        None where there are too few vertices.
    """
    mesh = noisy.mesh
    vertices, local = np.unique(mesh.triangles[facets], return_inverse=True)
    local = local.reshape(-1, 3)
    n = len(vertices)
    row, col = local.ravel(), np.roll(local, -1, axis=1).ravel()
    edge = coo_matrix((np.ones(len(row)), (row, col)), shape=(n, n)).tocsr()
    edge = ((edge + edge.T) > 0).astype(np.float64)
    weighted = np.repeat(noisy.normals[facets] * mesh.areas[facets][:, None], 3, axis=0)
    normal = np.column_stack([np.bincount(row, weighted[:, i], n) for i in range(3)]).astype(
        np.float64
    )
    sizes = (size for size in CELLS if 2 * size <= 3 * n or size == CELLS[-1])
    points = mesh.vertices[vertices]
    return cheapest((_fitted(points, normal, edge, s, noisy.sigma) for s in sizes), PATIENCE)


def _fitted(
    points: FloatArray, normal: FloatArray, edge: csr_matrix, size: int, sigma: float
) -> Freeform:
    """Cubics of cells of about so many vertices."""
    n = len(points)
    cell, count = _cells(points, edge, max(round(n / size), 1))
    member = csr_matrix((np.ones(n), (cell, np.arange(n))), shape=(count, n))
    window = member
    for _ in range(max(round(REACH * np.sqrt(size / np.pi)), 1)):
        window = window + window @ edge
        window.data[:] = 1.0
    row, col = window.nonzero()
    number = np.maximum(np.asarray(window.sum(axis=1)).ravel(), 1.0)
    centre = (window @ points) / number[:, None]
    mean = window @ normal
    mean[np.linalg.norm(mean, axis=1) == 0.0] = [0.0, 0.0, 1.0]
    frame = np.array([axis_frame(direction) for direction in mean])
    x, y, z = np.einsum("nik,nk->in", frame[row], points[col] - centre[row])
    radius = np.zeros(count)
    np.maximum.at(radius, row, np.hypot(x, y))
    scale = np.maximum(radius, 1e-300)
    design = _terms(x / scale[row], y / scale[row])
    terms = design.shape[1]
    pairs = [design[:, i] * design[:, j] for i in range(terms) for j in range(terms)]
    gram = np.column_stack([np.bincount(row, p, count) for p in pairs])
    gram = gram.reshape(count, terms, terms)
    # The ridge keeps cells of few vertices solvable.
    gram += 1e-6 * number[:, None, None] * np.eye(terms)
    right = np.column_stack([np.bincount(row, design[:, i] * z, count) for i in range(terms)])
    inverse = np.linalg.inv(gram)
    cubic = np.einsum("kij,kj->ki", inverse, right) / scale[:, None] ** POWERS.sum(axis=1)
    own = cell[col] == row
    at, some = row[own], design[own]
    freedom = float(np.einsum("ni,nij,nj->", some, inverse[at], some))
    height, slope = _height(cubic[at], x[own], y[own], z[own])
    squares = height**2 / (slope**2).sum(axis=1) / sigma**2
    chi = float(np.minimum(squares, OUTSIDE**2).sum())
    return Freeform(centre, frame, radius, cubic, freedom, chi, n)


def _cells(points: FloatArray, edge: csr_matrix, count: int) -> tuple[IntArray, int]:
    """(n,) cell of each vertex, by the fewest edges to the cells' seeds, and how many they are.

    Seeds are random at first, then the vertices nearest to the cells' middles.
    """
    n = len(points)
    seed = np.random.default_rng(0).choice(n, count, replace=False)
    for step in range(2):
        _, _, source = dijkstra(
            edge, indices=seed, unweighted=True, min_only=True, return_predecessors=True
        )
        cell = np.searchsorted(np.sort(seed), np.where(source < 0, seed.min(), source))
        if step == 0:
            number = np.maximum(np.bincount(cell, minlength=count), 1)
            middle = np.column_stack(
                [np.bincount(cell, points[:, i], count) / number for i in range(3)]
            )
            off = ((points - middle[cell]) ** 2).sum(axis=1)
            order = np.lexsort((off, cell))
            first = np.flatnonzero(np.diff(cell[order], prepend=-1))
            seed = order[first]
            count = len(seed)
    return cell, count


def _terms(x: FloatArray, y: FloatArray) -> FloatArray:
    """(n, 10) terms of a cubic."""
    return np.column_stack([x**i * y**j for i, j in POWERS.tolist()])


def _height(
    cubic: FloatArray, x: FloatArray, y: FloatArray, z: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """(n,) z over a cubic (n, 10) each, and the gradient (n, 3) of that."""
    i, j = POWERS.T
    dx = i * x[:, None] ** np.maximum(i - 1, 0) * y[:, None] ** j
    dy = j * x[:, None] ** i * y[:, None] ** np.maximum(j - 1, 0)
    slope = [-(cubic * dx).sum(axis=1), -(cubic * dy).sum(axis=1), np.ones(len(x))]
    return z - (cubic * _terms(x, y)).sum(axis=1), np.column_stack(slope)
