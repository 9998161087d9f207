# SPDX-License-Identifier: LGPL-2.1-or-later
"""The nominal surface as a cloud of samples that know their face; distances of points to it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from gpswb.cad.solid import Face, FaceMap, Solid
from gpswb.core.mesh import FloatArray, IntArray
from gpswb.core.robust.surfaces import Kind, distance

MOST_SAMPLES = 400_000
_SEED = 1101

ELEMENTARY = ("Plane", "Cylinder", "Cone", "Sphere", "Torus")


@dataclass(frozen=True, eq=False)
class Nominal:
    """Samples of a tessellated part.

    Args:
        points: (k, 3) mm.
        normals: (k, 3) out of the part.
        face: (k,) 0-based face.
        facemap: the faces.
        diagonal: of the part, mm.
    """

    points: FloatArray
    normals: FloatArray
    face: IntArray
    facemap: FaceMap
    diagonal: float

    def nearest_face(self, points: FloatArray) -> tuple[IntArray, FloatArray]:
        """(n,) face of the nearest sample, and (n,) signed distance: to the face's exact surface
        where that is elementary, else to the tangent plane of the sample; outside is positive."""
        _, at = cKDTree(self.points).query(points)
        normal = self.normals[at]
        d = np.einsum("ij,ij->i", points - self.points[at], normal)
        face = self.face[at]
        for f in np.unique(face).tolist():
            exact = ideal_surface(self.facemap.faces[f])
            if exact is None:
                continue
            mine = np.flatnonzero(face == f)
            kind, row = exact
            value, outward = distance(kind, row[None], points[mine][None])
            sign = np.sign(np.einsum("ij,ij->i", outward[0], normal[mine]))
            d[mine] = value[0] * np.where(sign == 0, 1.0, sign)
        return face, d


def nominal_samples(solid: Solid) -> Nominal:
    """Sample a tessellated part evenly by area, each facet at least once.

    Raises:
        ValueError: the solid has no faces.
    """
    if solid.facemap is None:
        raise ValueError("a nominal part has faces; this is a mesh")
    mesh, face = solid.mesh, solid.facemap.face_of_triangle
    use = np.flatnonzero((mesh.areas > 0) & (face >= 0))
    share = mesh.areas[use] / mesh.areas[use].sum()
    count = 1 + np.floor(share * max(MOST_SAMPLES - len(use), 0)).astype(np.int64)
    facet = np.repeat(use, count)
    u, v = np.random.default_rng(_SEED).uniform(size=(2, len(facet)))
    over = u + v > 1
    u, v = np.where(over, 1 - u, u)[:, None], np.where(over, 1 - v, v)[:, None]
    a, b, c = np.moveaxis(mesh.corners_of(facet), 1, 0)
    points = a + u * (b - a) + v * (c - a)
    return Nominal(points, mesh.facet_normals[facet], face[facet], solid.facemap, mesh.diagonal)


def ideal_surface(face: Face) -> tuple[Kind, FloatArray] | None:
    """The exact surface of an elementary face as a row of `gpswb.core.robust.surfaces`."""
    if face.truth is None or face.truth.surface not in (
        "Plane",
        "Cylinder",
        "Cone",
        "Sphere",
        "Torus",
    ):
        return None
    known = face.truth.parameters
    row = np.zeros(8)
    row[:3] = known["point"]
    row[3:6] = known.get("direction", (0.0, 0.0, 1.0))
    kind: Kind
    if face.truth.surface == "Plane":
        kind = "plane"
    elif face.truth.surface == "Torus":
        kind = "torus"
        row[6:] = known["major_radius"][0], known["minor_radius"][0]
    elif face.truth.surface == "Cone":
        kind = "cone"
        half = np.radians(known["half_angle_deg"][0])
        row[6:] = known["radius"][0] * np.cos(half), half
    else:
        kind = "cylinder" if face.truth.surface == "Cylinder" else "sphere"
        row[6] = known["radius"][0]
    return kind, row
