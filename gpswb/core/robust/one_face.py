# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions that have one symmetry together and between which no border of two faces can be."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from gpswb.core.initial import InitialPartition
from gpswb.core.invariance import InvarianceClass
from gpswb.core.merging import merge_regions
from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.reference import Reference
from gpswb.core.robust.leftover import classes_of
from gpswb.core.robust.one_symmetry import Symmetries
from gpswb.core.robust.orbits import leaves_orbits
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
    smoothly curvature jumps; between the pieces of one it does not. Where the mesh is too coarse to
    see that, a border that runs across the motion of both sides is none. A piece may have a
    symmetry that the face hasn't: a short stretch of a helical band lies on a torus. Other
    symmetries together prove nothing: whatever is coaxial is revolute, parallel cylinders are
    prismatic, two spheres have an axis.

    Args:
        mesh: the mesh.
        graph: its adjacency.
        first: the first step's result.
        label: (m,) region of each facet, -1 for none.
        known: class of the labels whose surface leaves no doubt of it.
        sure: (m,) facets of certain planes, which are joined to extrusions only.
        sigma: noise of the vertices, mm.
        tolerances: thresholds of recognition.

    Returns:
        (m,) labels, with gaps; new ones where regions were joined.
    """
    rim = np.flatnonzero(graph.smooth & graph.borders(label) & ~graph.within(sure))
    if not len(rim):
        return label
    used = np.unique(label[graph.pairs[rim]])
    number = np.full(len(label), -1, dtype=np.int64)
    inside = np.isin(label, used)
    number[inside] = np.searchsorted(used, label[inside])

    settled = np.array([u in known for u in used.tolist()])
    others = np.where(settled, -1, np.cumsum(~settled) - 1)
    unsettled = np.append(others, -1)[number]
    classes: list[InvarianceClass] = list(
        classes_of(mesh, unsettled, first.crease, sigma, tolerances)
    )
    found = iter(classes)
    name = [known[u] if u in known else next(found) for u in used.tolist()]
    # A surface may have taken a certain plane whole.
    planes = np.bincount(number[inside], ~sure[inside]) == 0
    symmetries = Symmetries(mesh, first.crease, number, sigma, tolerances)
    rule = _OneFace(mesh, graph, rim, symmetries, name, settled.tolist(), planes)
    kept = merge_regions(len(used), symmetries.region[graph.pairs[rim]], rule, SEEN)
    # What was joined lies on no surface known so far.
    joined = np.bincount(kept, minlength=len(used)) > 1
    new = np.where(joined[kept], int(label.max()) + 1 + kept, used)
    out = label.copy()
    out[inside] = new[number[inside]]
    return out


class _OneFace:
    """Likeness of regions (a ``MergeRule``): share of their border that is none, if their union has
    the class of the larger, or two revolute ones have another together; 1 if their border cannot be
    one of two faces with their common symmetry; else 0. Two whose surfaces leave no doubt of
    different classes are two faces, however little curvature jumps."""

    def __init__(
        self,
        mesh: Mesh,
        graph: FacetGraph,
        rim: IntArray,
        symmetries: Symmetries,
        name: list[InvarianceClass],
        settled: list[bool],
        planes: BoolArray,
    ) -> None:
        self._mesh, self._rim = mesh, rim
        self._symmetries = symmetries
        self._borders = SeenBorders(mesh, graph, rim, symmetries.region)
        self._name, self._count = list(name), len(name)
        self._settled, self._plane = list(settled), planes.copy()
        self._none = np.zeros(len(rim), dtype=bool)
        self._union: dict[tuple[int, int], InvarianceClass] = {}

    def score(self, first: IntArray, second: IntArray) -> FloatArray:
        return np.array(
            [self._likeness(a, b) for a, b in zip(first.tolist(), second.tolist(), strict=True)]
        )

    def join(self, kept: IntArray, gone: IntArray) -> None:
        self._borders.join(kept, gone, self._count)
        self._symmetries.join(kept, gone, self._count)
        for a, b in zip(kept.tolist(), gone.tolist(), strict=True):
            self._name[a] = self._union[min(a, b), max(a, b)]
            self._settled[a] = self._plane[a] = False

    def _likeness(self, a: int, b: int) -> float:
        one, other = self._name[a], self._name[b]
        if (one == "complex") != (other == "complex"):
            return 0.0
        if one != other and self._settled[a] and self._settled[b]:
            return 0.0
        plane = self._plane[a] or self._plane[b]
        seen = 0.0 if plane else self._borders.share(a, b)
        if seen < SEEN and one == "complex":
            return 0.0
        size = self._symmetries.size
        larger = one if size[a] >= size[b] else other
        # Whatever turns a piece or shifts it both ways is found by position already, and a plane
        # goes on only as an extrusion, where the profile is straight for a while.
        along = ("prismatic",) if plane else ("revolute", "prismatic", "helical")
        if seen < SEEN and one != other and larger not in along:
            return 0.0  # before the union is fitted, which takes a second where it is large
        name, reference = self._symmetries.of_union(a, b)
        self._union[min(a, b), max(a, b)] = name
        if seen >= SEEN and (name == larger or (one == other == "revolute" and name != "complex")):
            likeness = seen
        elif (
            name in along
            and (name == larger or one == other)
            and self._is_none(a, b, name, reference)
        ):
            likeness = 1.0
        else:
            return 0.0
        # Where pieces of two regions were of one surface, the rest of them is, too.
        self._none[self._borders.between(a, b)] = True
        return likeness

    def _is_none(self, a: int, b: int, name: InvarianceClass, reference: Reference) -> bool:
        """Whether the border of two regions with a motion in common is none."""
        border = self._borders.between(a, b)
        sides = self._symmetries.region, (a, b)
        return bool(
            self._none[border].any()
            or leaves_orbits(self._mesh, self._rim[border], *sides, name, reference)
        ) and self._symmetries.follow(a, b, name, reference)
