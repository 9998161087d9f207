# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh with a colour a facet, as nodes of FreeCAD's scene graph."""

from __future__ import annotations

from typing import Any

import numpy as np
from pivy import coin

from gpswb.core.mesh import BoolArray, IntArray, Mesh
from gpswb.gui import compat
from gpswb.gui.colouring import Colouring


class FacetScene:
    """The nodes, below ``root``.

    Args:
        mesh: the mesh, mm.
        colours: those of its facets.
        region: (m,) number of each facet's region, between which there are dark borders.
        edges: whether facets have dark edges, too; they cover the colours where facets are small.
    """

    def __init__(self, mesh: Mesh, colours: Colouring, region: IntArray, edges: bool) -> None:
        self.root = coin.SoSeparator()
        self._faces = coin.SoIndexedFaceSet()
        self._marked = np.zeros(len(mesh.triangles), dtype=bool)
        # Each colour once, and an index a facet. The colour of the label -1 is the last of the
        # palette; that of what is selected stands behind it.
        last = len(colours.palette) - 1
        self._index = np.where(colours.of_facet < 0, last, colours.of_facet)
        self._selected = last + 1
        shading = coin.SoShapeHints()
        shading.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        shading.creaseAngle = 0.0  # facets are what is to be seen
        material = coin.SoMaterial()
        shades = [*colours.palette.tolist(), list(compat.selection_colour())]
        material.diffuseColor.setValues(0, len(shades), shades)
        binding = coin.SoMaterialBinding()
        binding.value = coin.SoMaterialBinding.PER_FACE_INDEXED
        points = coin.SoCoordinate3()
        points.point.setValues(0, len(mesh.vertices), mesh.vertices.astype(np.float32))
        corners = np.full((len(mesh.triangles), 4), -1)
        corners[:, :3] = mesh.triangles
        self._faces.coordIndex.setValues(0, corners.size, corners.ravel().tolist())
        self._faces.materialIndex.setValues(0, len(self._index), self._index.tolist())
        # The facets lie a little behind their own edges, which are drawn over them.
        behind, filled = coin.SoPolygonOffset(), coin.SoSeparator()
        for node in (behind, shading, material, binding, self._faces):
            filled.addChild(node)
        self.root.addChild(points)
        self.root.addChild(filled)
        self.root.addChild(_borders(mesh, region))
        if edges:
            self.root.addChild(_edges(self._faces))

    def highlight(self, marked: BoolArray) -> None:
        """Give the facets where (m,) ``marked`` is true the colour of what is selected."""
        if np.array_equal(marked, self._marked):
            return
        self._marked = marked
        index = np.where(marked, self._selected, self._index)
        self._faces.materialIndex.setValues(0, len(index), index.tolist())


def _edges(faces: Any) -> Any:
    """The edges of all facets."""
    edges = coin.SoIndexedFaceSet()
    edges.coordIndex.connectFrom(faces.coordIndex)
    return _dark(edges, 1.0)


def _borders(mesh: Mesh, region: IntArray) -> Any:
    """The edges between regions."""
    one, other = region[mesh.facet_pairs].T
    ends = mesh.pair_edges[one != other]
    lines = np.full((len(ends), 3), -1)
    lines[:, :2] = ends
    borders = coin.SoIndexedLineSet()
    borders.coordIndex.setValues(0, lines.size, lines.ravel().tolist())
    return _dark(borders, 2.0)


def _dark(shape: Any, width: float) -> Any:
    """A shape in dark lines, pixels wide."""
    dark, flat, style = coin.SoBaseColor(), coin.SoLightModel(), coin.SoDrawStyle()
    dark.rgb.setValue(0.1, 0.1, 0.1)
    flat.model = coin.SoLightModel.BASE_COLOR
    style.style, style.lineWidth = coin.SoDrawStyle.LINES, width
    inside = coin.SoSeparator()
    for node in (dark, flat, style, shape):
        inside.addChild(node)
    return inside
