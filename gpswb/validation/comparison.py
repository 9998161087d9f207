# SPDX-License-Identifier: LGPL-2.1-or-later
"""A scan against its nominal part: extracted points and form deviation of every feature.

The words are ISO 17450-1's: partition gives the extracted features, association the ideal ones.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from gpswb.core.mesh import BoolArray, FloatArray, IntArray
from gpswb.core.partition import Partition
from gpswb.gps.association import Associated, associate
from gpswb.gps.roundness import roundness
from gpswb.validation.nominal import Nominal, ideal_surface

FAR = 0.01
"""Points farther from the part than this share of its diagonal belong to no face: clamps, dust."""

FORM = {
    "plane": "flatness", "cylinder": "cylindricity", "sphere": "sphericity",
    "cone": "surface profile", "torus": "surface profile",
}  # fmt: skip
"""Characteristic that limits the form of each kind (ISO 1101); a cone's or torus's own is a surface
profile without datum and with free size."""


@dataclass(frozen=True)
class FeatureDeviation:
    """A maximal feature of the nominal part and what the scan shows of it; lengths in mm.

    Args:
        faces: names of its B-rep faces.
        nominal_class: class of its CAD surface; None where that can't be evaluated.
        scan_class: class recognised on the largest part of it; None where no region is on it.
        kind: of the associated ideal feature; None for a surface that is none of the five.
        regions: ids of the regions matched to it.
        points: number of extracted points.
        extraction: ``region`` where a matched region gave the points, ``nearness`` where none did
            and the points nearest to the faces were taken; ``none`` where nothing was seen.
        mean, rms: of the signed distances to the nominal surface, outside positive.
        profile: twice the largest distance to the nominal surface: the surface profile's value.
        form: characteristic of the form deviation.
        least_squares, minimax: the form deviation by either criterion; None without an ideal one.
        roundness_least_squares, roundness_minimax, sections: of a cylinder, over its sections.
        intrinsic: associated (least squares) and nominal sizes: ``radius``, ``nominal_radius`` ...
    """

    faces: tuple[str, ...]
    nominal_class: str | None
    scan_class: str | None
    kind: str | None
    regions: tuple[int, ...]
    points: int
    extraction: str
    mean: float | None = None
    rms: float | None = None
    profile: float | None = None
    form: str | None = None
    least_squares: float | None = None
    minimax: float | None = None
    roundness_least_squares: float | None = None
    roundness_minimax: float | None = None
    sections: int | None = None
    intrinsic: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class Comparison:
    """Every feature of the nominal part against the scan.

    Args:
        features: in the order of their first face.
        face: (n,) nominal face of each vertex of the scan, 0-based; -1 for none.
        distance: (n,) signed distance of each vertex to the nominal surface, mm.
        extracted: (n,) bool vertices that are an extracted point of a feature.
    """

    features: tuple[FeatureDeviation, ...]
    face: IntArray
    distance: FloatArray
    extracted: BoolArray

    @property
    def rms(self) -> float | None:
        """Root mean square of the distances of all points that belong to a face, mm."""
        near = self.distance[self.face >= 0]
        return float(np.sqrt((near**2).mean())) if len(near) else None


def compare(partition: Partition, nominal: Nominal) -> Comparison:
    """Match the regions of an aligned scan with the faces and measure each feature.

    A region belongs to the feature that most of its area is nearest to. The extracted points of a
    feature are the vertices that lie nearest to it and all of whose facets belong to its regions:
    points on an edge belong to two features and to neither's form.

    Args:
        partition: of the scan, in the nominal part's coordinates.
        nominal: samples of the part.
    """
    mesh = partition.mesh
    face, distance = nominal.nearest_face(mesh.vertices)
    face = np.where(np.abs(distance) <= FAR * nominal.diagonal, face, -1)
    feature_of_face = np.r_[nominal.facemap.feature_of_face, -1]
    of_vertex = feature_of_face[face]
    count = int(nominal.facemap.feature_of_face.max(initial=-1)) + 1
    feature_of_region = _match(partition, of_vertex, count)
    of_facet = np.r_[feature_of_region, -1][partition.region]
    whole = _whole(mesh.triangles, of_facet, of_vertex)
    rows, extracted = [], np.zeros(len(mesh.vertices), dtype=bool)
    order = np.unique(nominal.facemap.feature_of_face, return_index=True)
    for feature in order[0][np.argsort(order[1])].tolist():
        regions = np.flatnonzero(feature_of_region == feature)
        mine = np.flatnonzero(whole & (of_vertex == feature))
        extraction = "region"
        if not len(mine):
            mine = np.flatnonzero(of_vertex == feature)
            extraction = "nearness" if len(mine) else "none"
        extracted[mine] = True
        rows.append(
            _measure(partition, nominal, feature, regions, mesh.vertices[mine], distance[mine],
                     extraction)
        )  # fmt: skip
    return Comparison(tuple(rows), face, distance, extracted)


def _match(partition: Partition, of_vertex: IntArray, count: int) -> IntArray:
    """(r,) feature that most of each region's area is nearest to; -1 for none."""
    corner = of_vertex[partition.mesh.triangles]
    use = np.repeat(partition.region >= 0, 3) & (corner.ravel() >= 0)
    region = np.repeat(partition.region, 3)[use]
    weight = np.repeat(partition.mesh.areas / 3, 3)[use]
    r = len(partition.regions)
    table = np.bincount(region * count + corner.ravel()[use], weight, minlength=r * count)
    table = table.reshape(r, count)
    if not count:
        return np.full(r, -1, dtype=np.int64)
    return np.where(table.max(axis=1) > 0, table.argmax(axis=1), -1)


