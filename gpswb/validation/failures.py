# SPDX-License-Identifier: LGPL-2.1-or-later
"""Analysis of failures: every face that went wrong gets exactly one kind, the likeliest cause.

The kinds are tried in the order of ``KINDS``; the first that holds is the face's. So a kind reads
"and none of those above".
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gpswb.cad.solid import FaceMap
from gpswb.core.invariance import InvarianceClass
from gpswb.core.partition import Partition
from gpswb.validation.face_geometry import FaceGeometry, coaxial, parallel_planes
from gpswb.validation.face_result import FaceResult
from gpswb.validation.region_match import RegionMatch

FEW = 12
"""Under this many triangles a face stays ambiguous (design, section 5)."""

TINY = 1e-4
"""Share of the part's area below which a face is tiny."""

HOLDS = 0.05
"""A region holds a feature when at least this share of the region or of the feature is common."""

STRIP_TURN = 30.0
"""Degrees: one triangle wide and turning less than this, a face shows too little of its surface."""

FREEFORM = frozenset({"BSpline", "Bezier", "Offset", "Other"})

KINDS: dict[str, str] = {
    "no truth": "the CAD surface is missing or can't be evaluated: no class to be judged by",
    "no triangles": "the mesher left the face without a triangle",
    "truth disputed": "exact truth and truth within tolerance differ, or there is no clear gap",
    "undecided": "wrong, but the result says so: the true class is among the candidates listed",
    "fillet lost": "curved, tangent to a neighbour, and most of it lies in a neighbour's region",
    "tangent chain swallowed": "one region over several features that are tangent to one another",
    "parallel steps merged": "one region over parallel planes that are not coplanar",
    "coaxial steps merged": "one region over coaxial features of different size",
    "merged across a crease": "one region over features that meet at an angle",
    "tiny face": "under 12 triangles and under 1e-4 of the part's area",
    "strip": "one triangle wide and turning less than 30 degrees",
    "few triangles": "under 12 triangles",
    "split": "the face lies in several regions, none of which holds 0.9 of its feature",
    "helical missed": "a helical face taken for another class, complex mostly",
    "prismatic missed": "a prismatic face taken for another class",
    "B-spline face": "a free-form encoded face taken for another class",
    "class confused": "a clean region of an elementary surface taken for another class",
    "border displaced": "right class, IoU under 0.9 though region and feature belong together",
}
"""Every kind of failure and what it means."""


@dataclass(frozen=True)
class Failure:
    """A face that is wrong, or right while its feature was not found (``wrong_class`` False)."""

    face: str
    kind: str
    wrong_class: bool
    true_class: InvarianceClass | None
    recognised: InvarianceClass | None
    surface: str
    area: float
    triangles: int
    iou: float
    region: int | None


def explain_failures(
    partition: Partition,
    facemap: FaceMap,
    faces: Sequence[FaceResult],
    match: RegionMatch,
) -> tuple[Failure, ...]:
    """Name the kind of every face whose class is wrong or whose feature no region matches.

    Args:
        partition: the partition that was judged.
        facemap: faces and provenance of its mesh.
        faces: what `map_back` found, in the face map's order.
        match: what `match_regions` found.

    Returns:
        One failure a face at most, in the order of the faces.
    """
    column = np.searchsorted(match.features, facemap.feature_of_face)
    found = match.region_of_feature[column] >= 0 if len(column) else np.zeros(0, dtype=bool)
    bad = [i for i, face in enumerate(faces) if face.disagrees or not found[i]]
    if not bad:
        return ()
    row = {region.id: index for index, region in enumerate(partition.regions)}
    geometry = FaceGeometry(partition.mesh, facemap)
    failures = []
    for i in bad:
        face = faces[i]
        main = row[face.regions[0]] if face.regions else None
        failures.append(
            Failure(
                face=face.name,
                kind=_kind(i, face, main, int(column[i]), facemap, geometry, match),
                wrong_class=face.disagrees,
                true_class=face.true_class,
                recognised=face.invariance_class,
                surface=face.surface,
                area=face.area,
                triangles=face.triangles,
                iou=float(match.iou_of_feature[column[i]]),
                region=face.regions[0] if face.regions else None,
            )
        )
    return tuple(failures)


def _kind(
    i: int,
    face: FaceResult,
    main: int | None,
    feature: int,
    facemap: FaceMap,
    geometry: FaceGeometry,
    match: RegionMatch,
) -> str:
    """The first of ``KINDS`` that holds for face ``i``, whose main region is row ``main``."""
    if face.true_class is None:
        return "no truth"
    if face.triangles == 0:
        return "no triangles"
    if face.ambiguous:
        return "truth disputed"
    if not face.agrees and face.true_class in face.undecided:
        return "undecided"
    others = [] if main is None else _held(main, feature, match)
    if others and main is not None:
        merged = _merged_kind(i, main, feature, others, facemap, geometry, match)
        if merged:
            return merged
    if face.triangles < FEW and face.area < TINY * geometry.total_area:
        return "tiny face"
    if geometry.is_strip(i, STRIP_TURN):
        return "strip"
    if face.triangles < FEW:
        return "few triangles"
    if len(face.regions) > 1 and match.iou_of_feature[feature] < 0.9:
        return "split"
    if face.agrees:
        return "border displaced"
    if face.true_class == "helical":
        return "helical missed"
    if face.true_class == "prismatic":
        return "prismatic missed"
    return "B-spline face" if face.surface in FREEFORM else "class confused"


def _held(main: int, feature: int, match: RegionMatch) -> list[int]:
    """Columns of the other features that region ``main`` holds."""
    row = match.overlap[main]
    whole = match.overlap.sum(axis=0)
    holds = (row > 0) & ((row >= HOLDS * row.sum()) | (row >= HOLDS * whole))
    # A sliver of a large feature across a displaced border is no merge.
    holds &= (row >= 0.5 * whole) | (row >= HOLDS * row.sum())
    holds[feature] = False
    return [int(c) for c in np.flatnonzero(holds)]


def _merged_kind(
    i: int,
    main: int,
    feature: int,
    others: list[int],
    facemap: FaceMap,
    geometry: FaceGeometry,
    match: RegionMatch,
) -> str | None:
    """Which merge put face ``i`` into one region with features ``others``; None for no merge."""
    own = match.overlap[main, feature]
    group = {int(match.features[c]) for c in others}
    partners = {j for j in range(len(facemap.faces)) if int(facemap.feature_of_face[j]) in group}
    tangent = geometry.tangent_to_any(i, partners)
    truth = facemap.faces[i].truth
    curved = truth is not None and truth.nominal != "planar"
    dominated = max(match.overlap[main, c] for c in others) > own
    if curved and tangent and dominated and len(others) < 3:
        return "fillet lost"
    if tangent:
        return "tangent chain swallowed"
    pairs = [(truth, facemap.faces[j].truth) for j in partners]
    if any(a and b and parallel_planes(a, b) for a, b in pairs):
        return "parallel steps merged"
    if any(a and b and coaxial(a, b) for a, b in pairs):
        return "coaxial steps merged"
    return "merged across a crease"
