# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is partitioned: tessellated shapes whose triangles know their B-rep face, measured parts."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray, IntArray, Mesh


@dataclass(frozen=True)
class FaceTruth:
    """Ground truth of a B-rep face from its exact surface (design: two truths).

    Args:
        surface: kind of the CAD surface: Plane, Cylinder, Cone, Sphere, Torus, BSpline, Bezier,
            Revolution, Extrusion, Offset, Other.
        exact: class of the unbounded support surface at 1e-10.
        nominal: class within CAD tolerance; what validation compares against.
        parameters: the numbers of the surface (mm, unit vectors) for uniting equal surfaces:
            ``point``, ``direction``, ``radius``, ...; empty where unknown.
        ambiguous: the two truths differ, or the residual lies in no clear gap.
    """

    surface: str
    exact: InvarianceClass
    nominal: InvarianceClass
    parameters: Mapping[str, tuple[float, ...]]
    ambiguous: bool = False


@dataclass(frozen=True)
class Face:
    """A B-rep face: its FreeCAD name (``Face1`` ... in TopExp order), area (mm²) and truth."""

    name: str
    area: float
    solid: int
    truth: FaceTruth | None


@dataclass(frozen=True, eq=False)
class FaceMap:
    """Which face each triangle came from. Never enters ``core``: validation would be circular.

    Args:
        face_of_triangle: (m,) int64, 0-based index into ``faces``; -1 for none.
        faces: all faces of the shape read, in TopExp order over all solids together.
        feature_of_face: (f,) int64, faces with the same number are one maximal integral feature
            (adjacent faces on the same surface).
    """

    face_of_triangle: IntArray
    faces: tuple[Face, ...]
    feature_of_face: IntArray

    def __post_init__(self) -> None:
        if len(self.feature_of_face) != len(self.faces):
            raise ValueError(
                f"feature_of_face has {len(self.feature_of_face)} rows for {len(self.faces)} faces"
            )
        if len(self.face_of_triangle) and np.max(self.face_of_triangle) >= len(self.faces):
            raise ValueError(
                f"a triangle names face {np.max(self.face_of_triangle)} of {len(self.faces)}"
            )


@dataclass(frozen=True, eq=False)
class PointMap:
    """Where each point of a measured cloud went.

    Args:
        points: (n, 3) as read, mm; may hold points that are not finite.
        vertex_of_point: (n,) int64 the vertex of the mesh that stands for it; -1 for points set
            aside.
    """

    points: FloatArray
    vertex_of_point: IntArray

    def __post_init__(self) -> None:
        if len(self.points) != len(self.vertex_of_point):
            raise ValueError(f"{len(self.vertex_of_point)} vertices for {len(self.points)} points")


@dataclass(frozen=True, eq=False)
class Solid:
    """A tessellated shape or a measured part with everything that is known of where it came from.

    Args:
        mesh: the welded mesh of the whole shape, mm.
        facemap: provenance of the triangles; None for a mesh input.
        source: path as given.
        unit: unit of the file (``mm``, ``m``, ``inch`` ...), already applied.
        density: the density asked for, in the command line's words.
        mesher: what made the mesh, fallbacks included (``brepmesh+refine``, ``gmsh`` ...).
        notes: what the user should know (a face without triangles, a fallback, a skipped face).
        sha256: of the input file.
        timings: seconds for ``read`` and ``tessellate``.
        pointmap: provenance of the vertices; None unless the input is a point cloud.
    """

    mesh: Mesh
    facemap: FaceMap | None
    source: str
    unit: str
    density: str
    mesher: str
    notes: tuple[str, ...]
    sha256: str
    timings: Mapping[str, float]
    pointmap: PointMap | None = None