def _whole(triangles: IntArray, of_facet: IntArray, of_vertex: IntArray) -> BoolArray:
    """(n,) bool: vertices with facets, all of which belong to the vertex's own feature."""
    n = len(of_vertex)
    vertex = triangles.ravel()
    facets = np.bincount(vertex, minlength=n)
    own = np.bincount(vertex, np.repeat(of_facet, 3) == of_vertex[vertex], minlength=n)
    return np.asarray((facets > 0) & (own == facets) & (of_vertex >= 0))


def _measure(
    partition: Partition,
    nominal: Nominal,
    feature: int,
    regions: IntArray,
    points: FloatArray,
    distance: FloatArray,
    extraction: str,
) -> FeatureDeviation:
    faces = np.flatnonzero(nominal.facemap.feature_of_face == feature)
    first = nominal.facemap.faces[int(faces[0])]
    largest = max((partition.regions[r] for r in regions), key=lambda r: r.area, default=None)
    ideal = ideal_surface(first)
    row = FeatureDeviation(
        faces=tuple(nominal.facemap.faces[f].name for f in faces),
        nominal_class=first.truth.nominal if first.truth else None,
        scan_class=largest.invariance_class if largest else None,
        kind=ideal[0] if ideal else None,
        regions=tuple(partition.regions[r].id for r in regions),
        points=len(points),
        extraction=extraction,
    )
    if not len(points):
        return row
    found: dict[str, object] = {
        "mean": float(distance.mean()),
        "rms": float(np.sqrt((distance**2).mean())),
        "profile": 2.0 * float(np.abs(distance).max()),
        "form": "surface profile",
    }
    if ideal is not None:
        gauss = associate(*ideal, points, "least squares")
        least = associate(*ideal, points, "minimax")
        if gauss is not None and least is not None:
            found |= _form(gauss, least, ideal[1], points)
    return FeatureDeviation(**{**vars(row), **found})


def _form(
    gauss: Associated, least: Associated, nominal: FloatArray, points: FloatArray
) -> dict[str, object]:
    found: dict[str, object] = {
        "form": FORM[gauss.kind],
        "least_squares": gauss.zone,
        "minimax": least.zone,
        "intrinsic": _sizes(gauss, nominal),
    }
    if gauss.kind == "cylinder":
        measured = roundness(points, gauss.surface[:3], gauss.surface[3:6])
        if measured is not None:
            names = ("roundness_least_squares", "roundness_minimax", "sections")
            found |= dict(zip(names, measured, strict=True))
    return found


def _sizes(gauss: Associated, nominal: FloatArray) -> dict[str, float]:
    if gauss.kind in ("cylinder", "sphere"):
        return {"radius": float(gauss.surface[6]), "nominal_radius": float(nominal[6])}
    if gauss.kind == "cone":
        angles = np.degrees([abs(gauss.surface[7]), abs(nominal[7])])
        return {"half_angle_deg": float(angles[0]), "nominal_half_angle_deg": float(angles[1])}
    if gauss.kind == "torus":
        return {
            "major_radius": float(gauss.surface[6]), "nominal_major_radius": float(nominal[6]),
            "minor_radius": float(gauss.surface[7]), "nominal_minor_radius": float(nominal[7]),
        }  # fmt: skip
    return {}
