# SPDX-License-Identifier: LGPL-2.1-or-later
"""Refine a tessellation to a size rule, with every new vertex exactly on its surface or edge."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from gpswb.cad.flip import flip
from gpswb.cad.kernel import Shape
from gpswb.cad.sizing import Sizing, initial_spacing
from gpswb.cad.split import Sides, distinct_sides, split
from gpswb.cad.weld import Tessellation
from gpswb.core.mesh import BoolArray, FloatArray

_MAX_PASSES = 40


@dataclass(frozen=True)
class SizeRule:
    """What a side must not exceed.

    Args:
        max_length: mm.
        max_turn: angle between the exact normals at its two ends, rad.
        divisions: least number of sides across a curved face, in both parameters; 0 for none.
        graded: sides grow only gradually away from short ones (else the mesh is near-uniform).
        max_triangles: refinement stops here.
    """

    max_length: float
    max_turn: float = math.inf
    divisions: int = 0
    graded: bool = True
    max_triangles: int = 300_000


def refine(
    mesh: Tessellation,
    shape: Shape,
    rule: SizeRule,
    progress: Callable[[str, float], None] | None = None,
) -> tuple[Tessellation, bool]:
    """Split sides and flip diagonals until the rule holds.

    Returns:
        The refined tessellation, and whether the cap on triangles stopped it early.
    """
    sizing = Sizing(shape, rule.max_length, rule.max_turn, rule.divisions)
    spacing = initial_spacing(mesh, rule.max_length, rule.graded)
    mesh = flip(mesh)
    for step in range(_MAX_PASSES):
        sides = distinct_sides(mesh)
        length = mesh.side_lengths()
        size, detail = sizing(mesh, sides, length, spacing)
        marked = size > 1.0
        if not marked.any():
            return mesh, False
        room = rule.max_triangles - len(mesh.triangles)
        capped = int((marked * sides.count).sum()) > room
        if capped:
            marked = _worst(sides, marked, size, room)
        reach = length.ravel()[sides.first]
        spacing = _extend(mesh, sides, marked, reach, detail, spacing)
        mesh = flip(split(mesh, shape, sides, marked, reach), rounds=4)
        if capped:
            return flip(mesh), True
        if progress is not None:
            progress("tessellate", min(0.95, 1.0 - 0.8 ** (step + 1)))
    return mesh, False


def _worst(sides: Sides, marked: BoolArray, size: FloatArray, room: int) -> BoolArray:
    """The largest of the marked sides that fit in the room left."""
    order = np.argsort(np.where(marked, -size, np.inf), kind="stable")
    within = np.cumsum(sides.count[order]) <= room
    fewer = np.zeros_like(marked)
    fewer[order[within & marked[order]]] = True
    return fewer


def _extend(
    mesh: Tessellation,
    sides: Sides,
    marked: BoolArray,
    reach: FloatArray,
    detail: FloatArray,
    spacing: FloatArray,
) -> FloatArray:
    """Spacing of the new vertices: between those of the side's ends, or what detail asks for."""
    first = sides.first[marked]
    tail = mesh.triangles.ravel()[first]
    head = np.roll(mesh.triangles, -1, axis=1).ravel()[first]
    between = (spacing[tail] + spacing[head]) / 2
    wanted = reach[marked] / np.maximum(detail[marked], 1e-9)
    return np.concatenate([spacing, np.minimum(between, wanted)])
