# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts made of exact surface patches, with the regions that recognition would deliver."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import Mesh
from gpswb.core.partition import Partition, Region
from gpswb.gps.twists import Frame, perpendiculars

_CLASS = {
    "plane": "planar",
    "cylinder": "cylindrical",
    "sphere": "spherical",
    "cone": "revolute",
    "torus": "revolute",
    "helicoid": "helical",
    "extrusion": "prismatic",
    "freeform": "complex",
}


class Part:
    """Patches gathered one by one, each of them one region."""

    def __init__(self, rotation=None, shift=(0.0, 0.0, 0.0), unit=1.0):
        self.pose = np.eye(3) if rotation is None else rotation, np.array(shift), unit
        self.vertices, self.triangles, self.regions, self.labels = [], [], [], []

    def add(self, surface, grid, outward, situation, intrinsic=None, undecided=()):
        """Triangulate grid (nu, nv, 3); ``outward`` (nu, nv, 3) tells which way is out."""
        turn, shift, unit = self.pose
        nu, nv = grid.shape[:2]
        index = np.arange(nu * nv).reshape(nu, nv)
        a, b, c, d = index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]
        facets = np.concatenate(
            [np.stack(t, axis=-1).reshape(-1, 3) for t in ((a, b, c), (a, c, d))]
        )
        corners = grid.reshape(-1, 3)[facets]
        normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        out = outward.reshape(-1, 3)[facets].mean(axis=1)
        inside = np.einsum("ij,ij->i", normal, out) < 0
        facets[inside] = facets[inside][:, ::-1]
        area = 0.5 * np.linalg.norm(normal, axis=1).sum()
        id_ = len(self.regions)
        self.triangles.append(facets + sum(len(v) for v in self.vertices))
        self.vertices.append(unit * (grid.reshape(-1, 3) @ turn.T + shift))
        self.labels += [id_] * len(facets)
        placed = {
            key: (
                unit * (turn @ np.array(v) + shift) if key == "point" else turn @ np.array(v)
            ).tolist()
            for key, v in situation.items()
        }
        sizes = {k: v if k == "half_angle_deg" else unit * v for k, v in (intrinsic or {}).items()}
        region = Region(
            id_, _CLASS[surface], unit**2 * area, len(facets), surface, placed, sizes,
            0.0, 1.0, 1, undecided=undecided,
        )  # fmt: skip
        self.regions.append(region)
        return id_

    def plane(self, middle, normal, along, length, width, flip=False):
        """A rectangle; ``flip``: recognition's normal points into the material."""
        n, u = np.array(normal, float), np.array(along, float)
        w = np.cross(n, u)
        s, t = np.meshgrid(np.linspace(-0.5, 0.5, 4), np.linspace(-0.5, 0.5, 4), indexing="ij")
        grid = np.array(middle) + s[..., None] * u * length + t[..., None] * w * width
        told = -n if flip else n
        return self.add(
            "plane", grid, np.broadcast_to(n, grid.shape), {"point": middle, "normal": told}
        )

    def annulus(self, middle, normal, inner, outer):
        """A flat ring."""
        grid, _ = self._ring(middle, normal, np.array([[inner, 0.0], [outer, 0.0]]))
        out = np.broadcast_to(np.array(normal, float), grid.shape)
        return self.add("plane", grid, out, {"point": middle, "normal": normal})

    def cylinder(self, start, axis, radius, height, hole=False, arc=2 * np.pi):
        """From ``start`` along ``axis``."""
        grid, radial = self._ring(start, axis, np.array([[radius, 0.0], [radius, height]]), arc)
        situation = {"point": start, "direction": axis}
        return self.add(
            "cylinder", grid, -radial if hole else radial, situation, {"radius": radius}
        )

    def cone(self, start, axis, radius, end_radius, height, hole=False):
        """Radius changes from ``radius`` at ``start`` to ``end_radius``."""
        grid, radial = self._ring(start, axis, np.array([[radius, 0.0], [end_radius, height]]))
        slope = (end_radius - radius) / height
        apex = np.array(start) - np.array(axis) * radius / slope
        angle = {"half_angle_deg": float(np.degrees(np.arctan(abs(slope))))}
        out = -radial if hole else radial
        return self.add("cone", grid, out, {"point": apex, "direction": axis}, angle)

    def sphere(self, centre, radius, hole=False, polar=np.pi):
        """Down to the polar angle given, from +Z."""
        theta, phi = np.meshgrid(
            np.linspace(0.05, polar - 0.05, 9), np.linspace(0, 2 * np.pi, 17), indexing="ij"
        )
        ray = np.stack(
            [np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], axis=-1
        )
        grid = np.array(centre) + radius * ray
        return self.add(
            "sphere", grid, -ray if hole else ray, {"point": centre}, {"radius": radius}
        )

    def thread(self, start, axis, radius, height, lead):
        """Stands for a thread's flank: a band at the pitch diameter."""
        grid, radial = self._ring(start, axis, np.array([[radius, 0.0], [radius, height]]))
        situation = {"point": start, "direction": axis}
        return self.add("helicoid", grid, radial, situation, {"lead": lead})

    def _ring(self, start, axis, profile, arc=2 * np.pi):
        d = np.array(axis, float)
        u, w = perpendiculars(d)
        phi = np.linspace(0.0, arc, 33)
        radial = np.cos(phi)[:, None] * u + np.sin(phi)[:, None] * w
        grid = np.array(start, float) + (
            radial[:, None] * profile[None, :, :1] + d * profile[None, :, 1:]
        )
        return grid, np.broadcast_to(radial[:, None], grid.shape)

    def partition(self):
        mesh = Mesh(np.concatenate(self.vertices), np.concatenate(self.triangles))
        m, n = len(mesh.triangles), len(mesh.vertices)
        return Partition(
            mesh, np.zeros(m, int), np.zeros(m, int), np.array(self.labels), tuple(self.regions),
            np.zeros(n, int), np.zeros(m), np.zeros(m), len(self.regions), 0, 0.0, "robust",
            "hybrid",
        )  # fmt: skip

    @property
    def frame(self):
        return Frame.around(np.concatenate(self.vertices))


