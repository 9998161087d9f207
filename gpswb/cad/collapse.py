# SPDX-License-Identifier: LGPL-2.1-or-later
"""Take vertices out that make triangles lie wrong: an edge collapse inside one face.

A vertex inserted before the border next to it was fine enough may lie outside the face, and where
vertices crowd on a sharply curved place a triangle may stand across the surface. Flips can't mend
that; without the vertex there is nothing to mend (Hoppe et al., Mesh optimization, SIGGRAPH 1993,
section 4.1, for the collapse and its link condition).
"""

from __future__ import annotations

from collections import defaultdict
from dataclasses import replace

import numpy as np

from gpswb.cad.flip import LEAST_COSINE, chart_area, upward
from gpswb.cad.weld import Tessellation
from gpswb.core.mesh import BoolArray, FloatArray

_NEEDLE = 1e-5
"""Quality (1 equilateral) of a triangle that is as good as flat: its normal is noise."""
_ROUNDS = 8
_RING = ("triangles", "face", "uv", "normal", "edge", "side", "ends", "free")


def quality(mesh: Tessellation, up: FloatArray) -> FloatArray:
    """(m,) shape of each triangle, 1 equilateral and 0 flat, times the cosine between its normal
    and the exact one; negative also where it is turned over in parameter space (``up`` (m,) from
    `flip.upward`). Triangles without parameters or normals count as good."""
    corner = mesh.vertices[mesh.triangles]
    along = np.roll(corner, -1, axis=1) - corner
    cross = np.cross(along[:, 0], along[:, 1])
    size = np.linalg.norm(cross, axis=1)
    shape = 2 * np.sqrt(3.0) * size / np.maximum(np.einsum("ijk,ijk->i", along, along), 1e-300)
    normal = mesh.normal.sum(axis=1)
    scale = np.maximum(size * np.linalg.norm(normal, axis=1), 1e-300)
    cosine = np.einsum("ij,ij->i", cross, normal) / scale
    known = (normal != 0).any(axis=1) & ~np.isnan(mesh.uv).any(axis=(1, 2))
    area = np.where(known, chart_area(mesh.uv, mesh.free), 1.0) * up
    good = shape * cosine
    bad = np.where((area > 0) & (cosine > LEAST_COSINE), good, np.minimum(good, 0.0) - 1.0)
    return np.where(known, bad, 1.0)


def collapse(mesh: Tessellation) -> Tessellation:
    """Collapse vertices inside faces into a neighbour as long as that mends a bad triangle and
    makes none. The vertices stay in the table, unused."""
    up = upward(mesh)
    for _ in range(_ROUNDS):
        bad = quality(mesh, up) < _NEEDLE
        if not bad.any():
            break
        mesh, up, done = _round(mesh, up, bad)
        if not done:
            break
    return mesh


def _round(
    mesh: Tessellation, up: FloatArray, bad: BoolArray
) -> tuple[Tessellation, FloatArray, int]:
    fixed = np.zeros(len(mesh.vertices), dtype=bool)
    rim = mesh.edge >= 0
    for end in (mesh.triangles, np.roll(mesh.triangles, -1, axis=1)):
        fixed[end[rim]] = True
    fixed[mesh.triangles[mesh.free > 0]] = True
    movable = np.unique(mesh.triangles[bad])
    movable = movable[~fixed[movable]]
    touched = np.zeros(len(mesh.vertices), dtype=bool)
    touched[movable] = True
    rings: defaultdict[int, list[int]] = defaultdict(list)
    for row in np.flatnonzero(touched[mesh.triangles].any(axis=1)).tolist():
        for vertex in mesh.triangles[row].tolist():
            rings[vertex].append(row)
    out = {name: getattr(mesh, name).copy() for name in _RING}
    gone, busy = np.zeros(len(mesh.triangles), dtype=bool), np.zeros(len(mesh.triangles), bool)
    for vertex in movable.tolist():
        ring = np.array(rings[vertex])
        best = None if busy[ring].any() else _best(mesh, up, ring, vertex)
        if best is None:
            continue
        rows, part, target = best
        behind = np.flatnonzero((mesh.triangles == target).any(axis=1))
        # Link condition: a third vertex joined to both would get a second side to the target.
        if busy[behind].any() or _links(mesh, ring, behind, vertex, target) != 2:
            continue
        for name in _RING:
            out[name][rows] = getattr(part, name)
        gone[np.setdiff1d(ring, rows)] = True
        busy[ring] = busy[behind] = True
    merged = replace(mesh, **{name: array[~gone] for name, array in out.items()})
    return merged, up[~gone], int(gone.sum())


def _best(
    mesh: Tessellation, up: FloatArray, ring: np.ndarray, vertex: int
) -> tuple[np.ndarray, Tessellation, int] | None:
    """The collapse of ``vertex`` that leaves the best triangles of its ``ring``; None where none
    leaves fewer bad ones."""
    here = replace(mesh, **{name: getattr(mesh, name)[ring] for name in _RING})
    best, measure = None, _measure(here, up[ring])
    for target in np.unique(here.triangles).tolist():
        if target == vertex:
            continue
        both = (here.triangles == target).any(axis=1)
        if both.sum() != 2 or both.all():
            continue
        part = _moved(here, both, vertex, target)
        now = _measure(part, up[ring[~both]])
        if now[0] < measure[0] or (best is not None and now < measure):
            best, measure = (ring[~both], part, target), now
    return best


def _links(
    mesh: Tessellation, ring: np.ndarray, behind: np.ndarray, vertex: int, target: int
) -> int:
    """Number of vertices that are joined to both."""
    common = np.intersect1d(mesh.triangles[ring], mesh.triangles[behind])
    return len(np.setdiff1d(common, [vertex, target]))


def _measure(mesh: Tessellation, up: FloatArray) -> tuple[int, float]:
    """Number of bad triangles, and the worst of all with its sign turned: less is better."""
    found = quality(mesh, up)
    return int((found < _NEEDLE).sum()), -float(found.min())


def _moved(here: Tessellation, both: BoolArray, vertex: int, target: int) -> Tessellation:
    """The ring without the two triangles at the side between ``vertex`` and ``target``, all others
    with ``target`` for ``vertex``."""
    out = {name: getattr(here, name)[~both].copy() for name in _RING}
    at = out["triangles"] == vertex
    row = int(np.flatnonzero(both)[0])
    k = int(np.flatnonzero(here.triangles[row] == target)[0])
    out["triangles"][at] = target
    for name in ("uv", "normal", "free"):
        out[name][at] = getattr(here, name)[row, k]
    # A lost triangle's side opposite the vertex becomes a side of the triangle behind it.
    tail, head = out["triangles"], np.roll(out["triangles"], -1, axis=1)
    for row in np.flatnonzero(both).tolist():
        j = (int(np.flatnonzero(here.triangles[row] == vertex)[0]) + 1) % 3
        a, b = here.triangles[row, j], here.triangles[row, (j + 1) % 3]
        same = (tail == a) & (head == b)
        for name in ("edge", "side", "ends"):
            out[name][same] = getattr(here, name)[row, j]
    return replace(here, **out)
