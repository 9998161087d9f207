# SPDX-License-Identifier: LGPL-2.1-or-later
"""The FreeCAD kernel: the Part module of FreeCAD 0.20 and later, nothing else needed."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from functools import cached_property
from pathlib import Path
from typing import Any

import FreeCAD  # noqa: F401 - Part crashes where FreeCAD is not loaded yet
import numpy as np
import Part
from scipy.spatial import cKDTree

from gpswb.cad.elementary import Elementary, ElementaryKind
from gpswb.cad.freecad_rims import find_rims
from gpswb.cad.kernel import Patch, SurfaceKind
from gpswb.core.mesh import FloatArray, IntArray

_KINDS: dict[str, SurfaceKind] = {
    "Part::GeomPlane": "Plane",
    "Part::GeomCylinder": "Cylinder",
    "Part::GeomCone": "Cone",
    "Part::GeomSphere": "Sphere",
    "Part::GeomToroid": "Torus",
    "Part::GeomBSplineSurface": "BSpline",
    "Part::GeomBezierSurface": "Bezier",
    "Part::GeomSurfaceOfRevolution": "Revolution",
    "Part::GeomSurfaceOfExtrusion": "Extrusion",
    "Part::GeomOffsetSurface": "Offset",
}
_EMPTY = Patch(np.empty((0, 3)), np.empty((0, 2)), np.empty((0, 3), np.int64), ())


class FreecadFace:
    """One face; see `kernel.BrepFace`."""

    def __init__(self, face: Any, solid: int, edges: list[tuple[int, Any]], bare: bool) -> None:
        self.face = face
        self.solid = solid
        self.outward = -1.0 if face.Orientation == "Reversed" else 1.0
        self._bare = bare
        self._edge = dict(edges)
        self.edges = tuple(sorted(self._edge))

    @cached_property
    def surface(self) -> Any:
        return None if self._bare else self.face.Surface

    @property
    def kind(self) -> SurfaceKind | None:
        return None if self._bare else _KINDS.get(self.surface.TypeId, "Other")

    @cached_property
    def area(self) -> float:
        return 0.0 if self._bare else abs(float(self.face.Area))

    @cached_property
    def centre(self) -> FloatArray:
        return np.zeros(3) if self._bare else np.array(self.face.CenterOfMass)

    @cached_property
    def bounds(self) -> tuple[float, float, float, float]:
        u0, u1, v0, v1 = self.face.ParameterRange
        return u0, u1, v0, v1

    @cached_property
    def elementary(self) -> Elementary | None:
        kind = self.kind
        if kind not in ("Plane", "Cylinder", "Cone", "Sphere", "Torus"):
            return None
        found = _elementary(kind, self.surface)
        # The closed form is read off the surface's own points: check it at others.
        uv = np.array([(0.3, 0.2), (2.1, -0.7), (-1.2, 0.4)])
        size = 1.0 + float(np.abs(found.origin).max()) + found.radius
        gap = np.abs(found.derivatives(uv)[0] - self._generic(uv)[0]).max()
        return found if gap < 1e-9 * size else None

    def derivatives(self, uv: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        if self.elementary is not None:
            return self.elementary.derivatives(uv)
        return self._generic(uv)

    def _generic(self, uv: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        value, derivative = self.surface.value, self.surface.getDN
        out = np.empty((len(uv), 9))
        for i, (u, v) in enumerate(uv.tolist()):
            out[i] = (*value(u, v), *derivative(u, v, 1, 0), *derivative(u, v, 0, 1))
        return out[:, :3], out[:, 3:6], out[:, 6:]

    def rim_uv(self, edge: int, side: int, parameters: FloatArray) -> FloatArray:
        value = self.curves[edge, side][0].value
        points = [value(t) for t in parameters.tolist()]
        return np.array([(p.x, p.y) for p in points]).reshape(-1, 2)

    @cached_property
    def curves(self) -> dict[tuple[int, int], tuple[Any, float, float]]:
        """Curve in parameter space and its range, by edge and side."""
        out = {}
        for number, edge in self._edge.items():
            passes = (edge, edge.reversed()) if edge.isSeam(self.face) else (edge,)
            for side, oriented in enumerate(passes):
                found = self.face.curveOnSurface(oriented)
                if found is not None:
                    out[number, side] = found
        return out

    def replace(self, face: Any) -> None:
        """Take another copy of the same face (one that has been meshed)."""
        self.face = face
        self._edge = dict(zip(self._edge, face.Edges, strict=True))
        self.__dict__.pop("curves", None)

    def degenerate(self, edge: int) -> bool:
        return bool(self._edge[edge].Degenerated)

    def patch(self, linear: float) -> Patch:
        """The face's triangulation. FreeCAD hands it out with the nodes on seams and poles merged;
        the parameters that it also hands out are not merged, and tell which node was meant."""
        if self._bare:
            return _EMPTY
        try:
            points, triangles = self.face.tessellate(linear)
            raw = self.face.getUVNodes()
        except RuntimeError:  # BRepMesh found no triangulation of this face
            return _EMPTY
        if not triangles or not raw:
            return _EMPTY
        uv, merged = np.array(raw), np.array([tuple(p) for p in points])
        corner = np.array(triangles, dtype=np.int64)
        near = _match(self.derivatives(uv)[0], merged)
        copies: list[list[int]] = [[] for _ in merged]
        for node, at in enumerate(near.tolist()):
            copies[at].append(node)
        if not all(copies[i] for i in np.unique(corner)):
            # Nothing tells where the nodes lie on the surface: the triangles stay as they are.
            return Patch(merged, np.full((len(merged), 2), np.nan), corner, ())
        chosen = _choose_copies(corner, copies, uv, self.bounds)
        nodes = merged[near]
        return Patch(nodes, uv, chosen, find_rims(self, uv, chosen))


def _match(unmerged: FloatArray, merged: FloatArray) -> IntArray:
    """For each unmerged point the merged one that it went into.

    The nearest; but a B-rep vertex may lie off the surface by more than its neighbours are apart,
    and every merged point came from one.
    """
    near: IntArray = cKDTree(merged).query(unmerged)[1].astype(np.int64)
    lonely = np.setdiff1d(np.arange(len(merged)), near)
    if len(lonely):
        count = np.bincount(near, minlength=len(merged))
        choices = cKDTree(unmerged).query(merged[lonely], k=min(8, len(unmerged)))[1]
        for point, options in zip(lonely.tolist(), np.atleast_2d(choices).tolist(), strict=True):
            spare = next((i for i in options if count[near[i]] > 1), None)
            if spare is not None:
                count[near[spare]] -= 1
                near[spare] = point
    return near


def _choose_copies(
    triangles: IntArray,
    copies: list[list[int]],
    uv: FloatArray,
    bounds: tuple[float, float, float, float],
) -> IntArray:
    """Triangles on unmerged nodes: of the copies of a node those that keep the triangle smallest
    in parameter space."""
    extent = np.array([max(bounds[1] - bounds[0], 1e-300), max(bounds[3] - bounds[2], 1e-300)])
    scaled = uv / extent
    out = np.empty_like(triangles)
    for row, corner in enumerate(triangles.tolist()):
        choices = [copies[i] for i in corner]
        if all(len(c) == 1 for c in choices):
            out[row] = [c[0] for c in choices]
            continue
        best = min(
            itertools.product(*choices),
            key=lambda c: float(np.abs(scaled[list(c)] - np.roll(scaled[list(c)], 1, 0)).sum()),
        )
        out[row] = best
    return out


def _elementary(kind: ElementaryKind, surface: Any) -> Elementary:
    """Read the placement off the surface: FreeCAD's attributes don't tell a left-handed one."""

    def at(u: float, v: float) -> FloatArray:
        return np.array(surface.value(u, v))

    along_v = np.array(surface.getDN(0.0, 0.0, 0, 1))
    if kind == "Plane":
        x = np.array(surface.getDN(0.0, 0.0, 1, 0))
        return Elementary(kind, at(0, 0), np.array([x, along_v, np.cross(x, along_v)]))
    quarter = math.pi / 2
    extra = 0.0
    if kind == "Cone":
        radius, extra = float(surface.Radius), float(surface.SemiAngle)
    elif kind == "Torus":
        radius, extra = float(surface.MajorRadius), float(surface.MinorRadius)
    else:
        radius = float(surface.Radius)
    origin = (at(0, 0) + at(2 * quarter, 0)) / 2
    # A level with a radius: a cone may have its apex at the origin.
    level = 0.0 if kind != "Cone" else math.copysign(1.0 + radius, extra)
    rho = {"Cone": radius + level * math.sin(extra), "Torus": radius + extra}.get(kind, radius)
    x, y = ((at(u, level) - at(u + 2 * quarter, level)) / (2 * rho) for u in (0.0, quarter))
    z = along_v
    if kind == "Cone":
        z = (along_v - math.sin(extra) * x) / math.cos(extra)
    elif kind == "Sphere":
        z = along_v / radius
    elif kind == "Torus":
        z = along_v / extra
    return Elementary(kind, origin, np.array([x, y, z]), radius, extra)


class FreecadShape:
    """A shape read by FreeCAD; see `kernel.Shape`."""

    def __init__(self, shape: Any, unit: str, notes: tuple[str, ...], bare: set[int]) -> None:
        self.unit = unit
        self.notes = notes
        self._shape = shape
        self._edges: list[Any] = []
        self._numbers: dict[int, list[int]] = {}
        self.solid_count = len(shape.Solids)
        owner: dict[int, list[tuple[Any, int]]] = {}
        for solid, body in enumerate(shape.Solids):
            for face in body.Faces:
                owner.setdefault(face.hashCode(), []).append((face, solid))
        self.faces = [
            FreecadFace(
                face,
                next((s for f, s in owner.get(face.hashCode(), []) if f.isSame(face)), -1),
                [(self._number(edge), edge) for edge in face.Edges],
                i in bare,
            )
            for i, face in enumerate(shape.Faces)
        ]

    def _number(self, edge: Any) -> int:
        known = self._numbers.setdefault(edge.hashCode(), [])
        for number in known:
            if self._edges[number].isSame(edge):
                return number
        known.append(len(self._edges))
        self._edges.append(edge)
        return known[-1]

    @cached_property
    def diagonal(self) -> float:
        return float(self._usable.BoundBox.DiagonalLength)

    @cached_property
    def _usable(self) -> Any:
        return Part.makeCompound([f.face for f in self.faces if f.kind is not None])

    def tessellate(self, linear: float, angular: float) -> list[Patch]:
        # Of FreeCAD's ways to BRepMesh only two leave their work on the shape: `tessellate` chooses
        # an angle of its own, and the Inventor writer always takes 0.5 rad.
        shape = self._usable.cleaned()
        own = min(0.1, 5 * linear + 0.005)
        if abs(angular - own) < 1e-9:
            shape.tessellate(linear)
        else:
            shape.writeInventor(2, linear, 0.5)
        usable = [face for face in self.faces if face.kind is not None]
        for face, meshed in zip(usable, shape.Faces, strict=True):
            face.replace(meshed)
        return [face.patch(linear) for face in self.faces]

    def edge_points(self, edge: int, parameters: FloatArray) -> FloatArray:
        value = self._edges[edge].valueAt
        return np.array([tuple(value(t)) for t in parameters.tolist()]).reshape(-1, 3)

    def write_brep(self, path: Path, faces: Sequence[int]) -> None:
        Part.makeCompound([self._forward(i) for i in faces]).exportBrep(str(path))

    def _forward(self, i: int) -> Any:
        face = self.faces[i].face
        return face.reversed() if self.faces[i].outward < 0 else face