X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)


def negative(direction):
    return tuple(-x for x in direction)


def box(part, low, high):
    """Six outward planes, in the order -X, +X, -Y, +Y, -Z, +Z; their region ids."""
    low, high = np.array(low, float), np.array(high, float)
    middle, size = (low + high) / 2, high - low
    ids = []
    for i, d in enumerate(np.eye(3)):
        along, other = np.roll(d, 1), (i + 2) % 3
        for sign, end in ((-1.0, low), (1.0, high)):
            point = np.where(d > 0, end, middle)
            ids.append(
                part.plane(
                    tuple(point), tuple(sign * d), tuple(along), size[(i + 1) % 3], size[other]
                )
            )
    return ids


def plate(part):
    """100 × 60 × 10 with four holes Ø8 in a 2 × 2 grid, their depth the thickness."""
    ids = box(part, (0.0, 0.0, 0.0), (100.0, 60.0, 10.0))
    holes = [
        part.cylinder((x, y, 0.0), Z, 4.0, 10.0, hole=True)
        for x in (15.0, 85.0)
        for y in (12.0, 48.0)
    ]
    return ids, holes


def flange(part, holes=6):
    """A disc Ø120 × 15 with a bore Ø40 and holes Ø10 on a circle Ø90."""
    top = part.annulus((0.0, 0.0, 15.0), Z, 20.0, 60.0)
    bottom = part.annulus((0.0, 0.0, 0.0), negative(Z), 20.0, 60.0)
    rim = part.cylinder((0.0, 0.0, 0.0), Z, 60.0, 15.0)
    bore = part.cylinder((0.0, 0.0, 0.0), Z, 20.0, 15.0, hole=True)
    angles = 2 * np.pi * np.arange(holes) / holes
    bolts = [
        part.cylinder((45.0 * np.cos(a), 45.0 * np.sin(a), 0.0), Z, 5.0, 15.0, hole=True)
        for a in angles
    ]
    return top, bottom, rim, bore, bolts


def shaft(part):
    """Along X: bearings Ø30 at both ends, Ø40 between, a cone and two end faces."""
    left = part.cylinder((0.0, 0.0, 0.0), X, 15.0, 30.0)
    middle = part.cylinder((30.0, 0.0, 0.0), X, 20.0, 60.0)
    right = part.cylinder((90.0, 0.0, 0.0), X, 15.0, 30.0)
    cone = part.cone((120.0, 0.0, 0.0), X, 15.0, 10.0, 20.0)
    ends = [part.annulus((0.0, 0.0, 0.0), negative(X), 0.1, 15.0),
            part.annulus((140.0, 0.0, 0.0), X, 0.1, 10.0)]  # fmt: skip
    shoulder = part.annulus((30.0, 0.0, 0.0), negative(X), 15.0, 20.0)
    return left, middle, right, cone, ends, shoulder
