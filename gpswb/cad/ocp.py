# SPDX-License-Identifier: LGPL-2.1-or-later
"""The OCP kernel (OCCT 7.9 by the wheel of cadquery): faces, evaluation and BRepMesh."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from OCP.Bnd import Bnd_Box
from OCP.BRep import BRep_Builder, BRep_Tool
from OCP.BRepAdaptor import BRepAdaptor_Curve
from OCP.BRepBndLib import BRepBndLib
from OCP.BRepGProp import BRepGProp
from OCP.BRepMesh import BRepMesh_IncrementalMesh
from OCP.BRepTools import BRepTools
from OCP.Geom import Geom_RectangularTrimmedSurface
from OCP.gp import gp_Pnt, gp_Vec
from OCP.GProp import GProp_GProps
from OCP.TopAbs import (
    TopAbs_EDGE,
    TopAbs_FACE,
    TopAbs_FORWARD,
    TopAbs_REVERSED,
    TopAbs_SOLID,
)
from OCP.TopExp import TopExp, TopExp_Explorer
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS, TopoDS_Compound, TopoDS_Edge, TopoDS_Face, TopoDS_Shape
from OCP.TopTools import TopTools_IndexedMapOfShape

from gpswb.cad.elementary import Elementary, ElementaryKind
from gpswb.cad.kernel import Patch, Rim, SurfaceKind
from gpswb.core.mesh import FloatArray, IntArray

_KINDS: dict[str, SurfaceKind] = {
    "Geom_Plane": "Plane",
    "Geom_CylindricalSurface": "Cylinder",
    "Geom_ConicalSurface": "Cone",
    "Geom_SphericalSurface": "Sphere",
    "Geom_ToroidalSurface": "Torus",
    "Geom_BSplineSurface": "BSpline",
    "Geom_BezierSurface": "Bezier",
    "Geom_SurfaceOfRevolution": "Revolution",
    "Geom_SurfaceOfLinearExtrusion": "Extrusion",
    "Geom_OffsetSurface": "Offset",
}

_AREA_ERROR = 1e-5


class OcpFace:
    """One face; see `kernel.BrepFace`."""

    def __init__(self, face: TopoDS_Face, solid: int, edge_map: TopTools_IndexedMapOfShape) -> None:
        self.solid = solid
        self.outward = -1.0 if face.Orientation() == TopAbs_REVERSED else 1.0
        # Edges are explored in the forward face: their orientation then names the seam's side.
        self.face = TopoDS.Face_s(face.Oriented(TopAbs_FORWARD))
        surface = BRep_Tool.Surface_s(self.face)
        while isinstance(surface, Geom_RectangularTrimmedSurface):
            surface = surface.BasisSurface()
        self.surface: Any = surface
        self.passes: list[tuple[int, int, TopoDS_Edge]] = []
        explorer = TopExp_Explorer(self.face, TopAbs_EDGE)
        seen: set[int] = set()
        while explorer.More():
            edge = TopoDS.Edge_s(explorer.Current())
            number = edge_map.FindIndex(edge) - 1
            side = 1 if number in seen else 0
            seen.add(number)
            self.passes.append((number, side, edge))
            explorer.Next()
        self.edges = tuple(sorted(seen))

    @property
    def kind(self) -> SurfaceKind | None:
        if self.surface is None:
            return None
        return _KINDS.get(self.surface.DynamicType().Name(), "Other")

    @cached_property
    def _mass(self) -> GProp_GProps:
        properties = GProp_GProps()
        if self.surface is not None:
            if self.elementary is None:
                # The default order of integration is off by up to 3 % on rational B-splines.
                BRepGProp.SurfaceProperties_s(self.face, properties, _AREA_ERROR)
            else:
                BRepGProp.SurfaceProperties_s(self.face, properties)
        return properties

    @cached_property
    def area(self) -> float:
        if self.surface is None:
            patch = self.patch()
            a, b, c = (patch.nodes[patch.triangles[:, k]] for k in range(3))
            return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)
        return abs(float(self._mass.Mass()))

    @property
    def centre(self) -> FloatArray:
        point = self._mass.CentreOfMass()
        return np.array([point.X(), point.Y(), point.Z()])

    @cached_property
    def bounds(self) -> tuple[float, float, float, float]:
        u0, u1, v0, v1 = BRepTools.UVBounds_s(self.face)
        return u0, u1, v0, v1

    @cached_property
    def elementary(self) -> Elementary | None:
        kind = self.kind
        if kind not in ("Plane", "Cylinder", "Cone", "Sphere", "Torus"):
            return None
        position = self.surface.Position()
        axes = (position.XDirection(), position.YDirection(), position.Direction())
        frame = np.array([[a.X(), a.Y(), a.Z()] for a in axes])
        place = position.Location()
        origin = np.array([place.X(), place.Y(), place.Z()])
        radius, extra = _sizes(kind, self.surface)
        return Elementary(kind, origin, frame, radius, extra)

    def derivatives(self, uv: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        if self.elementary is not None:
            return self.elementary.derivatives(uv)
        out = np.empty((len(uv), 9))
        point, du, dv = gp_Pnt(), gp_Vec(), gp_Vec()
        d1 = self.surface.D1
        for i, (u, v) in enumerate(uv.tolist()):
            d1(u, v, point, du, dv)
            out[i] = (
                point.X(), point.Y(), point.Z(), du.X(), du.Y(), du.Z(), dv.X(), dv.Y(), dv.Z(),
            )  # fmt: skip
        return out[:, :3], out[:, 3:6], out[:, 6:]

    def rim_uv(self, edge: int, side: int, parameters: FloatArray) -> FloatArray:
        curve = self._curves[edge, side]
        points = [curve.Value(t) for t in parameters.tolist()]
        return np.array([(p.X(), p.Y()) for p in points]).reshape(-1, 2)

    @cached_property
    def _curves(self) -> dict[tuple[int, int], Any]:
        return {
            (number, side): BRep_Tool.CurveOnSurface_s(edge, self.face, 0.0, 0.0)
            for number, side, edge in self.passes
        }

    def patch(self) -> Patch:
        """The face's triangulation as BRepMesh left it; empty where it made none."""
        location = TopLoc_Location()
        mesh = BRep_Tool.Triangulation_s(self.face, location)
        if mesh is None or mesh.NbTriangles() == 0:
            return Patch(np.empty((0, 3)), np.empty((0, 2)), np.empty((0, 3), np.int64), ())
        transform = location.Transformation()
        numbers = range(1, mesh.NbNodes() + 1)
        points = [mesh.Node(i).Transformed(transform) for i in numbers]
        nodes = np.array([(p.X(), p.Y(), p.Z()) for p in points])
        uv = np.zeros((len(nodes), 2))
        if mesh.HasUVNodes():
            uv = np.array([(p.X(), p.Y()) for p in map(mesh.UVNode, numbers)])
        corners = [mesh.Triangle(i).Get() for i in range(1, mesh.NbTriangles() + 1)]
        triangles = np.array(corners, dtype=np.int64) - 1
        if self.outward * transform.ScaleFactor() < 0 or transform.IsNegative():
            mirrored = transform.IsNegative()
            if (self.outward < 0) != mirrored:
                triangles = triangles[:, ::-1]
        rims = [
            Rim(number, self._side(number, side, uv, *polygon), *polygon, degenerate)
            for number, side, edge in self.passes
            if (polygon := _polygon(edge, mesh, location)) is not None
            for degenerate in [BRep_Tool.Degenerated_s(edge)]
        ]
        return Patch(nodes, uv, np.ascontiguousarray(triangles), tuple(rims))

    def _side(
        self, edge: int, side: int, uv: FloatArray, nodes: IntArray, parameters: FloatArray
    ) -> int:
        """Which of a seam's two curves the nodes lie on: BRepMesh may swap them."""
        if (edge, 1) not in self._curves:
            return side
        k = len(nodes) // 2
        gap = [
            float(np.abs(self.rim_uv(edge, s, parameters[k : k + 1]) - uv[nodes[k]]).max())
            for s in (0, 1)
        ]
        return int(gap[1] < gap[0])


