# SPDX-License-Identifier: LGPL-2.1-or-later
"""A surface through a point cloud, grown triangle by triangle (Cohen-Steiner and Da 2004).

No library does this for FreeCAD's own Python, which has numpy and scipy only; the Delaunay
tetrahedra come from scipy.
"""

from __future__ import annotations

import heapq

import numpy as np

from gpswb.core.mesh import FloatArray, IntArray
from gpswb.scan.empty_spheres import EmptySpheres

SMOOTH = float(np.cos(np.radians(30.0)))
"""Cosine of the turn below which a triangle continues the surface: the smaller its sphere, the
sooner it comes (the published beta)."""

FOLDED = float(np.cos(np.radians(150.0)))
"""Cosine of the turn above which a triangle folds back on its neighbour (the published alpha)."""


def advance(points: FloatArray, candidates: EmptySpheres) -> IntArray:
    """Oriented triangles of a surface that interpolates the points.

    From the candidate with the smallest sphere the surface grows over its border edges. At each
    edge the candidate with the smallest sphere that doesn't fold back is taken; smooth
    continuations come first, by radius, then the others, by turn: flat faces are finished before
    an edge of the part is crossed. A triangle is refused where an edge would get a third triangle
    or a vertex would be closed twice. When the border is stuck a new seed is taken.

    Args:
        points: (n, 3), mm.
        candidates: triangles that may be used.

    Returns:
        (m, 3) int64; neighbours are oriented alike, at most two on an edge.
    """
    if not len(candidates.triangles):
        return np.zeros((0, 3), dtype=np.int64)
    front = _Front(points, candidates)
    for seed in np.argsort(candidates.radius, kind="stable").tolist():
        if front.start(seed):
            front.grow()
    return np.array(front.triangles, dtype=np.int64).reshape(-1, 3)


class _Front:
    """The surface so far: its border edges, and what may continue it at each."""

    def __init__(self, points: FloatArray, candidates: EmptySpheres) -> None:
        corner = candidates.triangles
        self.corner: list[list[int]] = corner.tolist()
        self.radius: list[float] = candidates.radius.tolist()
        p = points[corner]
        normal = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
        normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
        self.normal: list[list[float]] = normal.tolist()
        ends = corner[:, [[0, 1], [0, 2], [1, 2]]].reshape(-1, 2)
        order = np.lexsort((np.repeat(candidates.radius, 3), ends[:, 1], ends[:, 0]))
        facet = np.repeat(np.arange(len(corner)), 3)[order]
        ends = ends[order]
        start = np.flatnonzero(np.r_[True, (ends[1:] != ends[:-1]).any(axis=1)])
        groups = np.split(facet, start[1:])
        self.across: dict[tuple[int, int], list[int]] = {
            (u, v): group.tolist()
            for (u, v), group in zip(ends[start].tolist(), groups, strict=True)
        }
        # Directed edges of the surface: an edge is border while its reverse is missing.
        self.owner: dict[tuple[int, int], tuple[float, float, float]] = {}
        self.open = [0] * len(points)  # border edges that leave the vertex
        self.used = [False] * len(points)
        self.triangles: list[tuple[int, int, int]] = []
        self.queue: list[tuple[bool, float, int, int, int]] = []

    def start(self, facet: int) -> bool:
        """Lay a first triangle where no corner is used yet."""
        a, b, c = self.corner[facet]
        if self.used[a] or self.used[b] or self.used[c]:
            return False
        n = self.normal[facet]
        self._lay(a, b, c, (n[0], n[1], n[2]))
        return True

    def grow(self) -> None:
        """Continue over the border until nothing fits."""
        while self.queue:
            _, _, u, v, facet = heapq.heappop(self.queue)
            if not self._is_border(u, v):
                continue
            w = sum(self.corner[facet]) - u - v
            if self._fits(u, v, w):
                self._lay(v, u, w, self._oriented(facet, v, u))
            else:
                self._ask(u, v, after=facet)

    def _is_border(self, u: int, v: int) -> bool:
        return (u, v) in self.owner and (v, u) not in self.owner

    def _fits(self, u: int, v: int, w: int) -> bool:
        """May the triangle v, u, w be laid at the border edge u, v?"""
        if (u, w) in self.owner or (w, v) in self.owner:
            return False
        # A vertex inside the surface is closed.
        return not self.used[w] or self.open[w] > 0

    def _oriented(self, facet: int, u: int, v: int) -> tuple[float, float, float]:
        """Normal of a candidate when it is passed from u to v."""
        a, b, c = self.corner[facet]
        x, y, z = self.normal[facet]
        if (u, v) in ((a, b), (b, c), (c, a)):
            return x, y, z
        return -x, -y, -z

    def _lay(self, a: int, b: int, c: int, normal: tuple[float, float, float]) -> None:
        self.triangles.append((a, b, c))
        edges = ((a, b), (b, c), (c, a))
        for u, v in edges:
            self.used[u] = True
            self.owner[u, v] = normal
            if (v, u) in self.owner:
                self.open[v] -= 1
            else:
                self.open[u] += 1
        for u, v in edges:
            if (v, u) not in self.owner:
                self._ask(u, v, after=-1)

    def _ask(self, u: int, v: int, after: int) -> None:
        """Put the best candidate at a border edge in the queue; those up to ``after`` are done."""
        group = self.across.get((u, v) if u < v else (v, u), [])
        first = group.index(after) + 1 if after >= 0 else 0
        x, y, z = self.owner[u, v]
        for facet in group[first:]:
            p, q, r = self._oriented(facet, v, u)
            turn = x * p + y * q + z * r
            w = sum(self.corner[facet]) - u - v
            if turn > FOLDED and self._fits(u, v, w):
                key = self.radius[facet] if turn > SMOOTH else -turn
                heapq.heappush(self.queue, (turn <= SMOOTH, key, u, v, facet))
                return
