# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions that go on in one another without a jump of curvature, and have one symmetry together."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from gpswb.core.initial import InitialPartition
from gpswb.core.invariance import InvarianceClass
from gpswb.core.merging import merge_regions
from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.robust.leftover import classes_of
from gpswb.core.robust.seen_borders import SEEN, SeenBorders
from gpswb.core.robust.topology import FacetGraph
from gpswb.core.tolerances import Tolerances


def join_faces(
    mesh: Mesh,
    graph: FacetGraph,
    first: InitialPartition,
    label: IntArray,
    known: Mapping[int, InvarianceClass],
    sure: BoolArray,
    sigma: float,
    tolerances: Tolerances,
) -> IntArray:
    """Join neighbours that have one symmetry together.

    A face is found in pieces where none of them was known exactly. Between faces that join
    smoothly curvature jumps; between the pieces of one it does not. A piece may have a symmetry
    that the face hasn't: a short stretch of a helical band lies on a torus. Other symmetries
    together prove nothing: whatever is coaxial is revolute, parallel cylinders are prismatic, two
    spheres have an axis.

    Args:
        mesh: the mesh.
        graph: its adjacency.
        first: the first step's result.
        label: (m,) region of each facet, -1 for none.
        known: class of the labels whose surface leaves no doubt of it.
        sure: (m,) facets that stay what they are: those of certain planes.
        sigma: noise of the vertices, mm.
        tolerances: thresholds of recognition.

    Returns:
        (m,) labels, with gaps; new ones where regions were joined.
    """
    rim = np.flatnonzero(graph.smooth & graph.borders(label) & graph.within(~sure))
    if not len(rim):
        return label
    used = np.unique(label[graph.pairs[rim]])
    number = np.full(len(label), -1, dtype=np.int64)
    inside = np.isin(label, used)
    number[inside] = np.searchsorted(used, label[inside])

    def classes(region: IntArray) -> list[InvarianceClass]:
        return list(classes_of(mesh, region, first.crease, sigma, tolerances))

    settled = np.array([u in known for u in used.tolist()])
    others = np.where(settled, -1, np.cumsum(~settled) - 1)
    found = iter(classes(np.append(others, -1)[number]))
    name = [known[u] if u in known else next(found) for u in used.tolist()]
    borders = SeenBorders(mesh, graph, rim, number)
    rule = _OneClass(borders, number, name, settled.tolist(), classes)
    kept = merge_regions(len(used), borders.ends, rule, SEEN)
    # What was joined lies on no surface known so far.
    joined = np.bincount(kept, minlength=len(used)) > 1
    new = np.where(joined[kept], int(label.max()) + 1 + kept, used)
    out = label.copy()
    out[inside] = new[number[inside]]
    return out


class _OneClass:
    """Likeness of regions: share of their border that is none, if their union has the class of the
    larger, or two revolute ones have another together; else 0 (a ``MergeRule``). Two whose surfaces
    leave no doubt of different classes are two faces, however little curvature jumps."""

    def __init__(
        self,
        borders: SeenBorders,
        region: IntArray,
        name: list[InvarianceClass],
        settled: list[bool],
        classes: Callable[[IntArray], list[InvarianceClass]],
    ) -> None:
        self._borders = borders
        self._region, self._classes = region, classes
        self._name, self._count = list(name), len(name)
        self._settled = list(settled)
        self._union: dict[tuple[int, int], InvarianceClass] = {}

    def score(self, first: IntArray, second: IntArray) -> FloatArray:
        return np.array(
            [self._likeness(a, b) for a, b in zip(first.tolist(), second.tolist(), strict=True)]
        )

    def join(self, kept: IntArray, gone: IntArray) -> None:
        now = np.arange(self._count)
        now[gone] = kept
        self._borders.join(kept, gone, self._count)
        self._region = np.where(self._region >= 0, now[self._region], -1)
        for a, b in zip(kept.tolist(), gone.tolist(), strict=True):
            self._name[a] = self._union[min(a, b), max(a, b)]
            self._settled[a] = False

    def _likeness(self, a: int, b: int) -> float:
        one, other = self._name[a], self._name[b]
        if (one == "complex") != (other == "complex"):
            return 0.0
        if one != other and self._settled[a] and self._settled[b]:
            return 0.0
        share = self._borders.share(a, b)
        if share < SEEN:
            return 0.0
        trial = np.where((self._region == a) | (self._region == b), 0, -1)
        self._union[min(a, b), max(a, b)] = name = self._classes(trial)[0]
        size = np.bincount(self._region[self._region >= 0], minlength=self._count)
        larger = one if size[a] >= size[b] else other
        kept = name == larger or (one == other == "revolute" and name != "complex")
        return share if kept else 0.0