def _sizes(kind: ElementaryKind, surface: Any) -> tuple[float, float]:
    if kind == "Cone":
        return float(surface.RefRadius()), float(surface.SemiAngle())
    if kind == "Torus":
        return float(surface.MajorRadius()), float(surface.MinorRadius())
    return (0.0 if kind == "Plane" else float(surface.Radius())), 0.0


def _polygon(
    edge: TopoDS_Edge, mesh: Any, location: TopLoc_Location
) -> tuple[IntArray, FloatArray] | None:
    polygon = BRep_Tool.PolygonOnTriangulation_s(edge, mesh, location)
    if polygon is None or not polygon.HasParameters():
        return None
    numbers = range(1, polygon.NbNodes() + 1)
    nodes = np.array([polygon.Node(i) for i in numbers], dtype=np.int64) - 1
    return nodes, np.array([polygon.Parameter(i) for i in numbers])


class OcpShape:
    """A shape read by OCP; see `kernel.Shape`."""

    def __init__(self, shape: TopoDS_Shape, unit: str, notes: tuple[str, ...]) -> None:
        self.unit = unit
        self.notes = notes
        face_map, self._edge_map = TopTools_IndexedMapOfShape(), TopTools_IndexedMapOfShape()
        TopExp.MapShapes_s(shape, TopAbs_FACE, face_map)
        TopExp.MapShapes_s(shape, TopAbs_EDGE, self._edge_map)
        solids = TopTools_IndexedMapOfShape()
        TopExp.MapShapes_s(shape, TopAbs_SOLID, solids)
        self.solid_count = solids.Extent()
        solid_of_face: dict[int, int] = {}
        for solid in range(solids.Extent()):
            explorer = TopExp_Explorer(solids.FindKey(solid + 1), TopAbs_FACE)
            while explorer.More():
                solid_of_face.setdefault(face_map.FindIndex(explorer.Current()) - 1, solid)
                explorer.Next()
        self.faces = [
            OcpFace(
                TopoDS.Face_s(face_map.FindKey(i + 1)), solid_of_face.get(i, -1), self._edge_map
            )
            for i in range(face_map.Extent())
        ]
        self._edges: dict[int, BRepAdaptor_Curve] = {}

    @cached_property
    def diagonal(self) -> float:
        box = Bnd_Box()
        for face in self.faces:
            if face.surface is not None:
                BRepBndLib.Add_s(face.face, box, False)
            else:
                for x, y, z in face.patch().nodes.tolist():
                    box.Add(gp_Pnt(x, y, z))
        return 0.0 if box.IsVoid() else float(box.SquareExtent()) ** 0.5

    def tessellate(self, linear: float, angular: float) -> list[Patch]:
        # BRepMesh crashes on a face without a surface, so those are left out.
        usable = [i for i, face in enumerate(self.faces) if face.surface is not None]
        if usable:
            compound = self._compound(usable)
            BRepTools.Clean_s(compound)
            BRepMesh_IncrementalMesh(compound, linear, False, angular, False)
        return [face.patch() for face in self.faces]

    def edge_points(self, edge: int, parameters: FloatArray) -> FloatArray:
        if edge not in self._edges:
            curve = BRepAdaptor_Curve(TopoDS.Edge_s(self._edge_map.FindKey(edge + 1)))
            self._edges[edge] = curve
        points = [self._edges[edge].Value(t) for t in parameters.tolist()]
        return np.array([(p.X(), p.Y(), p.Z()) for p in points]).reshape(-1, 3)

    def write_brep(self, path: Path, faces: Sequence[int]) -> None:
        compound = self._compound(faces)
        BRepTools.Clean_s(compound)
        BRepTools.Write_s(compound, str(path))

    def _compound(self, faces: Sequence[int]) -> TopoDS_Compound:
        builder, compound = BRep_Builder(), TopoDS_Compound()
        builder.MakeCompound(compound)
        for i in faces:
            builder.Add(compound, self.faces[i].face)
        return compound
