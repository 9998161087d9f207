# SPDX-License-Identifier: LGPL-2.1-or-later
"""gmsh's part of the near-uniform mesher, run in a process of its own (gmsh may crash or hang)."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from gpswb.core.mesh import FloatArray, IntArray

_SAMPLE = 40
"""Triangles of a face whose orientation is compared with the surface's normal."""


def mesh_brep(brep: str, out: str, size: float, smallest: float, per_turn: float) -> dict[str, Any]:
    """Mesh all faces of a BREP file and save ``vertices``, ``triangles`` and ``face`` as npz.

    Triangles run counter-clockwise about the surface's own normal.

    Args:
        brep: file with a compound of faces.
        out: npz file to write.
        size: edge length, mm.
        smallest: least edge length that curvature may ask for, mm.
        per_turn: least number of elements per full turn; 0 for none.

    Returns:
        ``area`` and ``centre`` of each face as gmsh sees them, in its order.
    """
    import gmsh

    gmsh.initialize(["gpswb", "-nopopup"], False, False, False)
    options = {
        "General.Terminal": 0,
        "General.NumThreads": 1,
        "Geometry.OCCFixDegenerated": 0,
        "Geometry.OCCFixSmallEdges": 0,
        "Geometry.OCCFixSmallFaces": 0,
        "Geometry.OCCSewFaces": 0,
        "Geometry.OCCMakeSolids": 0,
        "Mesh.Algorithm": 6,
        "Mesh.MeshSizeMax": size,
        "Mesh.MeshSizeMin": smallest,
        "Mesh.MeshSizeFromCurvature": per_turn,
        "Mesh.MeshSizeExtendFromBoundary": 0,
        "Mesh.MeshSizeFromPoints": 0,
        "Mesh.ElementOrder": 1,
    }
    for name, value in options.items():
        gmsh.option.setNumber(name, value)
    gmsh.model.occ.importShapes(brep, highestDimOnly=False, format="brep")
    gmsh.model.occ.synchronize()
    tags = [tag for _, tag in gmsh.model.getEntities(2)]
    about = [
        (gmsh.model.occ.getMass(2, tag), list(gmsh.model.occ.getCenterOfMass(2, tag)))
        for tag in tags
    ]
    try:
        gmsh.model.mesh.generate(2)
    except Exception as error:
        # Some faces failed; the others are meshed. The caller sees which have no triangles.
        if not str(error):
            raise
    node, coordinates, _ = gmsh.model.mesh.getNodes()
    rank = np.zeros(int(node.max(initial=0)) + 1, dtype=np.int64)
    rank[node] = np.arange(len(node))
    vertices = np.asarray(coordinates, dtype=np.float64).reshape(-1, 3)
    parts, owner = [], []
    for i, tag in enumerate(tags):
        _, nodes = gmsh.model.mesh.getElementsByType(2, tag)
        triangles = rank[np.asarray(nodes, dtype=np.int64)].reshape(-1, 3)
        parts.append(_along_normal(gmsh, tag, vertices, triangles))
        owner.append(np.full(len(triangles), i, dtype=np.int64))
    gmsh.finalize()
    triangles = np.concatenate([np.empty((0, 3), np.int64), *parts])
    np.savez(out, vertices=vertices, triangles=triangles, face=np.concatenate([[], *owner]))
    return {"area": [a for a, _ in about], "centre": [c for _, c in about]}


def _along_normal(gmsh: Any, tag: int, vertices: FloatArray, triangles: IntArray) -> IntArray:
    """Turn the triangles over if most of a sample look against the surface's normal."""
    if not len(triangles):
        return triangles
    pick = triangles[:: math.ceil(len(triangles) / _SAMPLE)]
    corner = vertices[pick]
    cross = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    middle = corner.mean(axis=1)
    uv = gmsh.model.getParametrization(2, tag, middle.ravel())
    normal = np.asarray(gmsh.model.getNormal(tag, uv)).reshape(-1, 3)
    turned = float((cross * normal).sum()) < 0
    return np.ascontiguousarray(triangles[:, ::-1]) if turned else triangles
