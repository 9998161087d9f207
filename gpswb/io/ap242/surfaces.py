# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distances to the elementary surfaces of a STEP file, and its faces' borders."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gpswb.core.mesh import FloatArray
from gpswb.errors import InputError
from gpswb.io.ap242.curves import edge_points
from gpswb.io.ap242.part21 import Part21, Ref, Value
from gpswb.io.ap242.placement import placement
from gpswb.io.ap242.units import Units, number_of

_ELEMENTARY = {
    "PLANE": 0, "CYLINDRICAL_SURFACE": 1, "CONICAL_SURFACE": 2, "SPHERICAL_SURFACE": 1,
    "TOROIDAL_SURFACE": 2, "DEGENERATE_TOROIDAL_SURFACE": 2,
}  # fmt: skip
"""Number of sizes that follow the placement."""


@dataclass(frozen=True, eq=False)
class TextFace:
    """A face as the text describes it, in the frame of its representation.

    Args:
        number: its entity.
        kind: keyword of its surface. ``frame`` (4, 4) and ``sizes`` (mm, rad) of elementary ones.
        border: (k, 2, 3) mm, the segments of its edges, seams left out.
        inward: (k, 3) unit, from the middle of each segment into the face; zero where not known.
        normal: (k, 3) unit, of the face there; zero where not known.
    """

    number: Ref
    kind: str
    frame: FloatArray
    sizes: tuple[float, ...]
    border: FloatArray
    inward: FloatArray
    normal: FloatArray

    def distance(self, points: FloatArray, place: FloatArray) -> FloatArray:
        """(k,) mm from points (k, 3) to the unbounded surface placed by (4, 4); zero where it isn't
        elementary."""
        if self.kind not in _ELEMENTARY:
            return np.zeros(len(points))
        frame = place @ self.frame
        local = (points - frame[:3, 3]) @ frame[:3, :3]
        z, rho = local[:, 2], np.hypot(local[:, 0], local[:, 1])
        signed: FloatArray
        match self.kind:
            case "PLANE":
                signed = z
            case "CYLINDRICAL_SURFACE":
                signed = rho - self.sizes[0]
            case "CONICAL_SURFACE":
                radius, angle = self.sizes
                # The surface has two nappes: beyond the apex the radius is negative.
                signed = np.abs(radius + z * np.tan(angle)) - rho
                signed = signed * np.cos(angle)
            case "SPHERICAL_SURFACE":
                signed = np.hypot(rho, z) - self.sizes[0]
            case _:
                # Where the section is larger than the ring, the far side of the axis belongs to it.
                across = rho[:, None] - self.sizes[0] * np.array([1.0, -1.0])
                tube = np.abs(np.hypot(across, z[:, None]) - self.sizes[1])
                signed = tube[:, 0] if self.sizes[1] <= self.sizes[0] else tube.min(axis=1)
        return np.abs(signed)


def text_face(file: Part21, number: Ref, units: Units) -> TextFace:
    """Read a face's surface and border.

    Raises:
        InputError: the face is malformed.
    """
    keyword = next(k for k in file.keywords(number) if k in ("ADVANCED_FACE", "FACE_SURFACE"))
    parameters = file[number][keyword]
    if len(parameters) < 4 or not isinstance(parameters[1], tuple):
        raise InputError(f"face #{number} of the STEP file is malformed")
    bounds, surface, sense = parameters[1], parameters[2], parameters[3]
    kind, frame, sizes = _surface(file, surface, units)
    passes: dict[Ref, list[FloatArray]] = {}
    for bound in bounds:
        for edge, points in _loop(file, bound, units.mm):
            passes.setdefault(edge, []).append(points)
    # An edge that is passed twice is a seam: it isn't on the border of what the face covers.
    lines = [points for found in passes.values() if len(found) == 1 for points in found]
    segments = [np.stack([line[:-1], line[1:]], axis=1) for line in lines]
    border = np.concatenate(segments) if segments else np.zeros((0, 2, 3))
    normal = _normals(kind, frame, sizes, border.mean(axis=1)) * (1.0 if sense != "F" else -1.0)
    # A face lies to the left of its border, seen against its normal.
    inward = unit(np.asarray(np.cross(normal, border[:, 1] - border[:, 0]), dtype=np.float64))
    return TextFace(number, kind, frame, sizes, border, inward, normal)


def _surface(
    file: Part21, surface: Value, units: Units
) -> tuple[str, FloatArray, tuple[float, ...]]:
    if isinstance(surface, Ref) and surface in file:
        for keyword in file.keywords(surface):
            count = _ELEMENTARY.get(keyword)
            if count is not None:
                parameters = file[surface][keyword]
                sizes = [number_of(value) for value in parameters[2 : 2 + count]]
                if None in sizes or len(sizes) != count:
                    raise InputError(f"surface #{surface} of the STEP file is malformed")
                scaled = [s * units.mm for s in sizes if s is not None]
                if keyword == "CONICAL_SURFACE":
                    scaled[1] *= units.rad / units.mm
                return keyword, placement(file, parameters[1], units.mm), tuple(scaled)
        return file.keywords(surface)[0], np.eye(4), ()
    return "", np.eye(4), ()


def _loop(file: Part21, bound: Value, mm: float) -> list[tuple[Ref, FloatArray]]:
    """Edges of a bound with their points in the bound's sense."""
    for keyword in ("FACE_OUTER_BOUND", "FACE_BOUND"):
        found = file.get(bound, keyword)
        if found is not None:
            break
    else:
        return []
    loop = file.get(found[1], "EDGE_LOOP")
    edges = loop[1] if loop is not None else ()
    forward = found[2] != "F"
    passes = []
    for oriented in edges if isinstance(edges, tuple) else ():
        use = file.get(oriented, "ORIENTED_EDGE")
        if use is not None and isinstance(use[3], Ref):
            points = edge_points(file, use[3], mm)
            passes.append((use[3], points if (use[4] != "F") == forward else points[::-1]))
    return passes


def _normals(
    kind: str, frame: FloatArray, sizes: tuple[float, ...], points: FloatArray
) -> FloatArray:
    """(k, 3) unit normals of an elementary surface near points; zero for others."""
    if kind not in _ELEMENTARY:
        return np.zeros_like(points)
    z, relative = frame[:3, 2], points - frame[:3, 3]
    if kind == "PLANE":
        return np.tile(z, (len(points), 1))
    if kind == "SPHERICAL_SURFACE":
        return unit(relative)
    out = unit(relative - np.outer(relative @ z, z))
    if kind == "CYLINDRICAL_SURFACE":
        return out
    if kind == "CONICAL_SURFACE":
        return np.asarray(out * np.cos(sizes[1]) - z * np.sin(sizes[1]))
    return unit(relative - sizes[0] * out)


def unit(vectors: FloatArray) -> FloatArray:
    """Vectors (k, 3) scaled to length 1; those without length stay zero."""
    length = np.linalg.norm(vectors, axis=1, keepdims=True)
    return np.asarray(
        np.divide(vectors, length, out=np.zeros_like(vectors), where=length > 0), dtype=np.float64
    )
