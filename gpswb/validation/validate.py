# SPDX-License-Identifier: LGPL-2.1-or-later
"""Validation of a partition against the B-rep it was tessellated from (design, section 6)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gpswb.cad.solid import FaceMap
from gpswb.core.invariance import CLASSES
from gpswb.core.partition import Partition
from gpswb.validation.face_result import FaceResult, facet_classes, map_back
from gpswb.validation.failures import Failure, explain_failures
from gpswb.validation.region_match import match_regions

Confusion = Mapping[str, Mapping[str, int]]
"""Number of faces by true class, then by recognised class (``none`` for no class at all)."""


@dataclass(frozen=True, eq=False)
class Validation:
    """How far a partition agrees with CAD.

    Args:
        faces: one result a face, in FreeCAD's order.
        area_accuracy: share of the area whose facet's class is its face's truth; None where no
            face has a truth. The sums behind it are ``right_area`` and ``judged_area``, mm².
        face_accuracy: share of the faces with a truth whose mapped class is the true one; a face
            without triangles counts as wrong.
        region_f1: F1 of the regions against the maximal features at IoU 0.9.
        confusion: faces by true and recognised class.
        features, regions, found: what the F1 is made of.
        over_segmented, under_segmented: features in several regions, regions over several features.
        failures: every face that is wrong or whose feature was not found, with its kind.
    """

    faces: tuple[FaceResult, ...]
    area_accuracy: float | None
    face_accuracy: float | None
    region_f1: float
    confusion: Confusion
    right_area: float
    judged_area: float
    features: int
    regions: int
    found: int
    over_segmented: int
    under_segmented: int
    failures: tuple[Failure, ...]

    @property
    def judged_faces(self) -> int:
        """Number of faces that have a truth."""
        return sum(face.true_class is not None for face in self.faces)

    @property
    def right_faces(self) -> int:
        """Number of faces whose mapped class is the true one."""
        return sum(face.agrees for face in self.faces)


def validate(partition: Partition, facemap: FaceMap) -> Validation:
    """Map the partition back on the faces and compare it with their nominal truth.

    Raises:
        ValueError: partition and face map speak of different numbers of triangles.
    """
    faces = map_back(partition, facemap)
    truth = np.array(
        [CLASSES.index(f.truth.nominal) if f.truth else -1 for f in facemap.faces] + [-1],
        dtype=np.int64,
    )[facemap.face_of_triangle]
    area = partition.mesh.areas
    judged = float(area[truth >= 0].sum())
    right = float(area[(truth >= 0) & (truth == facet_classes(partition))].sum())
    match = match_regions(partition, facemap)
    judged_faces = sum(face.true_class is not None for face in faces)
    return Validation(
        faces=faces,
        area_accuracy=right / judged if judged > 0 else None,
        face_accuracy=sum(f.agrees for f in faces) / judged_faces if judged_faces else None,
        region_f1=match.f1,
        confusion=confusion_of(faces),
        right_area=right,
        judged_area=judged,
        features=len(match.features),
        regions=match.regions,
        found=match.true_positives,
        over_segmented=match.over_segmented,
        under_segmented=match.under_segmented,
        failures=explain_failures(partition, facemap, faces, match),
    )


def confusion_of(faces: Sequence[FaceResult]) -> Confusion:
    """Count the faces by true class and recognised class; faces without a truth are left out."""
    table: dict[str, dict[str, int]] = {
        true: dict.fromkeys((*CLASSES, "none"), 0) for true in CLASSES
    }
    for face in faces:
        if face.true_class is not None:
            table[face.true_class][face.invariance_class or "none"] += 1
    return table
