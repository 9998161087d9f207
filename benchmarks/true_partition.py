# SPDX-License-Identifier: LGPL-2.1-or-later
"""A partition made of a part's CAD surfaces: the GPS logic by itself, without recognition."""

from __future__ import annotations

import numpy as np

from gpswb.cad.solid import FaceTruth, Solid
from gpswb.core.mesh import IntArray, Mesh
from gpswb.core.partition import Partition, Region

_WORDS = {"Plane": "plane", "Cylinder": "cylinder", "Sphere": "sphere", "Cone": "cone",
          "Torus": "torus"}  # fmt: skip
_OF_CLASS = {"planar": "plane", "cylindrical": "cylinder", "spherical": "sphere",
             "revolute": "revolution", "prismatic": "extrusion", "helical": "helicoid",
             "complex": "freeform"}  # fmt: skip
_NUMBERS = ("radius", "major_radius", "minor_radius", "half_angle_deg", "lead")


def true_partition(solid: Solid) -> tuple[Partition, dict[int, list[str]], dict[int, int]]:
    """Regions that are the maximal features of the B-rep, with each one's faces and solid.

    Faces without a surface or without triangles are in no region.
    """
    assert solid.facemap is not None
    faces, mesh = solid.facemap.faces, solid.mesh
    of_face = solid.facemap.feature_of_face
    region = np.full(len(mesh.triangles), -1)
    regions: list[Region] = []
    names: dict[int, list[str]] = {}
    bodies: dict[int, int] = {}
    for feature in np.unique(of_face):
        members = [i for i in np.flatnonzero(of_face == feature) if faces[i].truth is not None]
        facets = np.flatnonzero(np.isin(solid.facemap.face_of_triangle, members))
        if not members or not len(facets):
            continue
        truth = faces[max(members, key=lambda i: faces[i].area)].truth
        assert truth is not None
        names[len(regions)] = [faces[i].name for i in members]
        bodies[len(regions)] = faces[members[0]].solid
        region[facets] = len(regions)
        regions.append(_region(len(regions), truth, mesh, facets))
    m, n = len(mesh.triangles), len(mesh.vertices)
    nothing = np.zeros(m, dtype=np.int64)
    partition = Partition(
        mesh, nothing, nothing, region, tuple(regions), np.zeros(n, dtype=np.int64), np.zeros(m),
        np.zeros(m), len(regions), 0, 0.0, "true", "true",
    )  # fmt: skip
    return partition, names, bodies


def _region(id_: int, truth: FaceTruth, mesh: Mesh, facets: IntArray) -> Region:
    kind = truth.nominal
    word = _WORDS.get(truth.surface, "")
    if word not in ("cone", "torus") or kind != "revolute":
        word = _OF_CLASS[kind]
    numbers = truth.parameters
    situation = {key: list(numbers[key]) for key in ("point", "direction") if key in numbers}
    if kind == "planar":
        areas = mesh.areas[facets]
        normal = areas @ mesh.facet_normals[facets]
        point = areas @ mesh.centroids[facets] / areas.sum()
        situation = {"point": point.tolist(), "normal": (normal / np.linalg.norm(normal)).tolist()}
    intrinsic = {key: float(numbers[key][0]) for key in _NUMBERS if key in numbers}
    return Region(
        id_, kind, float(mesh.areas[facets].sum()), len(facets), word, situation, intrinsic, 0.0,
        np.inf, 1,
    )  # fmt: skip
