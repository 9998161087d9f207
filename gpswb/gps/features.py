# SPDX-License-Identifier: LGPL-2.1-or-later
"""Maximal integral features of a partition: the rows of the feature table."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence

import numpy as np

from gpswb.core.mesh import FloatArray, IntArray, Mesh
from gpswb.core.partition import Partition, Region
from gpswb.errors import InputError
from gpswb.gps.alignment import align
from gpswb.gps.gps_feature import GpsFeature, Material, Size, numbered
from gpswb.gps.same_surface import same_surface
from gpswb.gps.tolerances import DEFAULT, Tolerances
from gpswb.gps.twists import SituationFeature, perpendiculars, vector
from gpswb.sentence import Sentence

_NEEDS = {
    "planar": ("point", "normal"),
    "cylindrical": ("point", "direction"),
    "spherical": ("point",),
    "revolute": ("point", "direction"),
    "prismatic": ("direction",),
    "helical": ("point", "direction"),
    "complex": (),
}
_SIZES = {"cylinder": ("radius",), "sphere": ("radius",), "torus": ("major_radius", "minor_radius")}


class _Patch:
    """The regions gathered so far on one surface; the largest came first."""

    def __init__(self, region: Region, facets: IntArray, mesh: Mesh, body: int) -> None:
        self.region = region
        self.body = body
        self.regions = [region]
        self.facets = [facets]
        self.vertices = [np.unique(mesh.triangles[facets])]
        self.mesh = mesh
        self.material, self.normal = _material_side(region, facets, mesh)

    @property
    def points(self) -> FloatArray:
        """(k, 3) distinct vertices of all regions."""
        return self.mesh.vertices[np.unique(np.concatenate(self.vertices))]

    def continues(self, other: _Patch, length: float, tolerances: Tolerances) -> bool:
        """Whether ``other`` lies on this surface of this body, the material on the same side."""
        if (
            self.body != other.body
            or self.material != other.material
            or float(self.normal @ other.normal) < 0.0
        ):
            return False
        vertices = self.mesh.vertices
        own, points = vertices[self.vertices[0]], vertices[other.vertices[0]]
        return same_surface(self.region, own, other.region, points, length, tolerances)

    def take(self, other: _Patch) -> None:
        """Unite with a patch of one region."""
        self.regions += other.regions
        self.facets += other.facets
        self.vertices += other.vertices

    @property
    def interrupted(self) -> bool:
        """Whether the united regions don't all hang together by shared vertices."""
        reached = set(self.vertices[0].tolist())
        waiting = [set(v.tolist()) for v in self.vertices[1:]]
        while touching := [w for w in waiting if w & reached]:
            reached.update(*touching)
            waiting = [w for w in waiting if w not in touching]
        return bool(waiting)


def maximal_features(
    partition: Partition,
    faces: Mapping[int, Sequence[str]] | None = None,
    tolerances: Tolerances = DEFAULT,
    bodies: Mapping[int, int] | None = None,
) -> tuple[GpsFeature, ...]:
    """Unite regions on one surface, with the material on one side, to maximal integral features.

    Seams, split and interrupted cylinders and coplanar faces become one feature each; a boss's top
    and a pocket's floor that face each other do not. Surfaces without a closed form stay apart.

    Args:
        partition: its mesh in mm, oriented outwards (that tells a hole from a shaft).
        faces: names of the B-rep faces of each region id; a name given twice stays with the larger.
            Regions without a face are bits of faces that have another region: they are left out.
            None for a mesh, whose regions all count.
        bodies: number of the solid of each region id; all are of one where it isn't given.

    Returns:
        By falling area, ids counting from 0.

    Raises:
        InputError: a region lacks the situation feature or the size of its class.
    """
    mesh = partition.mesh
    order = np.argsort(partition.region, kind="stable")
    ends = np.searchsorted(partition.region[order], np.arange(len(partition.regions) + 1))
    patches = []
    for index, region in enumerate(partition.regions):
        facets = order[ends[index] : ends[index + 1]]
        if len(facets) and (faces is None or faces.get(region.id)):
            _check(region)
            patches.append(_Patch(region, facets, mesh, (bodies or {}).get(region.id, 0)))
    patches.sort(key=lambda patch: -patch.region.area)
    united: list[_Patch] = []
    for patch in patches:
        for earlier in united:
            if earlier.continues(patch, mesh.diagonal, tolerances):
                earlier.take(patch)
                break
        else:
            united.append(patch)
    united.sort(key=lambda patch: -sum(region.area for region in patch.regions))
    counts: Counter[str] = Counter()
    named: set[str] = set()
    features: list[GpsFeature] = []
    for patch in united:
        names = [name for r in patch.regions for name in (faces or {}).get(r.id, ())]
        own = tuple(name for name in dict.fromkeys(names) if name not in named)
        named.update(own)
        features.append(_feature(len(features), patch, own, counts, tolerances))
    return align(features, mesh.diagonal, tolerances)


def _check(region: Region) -> None:
    lacking = [k for k in _NEEDS[region.invariance_class] if k not in region.situation]
    lacking += [k for k in _SIZES.get(region.surface, ()) if k not in region.intrinsic]
    if lacking:
        raise InputError(
            Sentence(
                "region {region} is {kind} but has no {lacking}",
                region=region.id,
                kind=Sentence(region.invariance_class),
                lacking=", ".join(lacking),
            )
        )


