# SPDX-License-Identifier: LGPL-2.1-or-later
"""Refine a tessellation to a size rule, with every new vertex exactly on its surface or edge."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from gpswb.cad.collapse import collapse
from gpswb.cad.flip import chart_area, flip, upward
from gpswb.cad.kernel import Shape
from gpswb.cad.locate import locate
from gpswb.cad.sizing import SizeRule, Sizing
from gpswb.cad.smooth import smooth
from gpswb.cad.split import Sides, distinct_sides, rim_middles, split
from gpswb.cad.weld import Tessellation
from gpswb.core.mesh import BoolArray, FloatArray

_MAX_PASSES = 40
_DEEP = 0.8
"""How far a border bends into a triangle, as a fraction of its height, before it may cross it."""


def refine(
    mesh: Tessellation,
    shape: Shape,
    rule: SizeRule,
    progress: Callable[[str, float], None] | None = None,
) -> tuple[Tessellation, bool]:
    """Split sides and flip diagonals until the rule holds, then even out the vertices inside faces.

    Returns:
        The refined tessellation, and whether the cap on triangles stopped it early.
    """
    mesh = flip(locate(mesh, shape))
    sizing = Sizing(shape, rule, mesh)
    capped = False
    for step in range(_MAX_PASSES):
        sides = distinct_sides(mesh)
        length = mesh.side_lengths()
        size = sizing(mesh, sides, length)
        marked = size > 1.0
        if capped or not marked.any():
            break
        middle = rim_middles(mesh, shape, sides, marked)
        marked = _apart(sides, marked & ~_crossed(mesh, sides, middle), size)
        room = rule.max_triangles - len(mesh.triangles)
        capped = int((marked * sides.count).sum()) > room
        if capped:
            marked = _worst(sides, marked, size, room)
        kept = int((~marked[sides.number].any(axis=1)).sum())
        mesh = split(mesh, shape, sides, marked, length.ravel()[sides.first], middle)
        # Split keeps the untouched triangles first.
        mesh = flip(mesh, np.arange(len(mesh.triangles)) >= kept, rounds=6)
        if (chart_area(mesh.uv, mesh.free) * upward(mesh) < 0).any():
            mesh = collapse(mesh)
        if progress is not None:
            progress("tessellate", min(0.9, 1.0 - 0.8 ** (step + 1)))
    return collapse(flip(smooth(collapse(flip(mesh)), shape))), capped


def _crossed(mesh: Tessellation, sides: Sides, middle: FloatArray) -> BoolArray:
    """(s,) sides inside faces that the border may cross when it is split at ``middle`` (s, 3).

    Where the border bends into a triangle by a good part of its height, sides around may lie
    outside the face, and so would their middles. They wait; the border comes first.
    """
    corner = mesh.vertices[mesh.triangles]
    along = np.roll(corner, -1, axis=1) - corner
    inward = np.roll(corner, -2, axis=1) - corner
    square = np.maximum(np.einsum("ijk,ijk->ij", along, along), 1e-300)
    inward -= (np.einsum("ijk,ijk->ij", inward, along) / square)[..., None] * along
    height2 = np.einsum("ijk,ijk->ij", inward, inward)
    bend = np.einsum("ijk,ijk->ij", middle[sides.number] - corner - along / 2, inward)
    deep = bend > _DEEP * height2  # False where the middle is nan: no border, or not split
    near = np.zeros(len(mesh.vertices), dtype=bool)
    near[mesh.triangles[deep.any(axis=1)]] = True
    inside = mesh.edge.ravel()[sides.first] < 0
    tail = mesh.triangles.ravel()[sides.first]
    head = np.roll(mesh.triangles, -1, axis=1).ravel()[sides.first]
    crossed: BoolArray = inside & (near[tail] | near[head])
    return crossed


def _apart(sides: Sides, marked: BoolArray, size: FloatArray) -> BoolArray:
    """Leave out marked sides whose new vertices would come too close to others.

    The middles of two sides of a triangle are half the third side apart: where that one isn't
    marked, both would be closer than the rule asks for, and a strip of slivers would double its
    width in vertices with every pass. The largest sides win; the others wait for the next pass.
    """
    mine = marked[sides.number]
    two = mine.sum(axis=1) == 2
    pairs = sides.number[two][mine[two]].reshape(-1, 2)
    rank = np.empty(len(size), dtype=np.int64)
    rank[np.argsort(size, kind="stable")] = np.arange(len(size))
    open_, chosen = marked.copy(), np.zeros_like(marked)
    while open_.any():
        a, b = pairs[open_[pairs].all(axis=1)].T
        rival = np.full(len(size), -1, dtype=np.int64)
        np.maximum.at(rival, a, rank[b])
        np.maximum.at(rival, b, rank[a])
        winners = open_ & (rank > rival)
        chosen |= winners
        open_ &= ~winners
        beaten = winners[pairs]
        open_[pairs[beaten[:, ::-1]]] = False
    return chosen


def _worst(sides: Sides, marked: BoolArray, size: FloatArray, room: int) -> BoolArray:
    """The largest of the marked sides that fit in the room left."""
    order = np.argsort(np.where(marked, -size, np.inf), kind="stable")
    within = np.cumsum(sides.count[order]) <= room
    fewer = np.zeros_like(marked)
    fewer[order[within & marked[order]]] = True
    return fewer
