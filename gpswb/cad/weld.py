# SPDX-License-Identifier: LGPL-2.1-or-later
"""Weld the faces' patches into one mesh along the edges that the B-rep shares."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from gpswb.cad.kernel import BrepFace, Patch
from gpswb.cad.surface import outward_normals
from gpswb.core.mesh import BoolArray, FloatArray, IntArray


@dataclass(frozen=True, eq=False)
class Tessellation:
    """A welded mesh which still knows, for each corner, where on its face it lies.

    Side ``k`` of a triangle runs from corner ``k`` to corner ``k+1``.

    Args:
        vertices: (n, 3) mm.
        triangles: (m, 3), no vertex twice in a triangle.
        face: (m,) face of each triangle.
        uv: (m, 3, 2) parameters of each corner on the triangle's face.
        normal: (m, 3, 3) exact outward normal of the triangle's face at each corner; 0 for a face
            without a surface.
        edge: (m, 3) B-rep edge that each side lies on, -1 inside a face.
        side: (m, 3) which pass of the edge (0, or 1 on the far side of a seam).
        ends: (m, 3, 2) edge parameters at both ends of each side; 0 inside a face.
        free: (m, 3) parameter without meaning at a corner (pole, apex): 1 is u, 2 is v; else 0.
    """

    vertices: FloatArray
    triangles: IntArray
    face: IntArray
    uv: FloatArray
    normal: FloatArray
    edge: IntArray
    side: IntArray
    ends: FloatArray
    free: IntArray

    def subset(self, keep: BoolArray) -> Tessellation:
        """The triangles where ``keep`` (m,) holds; the vertices stay all."""
        names = ("triangles", "face", "uv", "normal", "edge", "side", "ends", "free")
        return replace(self, **{name: getattr(self, name)[keep] for name in names})

    def side_lengths(self) -> FloatArray:
        """(m, 3) lengths of the sides, mm."""
        tail = self.vertices[self.triangles]
        length: FloatArray = np.linalg.norm(np.roll(tail, -1, axis=1) - tail, axis=2)
        return length


def weld(patches: Sequence[Patch], faces: Sequence[BrepFace]) -> Tessellation:
    """Make one mesh of all patches, one for each of the faces.

    Two nodes become one vertex when they are the same point of the same B-rep edge (a seam, a pole
    and the neighbour's side alike). Distance plays no part: two bodies that touch stay apart.
    Triangles that lose a side by it are dropped.
    """
    offset = np.cumsum([0, *(len(p.nodes) for p in patches)])
    label = _labels(patches, offset)
    _, first, vertex = np.unique(label, return_index=True, return_inverse=True)
    points = np.concatenate([p.nodes for p in patches]).reshape(-1, 3)
    uv = np.concatenate([p.uv for p in patches]).reshape(-1, 2)
    normal = np.concatenate(
        [
            outward_normals(f, p.uv) if _located(f, p) else np.zeros_like(p.nodes)
            for p, f in zip(patches, faces, strict=True)
        ]
    ).reshape(-1, 3)
    corner = np.concatenate([p.triangles + o for p, o in zip(patches, offset, strict=False)])
    face = np.repeat(np.arange(len(patches)), [len(p.triangles) for p in patches])
    triangles = vertex[corner]
    keep = (triangles != np.roll(triangles, -1, axis=1)).all(axis=1)
    corner = corner[keep]
    edge, side, ends = _sides(patches, offset, corner, vertex)
    return Tessellation(
        points[first],
        triangles[keep],
        face[keep],
        uv[corner],
        normal[corner],
        edge,
        side,
        ends,
        _free(patches, offset)[corner],
    )


def _located(face: BrepFace, patch: Patch) -> bool:
    return face.kind is not None and bool(np.isfinite(patch.uv).all())


def _labels(patches: Sequence[Patch], offset: IntArray) -> IntArray:
    leader: dict[int, IntArray] = {}
    pairs: list[IntArray] = []
    for patch, start in zip(patches, offset, strict=False):
        for rim in patch.rims:
            nodes = rim.nodes + start
            if rim.degenerate:
                pairs.append(np.column_stack([nodes[:-1], nodes[1:]]))
            other = leader.setdefault(rim.edge, nodes)
            if len(other) == len(nodes):
                pairs.append(np.column_stack([other, nodes]))
    total = int(offset[-1])
    joined = np.concatenate(pairs) if pairs else np.empty((0, 2), dtype=np.int64)
    graph = coo_matrix((np.ones(len(joined)), (joined[:, 0], joined[:, 1])), shape=(total, total))
    labels: IntArray = connected_components(graph, directed=False)[1].astype(np.int64)
    return labels


def _sides(
    patches: Sequence[Patch], offset: IntArray, corner: IntArray, vertex: IntArray
) -> tuple[IntArray, IntArray, FloatArray]:
    """For each side of each triangle the B-rep edge, its pass and the two edge parameters."""
    total = np.int64(max(int(offset[-1]), 1))
    key: list[IntArray] = []
    rows: list[FloatArray] = []
    leader: dict[int, FloatArray] = {}
    for patch, start in zip(patches, offset, strict=False):
        for rim in patch.rims:
            # Every face takes the parameters of the first one, so that midpoints agree to the bit.
            t = leader.setdefault(rim.edge, rim.parameters)
            if len(t) != len(rim.nodes):
                t = rim.parameters
            a, b = rim.nodes[:-1] + start, rim.nodes[1:] + start
            names = np.full(len(a), rim.edge), np.full(len(a), rim.side)
            key += [a * total + b, b * total + a]
            rows += [np.column_stack([*names, t[:-1], t[1:]])]
            rows += [np.column_stack([*names, t[1:], t[:-1]])]
    m = len(corner)
    edge = np.full((m, 3), -1, dtype=np.int64)
    side, ends = np.zeros((m, 3), dtype=np.int64), np.zeros((m, 3, 2))
    if not key or not m:
        return edge, side, ends
    keys, table = np.concatenate(key), np.concatenate(rows)
    order = np.argsort(keys, kind="stable")
    wanted = corner * total + np.roll(corner, -1, axis=1)
    at = np.minimum(np.searchsorted(keys, wanted, sorter=order), len(keys) - 1)
    found = keys[order[at]] == wanted
    _add_poles(keys, wanted, found, order, at, offset, vertex)
    hit = table[order[at[found]]]
    edge[found], side[found] = hit[:, 0].astype(np.int64), hit[:, 1].astype(np.int64)
    ends[found] = hit[:, 2:]
    return edge, side, ends


def _add_poles(
    keys: IntArray,
    wanted: IntArray,
    found: BoolArray,
    order: IntArray,
    at: IntArray,
    offset: IntArray,
    vertex: IntArray,
) -> None:
    """Find also border sides that end in another copy of the edge's node: a pole has several, and
    the triangle between two of them and the edge is gone."""
    total = np.int64(max(int(offset[-1]), 1))
    twin = wanted % total * total + wanted // total
    border = ~np.isin(twin, wanted)
    if not (border & ~found).any():
        return
    left = np.setdiff1d(np.arange(len(keys)), order[at[found]])
    rank = np.empty(len(keys), dtype=np.int64)
    rank[order] = np.arange(len(keys))
    here = {
        (_patch(keys[i] // total, offset), vertex[keys[i] // total], vertex[keys[i] % total]): i
        for i in left.tolist()
    }
    for row, k in np.argwhere(border & ~found).tolist():
        a, b = wanted[row, k] // total, wanted[row, k] % total
        i = here.get((_patch(a, offset), vertex[a], vertex[b]))
        if i is not None:
            at[row, k], found[row, k] = rank[i], True


def _patch(node: int, offset: IntArray) -> int:
    return int(np.searchsorted(offset, node, side="right"))


def _free(patches: Sequence[Patch], offset: IntArray) -> IntArray:
    free = np.zeros(int(offset[-1]), dtype=np.int64)
    for patch, start in zip(patches, offset, strict=False):
        for rim in patch.rims:
            if rim.degenerate:
                spread = np.ptp(patch.uv[rim.nodes], axis=0)
                free[rim.nodes + start] = 1 if spread[0] >= spread[1] else 2
    return free