def _material_side(region: Region, facets: IntArray, mesh: Mesh) -> tuple[Material, FloatArray]:
    """Side of the material by the outward normals, and a plane's outward normal (0 for others)."""
    normals, areas = mesh.facet_normals[facets], mesh.areas[facets]
    if region.surface == "plane":
        n = np.array(region.situation["normal"])
        return "neither", n * (1.0 if areas @ (normals @ n) >= 0 else -1.0)
    centres = mesh.centroids[facets]
    if region.surface == "sphere":
        outward = centres - region.situation["point"]
    elif region.invariance_class in ("cylindrical", "revolute", "helical"):
        d = np.array(region.situation["direction"])
        relative = centres - region.situation["point"]
        outward = relative - np.outer(relative @ d, d)
        if region.surface == "torus":
            rim = outward / np.linalg.norm(outward, axis=1, keepdims=True)
            outward = relative - region.intrinsic["major_radius"] * rim
    else:
        return "neither", np.zeros(3)
    facing = areas * np.einsum("ij,ij->i", normals, outward)
    balance = float(facing.sum() / max(float(np.abs(facing).sum()), np.finfo(float).tiny))
    if abs(balance) < 0.5:
        return "neither", np.zeros(3)
    return ("external" if balance > 0 else "internal"), np.zeros(3)


def arc_covered(points: FloatArray, point: list[float], direction: list[float]) -> float:
    """Angle (rad) about an axis that points (k, 3) span: a turn less the largest gap."""
    u, w = perpendiculars(direction)
    relative = points - np.asarray(point)
    angles = np.sort(np.arctan2(relative @ w, relative @ u))
    gaps = np.diff(np.r_[angles, angles[0] + 2 * np.pi])
    return float(2 * np.pi - gaps.max())


def _size(patch: _Patch, area: float, arc: float, least: float) -> tuple[Size | None, str]:
    """Size and derived feature (ISO 14405-1, 22432); a corner's radius has an axis but no size."""
    region = patch.region
    if region.surface == "sphere":
        radius = region.intrinsic["radius"]
        whole = area > 2 * np.pi * radius**2
        return Size("spherical diameter", 2 * radius) if whole else None, "centre point"
    if region.surface in ("cylinder", "cone"):
        if arc <= least:
            return None, "axis"
        if region.surface == "cylinder":
            return Size("diameter", 2 * region.intrinsic["radius"]), "median line"
        angle = region.intrinsic.get("half_angle_deg")
        return Size("cone angle", 2 * angle) if angle is not None else None, "median line"
    return None, "axis" if region.invariance_class in ("revolute", "helical") else ""


_WORDS = {
    "plane": Sentence("Plane"),
    "cylinder": Sentence("Cylinder"),
    "sphere": Sentence("Sphere"),
    "cone": Sentence("Cone"),
    "torus": Sentence("Torus"),
    "revolution": Sentence("Revolution"),
    "extrusion": Sentence("Extrusion"),
    "helicoid": Sentence("Helicoid"),
    "freeform": Sentence("Freeform"),
}
"""What features of each surface are called."""


def _word(surface: str, material: Material, size: Size | None) -> Sentence:
    if (surface, material) == ("cylinder", "internal"):
        return Sentence("Hole") if size else Sentence("Concave radius")
    if (surface, material) == ("cylinder", "external"):
        return Sentence("Shaft") if size else Sentence("Convex radius")
    return _WORDS[surface]


def _feature(
    id_: int, patch: _Patch, faces: tuple[str, ...], counts: Counter[str], tolerances: Tolerances
) -> GpsFeature:
    region, points = patch.region, patch.points
    situation = dict(region.situation)
    middle = np.average(points, axis=0)
    if region.surface == "plane":
        situation["normal"] = (patch.normal + 0.0).tolist()
    area = sum(r.area for r in patch.regions)
    arc = 2 * np.pi
    if region.surface in ("cylinder", "cone"):
        arc = arc_covered(points, situation["point"], situation["direction"])
    size, derived = _size(patch, area, arc, tolerances.size_arc)
    word = _word(region.surface, patch.material, size)
    counts[word] += 1
    return GpsFeature(
        id=id_,
        name=numbered(word, counts[word]),
        kind="integral",
        invariance_class=region.invariance_class,
        surface=region.surface,
        situations=(_place(region, situation, middle),),
        situation=situation,
        intrinsic=dict(region.intrinsic),
        size=size,
        material=patch.material,
        derived=derived,
        regions=tuple(r.id for r in patch.regions),
        faces=faces,
        area=area,
        interrupted=patch.interrupted,
        # Few facets leave everything open; but a flat region is a plane, not a piece of a sphere.
        sure=not region.undecided or region.surface == "plane",
        whole=arc >= tolerances.whole_arc,
        body=patch.body,
        points=points,
        facets=patch.mesh.vertices[patch.mesh.triangles[np.concatenate(patch.facets)]],
    )


def _place(
    region: Region, situation: Mapping[str, list[float]], middle: FloatArray
) -> SituationFeature:
    """Situation feature with its point beside the feature, where an error of angle has no lever."""
    direction = np.array(situation.get("normal") or situation.get("direction") or (0.0, 0.0, 1.0))
    direction = direction / np.linalg.norm(direction)
    point = np.array(situation.get("point", middle), dtype=np.float64)
    if region.surface == "plane":
        point = middle - direction * ((middle - point) @ direction)
    elif region.invariance_class in ("cylindrical", "revolute", "helical"):
        point = point + direction * ((middle - point) @ direction)
    return SituationFeature(
        region.invariance_class, vector(point), vector(direction), region.intrinsic.get("lead", 0.0)
    )
