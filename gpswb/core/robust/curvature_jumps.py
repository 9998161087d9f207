# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far curvature jumps across the edges of a smooth mesh: where faces join without a crease."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.robust.patches import rings_of, vertices_of_rows
from gpswb.core.robust.topology import FacetGraph

RINGS = 4
"""Steps from an edge to the facets whose vertices are fitted: some thirty for eleven unknowns."""

SPARE = 3
"""Vertices beyond the unknowns, below which nothing is said of an edge."""

BORDER = 0.35
"""Mean of a border's jumps from which there are two faces: B-spline faces, too, have lines inside
along which curvature jumps, by less than a third in those that were seen."""

SURE = 3.0
"""Standard errors that are taken off a jump."""

FADE = 1.5
"""Vertices at the rim of the stencil weigh exp(-FADE) of those at the edge: enough to fix the
cubic, too little for a second border there to pass for a jump here."""

FLATTEST = 1e-3
"""Least curvature that a jump is compared with, as share of 1 / diagonal: a chord across the whole
part would be 1e-4 of it off such a surface, and less is not bent."""

RIDGE = 1e-10
"""Added to the normal equations, in units of a vertex: a term that the vertices leave open stays
finite, and its standard error large."""

BLOCK = 512
"""Edges fitted together: as many as the cache holds."""


def curvature_jumps(
    mesh: Mesh, graph: FacetGraph, edges: IntArray, joined: BoolArray, border: float = BORDER
) -> tuple[FloatArray, BoolArray]:
    """Relative jump of the normal curvature across edges.

    Two surfaces that join smoothly have the same curvatures along their common border and in its
    mixed term; only that across it can jump. In a frame at the edge, with s across and t along
    it, the mesh's vertices are fitted by a full cubic in (s, t) and one term max(s, 0)².

    Args:
        mesh: the mesh; its vertices lie on their surfaces to rounding.
        graph: its adjacency.
        edges: (k,) numbers of interior edges, as in ``graph.pairs``.
        joined: (e,) pairs of facets that hang together: neighbourhoods don't cross other edges.
        border: least jump that is one.

    Returns:
        (k,) the jump, less what the fit leaves open, over the largest curvature on either side,
        and (k,) whether it is seen to be none: less than ``border`` by a standard error.
    """
    passable = graph.sides(np.flatnonzero(joined))
    jump, none = np.zeros(len(edges)), np.zeros(len(edges), dtype=bool)
    for start in range(0, len(edges), BLOCK):
        some = slice(start, start + BLOCK)
        jump[some], none[some] = _jumps(mesh, graph, edges[some], passable, border)
    return jump, none


def _jumps(
    mesh: Mesh, graph: FacetGraph, edges: IntArray, passable: BoolArray, border: float
) -> tuple[FloatArray, BoolArray]:
    facets = rings_of(graph, graph.pairs[edges], lambda f: passable[f], RINGS)
    vertices = vertices_of_rows(mesh, facets)
    present = vertices >= 0
    ends = mesh.vertices[graph.pair_edges[edges]]
    along = _unit(ends[:, 1] - ends[:, 0])
    normal = mesh.facet_normals[graph.pairs[edges]].sum(axis=1)
    normal = _unit(normal - np.einsum("ek,ek->e", normal, along)[:, None] * along)
    x = (mesh.vertices[np.maximum(vertices, 0)] - ends.mean(axis=1)[:, None]) * present[..., None]
    s, t, h = (np.einsum("enk,ek->en", x, a) for a in (np.cross(normal, along), along, normal))
    size_s, size_t, size_h = (np.maximum(np.abs(q).max(axis=1), 1e-300) for q in (s, t, h))
    s, t, h = s / size_s[:, None], t / size_t[:, None], h / size_h[:, None]
    weight = present * np.exp(-FADE * (s * s + t * t))
    beyond = np.maximum(s, 0.0)
    rows = np.empty((len(edges), 11, s.shape[1]))
    rows[:, 0] = weight
    np.multiply(weight, s, out=rows[:, 1])
    np.multiply(weight, t, out=rows[:, 2])
    for term, (first, second) in enumerate(
        ((1, s), (1, t), (2, t), (3, s), (3, t), (5, s), (5, t)), start=3
    ):
        np.multiply(rows[:, first], second, out=rows[:, term])
    np.multiply(weight, beyond * beyond, out=rows[:, 10])
    unknowns = rows.shape[1]
    matrix = rows @ np.swapaxes(rows, 1, 2)
    count = present.sum(axis=1)
    matrix[:, range(unknowns), range(unknowns)] += RIDGE * count[:, None]
    goal = (h * weight)[..., None]
    # The coefficients, and the last column of the inverse.
    last = np.broadcast_to(np.eye(unknowns)[:, -1:], (len(edges), unknowns, 1))
    solved = np.linalg.solve(matrix, np.concatenate([rows @ goal, last], axis=2))
    c = solved[..., 0]
    left = (c[:, None] @ rows)[:, 0] - goal[..., 0]
    variance = (left**2).sum(axis=1) / np.maximum(count - unknowns, 1)
    second = 2.0 * size_h / size_s**2
    jump = np.abs(c[:, 10]) * second
    open_ = np.sqrt(variance * np.maximum(solved[:, 10, 1], 0.0)) * second
    across, mixed = c[:, 3] * second, c[:, 4] * size_h / (size_s * size_t)
    other = 2.0 * c[:, 5] * size_h / size_t**2
    curvature = np.maximum(
        _largest(across, mixed, other), _largest(across + c[:, 10] * second, mixed, other)
    )
    curvature = np.maximum(curvature, FLATTEST / mesh.diagonal)
    enough = count >= unknowns + SPARE
    least = np.where(enough, np.maximum(jump - SURE * open_, 0.0) / curvature, 0.0)
    return least, enough & (jump + open_ < border * curvature)


def _largest(a: FloatArray, b: FloatArray, c: FloatArray) -> FloatArray:
    """(k,) largest principal curvature, by magnitude, of ((a, b), (b, c))."""
    largest: FloatArray = np.abs(a + c) / 2.0 + np.hypot((a - c) / 2.0, b)
    return largest


def _unit(v: FloatArray) -> FloatArray:
    unit: FloatArray = v / np.maximum(np.linalg.norm(v, axis=1), 1e-300)[:, None]
    return unit
