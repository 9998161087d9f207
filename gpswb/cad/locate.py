# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make positions and parameters of a tessellation agree along the B-rep edges.

A B-rep promises that an edge's curve in space, its curves in the parameter spaces of its faces and
its vertices coincide; files break the promise by whole millimetres. BRepMesh takes the parameters
from the one and the positions from the other. Refinement works in parameter space: there vertices
would lie in another order than in space, and triangles would fold.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from gpswb.cad.groups import groups
from gpswb.cad.kernel import Shape
from gpswb.cad.surface import nearest_uv, outward_normals
from gpswb.cad.weld import Tessellation
from gpswb.core.mesh import FloatArray

AGREE = 1e-6
"""Distance up to which positions agree, as a fraction of the diagonal."""


def locate(mesh: Tessellation, shape: Shape) -> Tessellation:
    """Put vertices on their edges' curves, and find the parameters of these points on each face.

    A B-rep vertex that lies off its edges' curves moves to the middle of their ends.
    """
    mesh = replace(mesh, vertices=_on_curves(mesh, shape))
    uv, normal = mesh.uv.copy(), mesh.normal.copy()
    rim = mesh.edge >= 0
    corner = (rim | np.roll(rim, 1, axis=1)) & (mesh.free == 0)
    row, k = np.nonzero(corner)
    for (f,), group in groups(mesh.face[row][:, None]):
        face = shape.faces[f]
        at = row[group], k[group]
        if face.kind is None or np.isnan(uv[at]).any():
            continue
        found = nearest_uv(face, mesh.vertices[mesh.triangles[at]], uv[at], AGREE * shape.diagonal)
        moved = (found != uv[at]).any(axis=1)
        at = at[0][moved], at[1][moved]
        uv[at] = found[moved]
        normal[at] = outward_normals(face, uv[at])
    return replace(mesh, uv=uv, normal=normal)


def _on_curves(mesh: Tessellation, shape: Shape) -> FloatArray:
    """(n, 3) positions: the mean of the edges' points at each vertex where it is off them."""
    row, k = np.nonzero(mesh.edge >= 0)
    edge = np.repeat(mesh.edge[row, k], 2)
    t = mesh.ends[row, k].ravel()
    vertex = np.stack([mesh.triangles[row, k], mesh.triangles[row, (k + 1) % 3]], axis=1).ravel()
    # Each end of an edge counts once, in however many triangles it occurs.
    _, once = np.unique(np.column_stack([vertex, edge]), axis=0, return_index=True)
    edge, t, vertex = edge[once], t[once], vertex[once]
    points = np.empty((len(edge), 3))
    for (e,), group in groups(edge[:, None]):
        points[group] = shape.edge_points(e, t[group])
    vertices = mesh.vertices.copy()
    gap = np.linalg.norm(points - vertices[vertex], axis=1)
    off = np.unique(vertex[gap > AGREE * shape.diagonal])
    count = np.bincount(vertex, minlength=len(vertices))
    for axis in range(3):
        total = np.bincount(vertex, points[:, axis], minlength=len(vertices))
        vertices[off, axis] = total[off] / count[off]
    return vertices
