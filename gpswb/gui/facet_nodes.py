# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh with a colour a facet, as nodes of FreeCAD's scene graph."""

from __future__ import annotations

from typing import Any

import numpy as np
from pivy import coin

from gpswb.core.mesh import FloatArray, Mesh


def facet_nodes(mesh: Mesh, colours: FloatArray) -> Any:
    """A separator with the mesh.

    Args:
        mesh: the mesh, mm.
        colours: (m, 3) red, green, blue of each facet.
    """
    root = coin.SoSeparator()
    shading = coin.SoShapeHints()
    shading.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    shading.creaseAngle = 0.0  # facets are what is to be seen
    material = coin.SoMaterial()
    # Each colour once, and an index a facet: a hundredth of the data.
    distinct, index = np.unique(colours, axis=0, return_inverse=True)
    material.diffuseColor.setValues(0, len(distinct), distinct.tolist())
    binding = coin.SoMaterialBinding()
    binding.value = coin.SoMaterialBinding.PER_FACE_INDEXED
    points = coin.SoCoordinate3()
    points.point.setValues(0, len(mesh.vertices), mesh.vertices.tolist())
    faces = coin.SoIndexedFaceSet()
    corners = np.full((len(mesh.triangles), 4), -1)
    corners[:, :3] = mesh.triangles
    faces.coordIndex.setValues(0, corners.size, corners.ravel().tolist())
    faces.materialIndex.setValues(0, len(index), index.ravel().tolist())
    # The facets lie a little behind their own edges, which are drawn over them.
    behind, filled = coin.SoPolygonOffset(), coin.SoSeparator()
    for node in (behind, shading, material, binding, faces):
        filled.addChild(node)
    dark, flat, outline = coin.SoBaseColor(), coin.SoLightModel(), coin.SoDrawStyle()
    dark.rgb.setValue(0.1, 0.1, 0.1)
    flat.model = coin.SoLightModel.BASE_COLOR
    outline.style = coin.SoDrawStyle.LINES
    edges, wire = coin.SoIndexedFaceSet(), coin.SoSeparator()
    edges.coordIndex.connectFrom(faces.coordIndex)
    for node in (dark, flat, outline, edges):
        wire.addChild(node)
    for node in (points, filled, wire):
        root.addChild(node)
    return root
