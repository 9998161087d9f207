# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mapping back: the class of every B-rep face from the facets that came from it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gpswb.cad.solid import FaceMap
from gpswb.core.invariance import CLASSES, InvarianceClass
from gpswb.core.mesh import FloatArray, IntArray
from gpswb.core.partition import Partition

REGION_SHARE = 0.01
"""A region that covers less of a face's area than this is not listed with the face: it is the
sliver that a border one facet out of place leaves behind."""


@dataclass(frozen=True)
class FaceResult:
    """What was recognised on one B-rep face.

    Args:
        name: FreeCAD name of the face.
        invariance_class: class with the largest share of the area of the face's triangles; None
            for a face without triangles or without a recognised one.
        true_class: nominal truth; None where the surface can't be evaluated.
        surface: kind of the CAD surface; ``Null`` where there is none.
        area: exact area, mm².
        share: share (0..1) of the area of the face's triangles that has ``invariance_class``.
        triangles: number of triangles of the face.
        regions: ids of the regions on the face, the largest share first.
        ambiguous: the truth itself is disputed (`FaceTruth.ambiguous`).
        undecided: classes between which the face's main region could not decide.
        solid: number of the solid that the face belongs to.
    """

    name: str
    invariance_class: InvarianceClass | None
    true_class: InvarianceClass | None
    surface: str
    area: float
    share: float
    triangles: int
    regions: tuple[int, ...]
    ambiguous: bool
    undecided: tuple[InvarianceClass, ...]
    solid: int = 0

    @property
    def agrees(self) -> bool:
        """The recognised class is the true one."""
        return self.true_class is not None and self.invariance_class == self.true_class

    @property
    def disagrees(self) -> bool:
        """There is a true class, and it was not recognised."""
        return self.true_class is not None and self.invariance_class != self.true_class


def faces_and_bodies(
    faces: Sequence[FaceResult],
) -> tuple[dict[int, list[str]], dict[int, int]]:
    """Names of the faces that go with each region id, and the solid that each region belongs to.

    Each face goes with the region that covers most of it.
    """
    names: dict[int, list[str]] = {}
    bodies: dict[int, int] = {}
    for face in faces:
        for region in face.regions[:1]:
            names.setdefault(region, []).append(face.name)
            bodies.setdefault(region, face.solid)
    return names, bodies


def faces_without_region(faces: Sequence[FaceResult]) -> list[tuple[str, int]]:
    """Name and solid of each face that no region lies on: the mesh has no triangle of it, or none
    in a region."""
    return [(face.name, face.solid) for face in faces if not face.regions]


def facet_classes(partition: Partition) -> IntArray:
    """(m,) int64 class of every facet as index into ``CLASSES``; -1 for a facet in no region."""
    of_region = np.array(
        [CLASSES.index(region.invariance_class) for region in partition.regions] + [-1],
        dtype=np.int64,
    )
    return of_region[partition.region]  # region -1 picks the last entry


def map_back(partition: Partition, facemap: FaceMap) -> tuple[FaceResult, ...]:
    """Class, share and regions of every face of ``facemap`` (design, section 10).

    Of two classes with equal area the first in ``CLASSES`` wins.

    Raises:
        ValueError: partition and face map speak of different numbers of triangles.
    """
    face = facemap.face_of_triangle
    if len(face) != len(partition.region):
        raise ValueError(
            f"{len(face)} triangles in the face map, {len(partition.region)} in the partition"
        )
    f, c = len(facemap.faces), len(CLASSES)
    known = face >= 0
    area = partition.mesh.areas
    count = np.bincount(face[known], minlength=f)
    total = np.bincount(face[known], area[known], minlength=f)
    label = facet_classes(partition)
    sure = known & (label >= 0)
    by_class = np.bincount(face[sure] * c + label[sure], area[sure], minlength=f * c).reshape(f, c)
    regions = _regions_of_faces(partition.region, face, area, f)

    results = []
    for i, cad in enumerate(facemap.faces):
        best = int(by_class[i].argmax())
        found = by_class[i, best] > 0
        results.append(
            FaceResult(
                name=cad.name,
                invariance_class=CLASSES[best] if found else None,
                true_class=cad.truth.nominal if cad.truth else None,
                surface=cad.truth.surface if cad.truth else "Null",
                area=cad.area,
                share=float(by_class[i, best] / total[i]) if found else 0.0,
                triangles=int(count[i]),
                regions=tuple(partition.regions[r].id for r in regions[i]),
                ambiguous=cad.truth.ambiguous if cad.truth else False,
                undecided=partition.regions[regions[i][0]].undecided if regions[i] else (),
                solid=cad.solid,
            )
        )
    return tuple(results)


def _regions_of_faces(
    region: IntArray, face: IntArray, area: FloatArray, f: int
) -> list[list[int]]:
    """Indices of the regions on each face, the largest first, slivers left out."""
    use = (region >= 0) & (face >= 0)
    key = face[use] * (int(region.max(initial=0)) + 1) + region[use]
    pair, inverse = np.unique(key, return_inverse=True)
    weight = np.bincount(inverse, area[use], minlength=len(pair))
    of_face, of_region = np.divmod(pair, int(region.max(initial=0)) + 1)
    total = np.bincount(of_face, weight, minlength=f)
    listed: list[list[int]] = [[] for _ in range(f)]
    for i in np.lexsort((-weight, of_face)):
        if weight[i] >= REGION_SHARE * total[of_face[i]]:
            listed[of_face[i]].append(int(of_region[i]))
    return listed
