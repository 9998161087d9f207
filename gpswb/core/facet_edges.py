# SPDX-License-Identifier: LGPL-2.1-or-later
"""Interior edges: at which half-edges they lie (see `half_edges`), and how long they are."""

from __future__ import annotations

import numpy as np

from gpswb.core.blocks import blocks
from gpswb.core.facet_geometry import dot
from gpswb.core.mesh import FloatArray, IntArray, Mesh


def edges_of_sides(mesh: Mesh) -> IntArray:
    """(3 m,) row of ``mesh.facet_pairs`` of each half-edge; -1 where it is no interior edge."""
    edge_of = np.full(3 * len(mesh.triangles), -1, dtype=np.int64)
    for half in mesh.half_edge_pairs.T:
        edge_of[half] = np.arange(len(half))
    return edge_of


def at_sides(mesh: Mesh, values: FloatArray) -> FloatArray:
    """(m, 3) values (e,) of interior edges at the sides of facets, 0 at other sides."""
    sides = np.zeros(3 * len(mesh.triangles))
    for half in mesh.half_edge_pairs.T:
        sides[half] = values
    return sides.reshape(-1, 3)


def sides_across(mesh: Mesh, sides: IntArray, edge_of: IntArray) -> IntArray:
    """(k,) half-edge of the neighbouring facet on the same edge; -1 where there is none.

    Args:
        mesh: the mesh.
        sides: (k,) half-edges.
        edge_of: (3 m,) see `edges_of_sides`.
    """
    edge = edge_of[sides]
    first, second = mesh.half_edge_pairs[edge].T
    return np.where(edge >= 0, first + second - sides, -1)


def edge_lengths(mesh: Mesh, edges: IntArray | slice = slice(None)) -> FloatArray:
    """(e,) lengths of all interior edges, or of some, mm."""
    # A slice costs nothing; what numbers choose is copied, and so block by block.
    ends = mesh.pair_edges[edges] if isinstance(edges, slice) else mesh.pair_edges
    lengths = np.empty(len(ends) if isinstance(edges, slice) else len(edges))
    for part in blocks(len(lengths)):
        chosen = ends[part if isinstance(edges, slice) else edges[part]]
        end = mesh.columns.take(chosen.T, axis=1)
        side = end[:, 1] - end[:, 0]
        lengths[part] = np.sqrt(dot(side, side))
    return lengths


def side_lengths(mesh: Mesh) -> FloatArray:
    """(m, 3) length of each side of each facet, from corner k to the next, mm."""
    lengths = np.empty((len(mesh.triangles), 3))
    for part in blocks(len(lengths)):
        corner = mesh.columns.take(mesh.triangles[part].T, axis=1)
        side = corner[:, [1, 2, 0]] - corner
        lengths[part] = np.sqrt(dot(side, side)).T
    return lengths


def heights_across(mesh: Mesh, normals: FloatArray, part: slice | IntArray) -> FloatArray:
    """How far the two facets of an edge stand off each other's planes, block by block.

    Args:
        mesh: the mesh.
        normals: (3, m) facet normals, axis by axis.
        part: rows of ``mesh.facet_pairs``.

    Returns:
        (2, k) mm: distance of the second facet's free vertex from the first facet's plane, and the
        other way round.
    """
    pairs, ends = mesh.facet_pairs[part].T, mesh.pair_edges[part].T
    start = mesh.columns.take(ends[0], axis=1)
    # The vertex of either facet that isn't on their edge.
    apex = mesh.triangles.take(pairs, axis=0).sum(axis=2) - ends.sum(axis=0)
    toward = mesh.columns.take(apex[::-1], axis=1) - start[:, None]
    height: FloatArray = np.abs(dot(normals.take(pairs, axis=1), toward))
    return height
