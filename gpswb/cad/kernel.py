# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a CAD kernel must offer; `ocp` and `freecad_part` are its two implementations.

Everything else in `cad` (welding, refinement, ground truth) is written against this protocol, so
that both kernels run the same code and one contract suite tests both.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal, Protocol

from gpswb.cad.elementary import Elementary
from gpswb.core.mesh import FloatArray, IntArray

SurfaceKind = Literal[
    "Plane", "Cylinder", "Cone", "Sphere", "Torus",
    "BSpline", "Bezier", "Revolution", "Extrusion", "Offset", "Other",
]  # fmt: skip


@dataclass(frozen=True, eq=False)
class Rim:
    """One pass of a B-rep edge along a face's triangulation (a seam passes twice).

    Args:
        edge: number of the edge, TopExp order over the whole shape.
        side: 0, or 1 for the second curve of a seam: names the parameter-space curve.
        nodes: (k,) nodes of the face's patch along the edge.
        parameters: (k,) parameters of these nodes on the edge's curve.
        degenerate: the edge has no length (a pole or an apex).
    """

    edge: int
    side: int
    nodes: IntArray
    parameters: FloatArray
    degenerate: bool


@dataclass(frozen=True, eq=False)
class Patch:
    """The triangulation of one face: (k, 3) nodes in mm, (k, 2) their parameters (nan where the
    kernel doesn't know them), (t, 3) triangles counter-clockwise seen from outside, and the rims
    that tie it to its neighbours."""

    nodes: FloatArray
    uv: FloatArray
    triangles: IntArray
    rims: tuple[Rim, ...]


class BrepFace(Protocol):
    """A face of the B-rep.

    Attributes:
        solid: 0-based solid that the face belongs to, -1 for a face in no solid.
        kind: kind of its CAD surface; None where it has only a triangulation.
        area: mm².
        centre: (3,) centre of area, mm.
        elementary: closed form of the surface, for the five kinds that have one.
        edges: numbers of its edges.
        bounds: (u0, u1, v0, v1) of the trimmed face.
        outward: +1 where the surface's own normal points out of the solid, else -1.
    """

    @property
    def solid(self) -> int: ...
    @property
    def kind(self) -> SurfaceKind | None: ...
    @property
    def area(self) -> float: ...
    @property
    def centre(self) -> FloatArray: ...
    @property
    def elementary(self) -> Elementary | None: ...
    @property
    def edges(self) -> tuple[int, ...]: ...
    @property
    def bounds(self) -> tuple[float, float, float, float]: ...
    @property
    def outward(self) -> float: ...

    def derivatives(self, uv: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Points (k, 3) and the two first derivatives (k, 3) at the parameters (k, 2)."""
        ...

    def rim_uv(self, edge: int, side: int, parameters: FloatArray) -> FloatArray:
        """(k, 2) surface parameters of the edge's points, from its curve in parameter space."""
        ...


class Shape(Protocol):
    """A shape that a kernel has read.

    Attributes:
        unit: length unit of the file, already applied: coordinates are mm.
        notes: what the user should know of the reading.
        faces: in TopExp order over the whole shape (FreeCAD's ``Face1`` ...).
        solid_count: number of solids.
        diagonal: of the bounding box, mm (the box may be a little larger than the shape).
    """

    @property
    def unit(self) -> str: ...
    @property
    def notes(self) -> tuple[str, ...]: ...
    @property
    def faces(self) -> Sequence[BrepFace]: ...
    @property
    def solid_count(self) -> int: ...
    @property
    def diagonal(self) -> float: ...

    def tessellate(self, linear: float, angular: float) -> list[Patch]:
        """A patch for each face, by BRepMesh with these deflections (mm, rad)."""
        ...

    def edge_points(self, edge: int, parameters: FloatArray) -> FloatArray:
        """(k, 3) points of an edge's curve."""
        ...

    def write_brep(self, path: Path, faces: Sequence[int]) -> None:
        """Write these faces, in this order, as an OCCT BREP file without triangulation."""
        ...
