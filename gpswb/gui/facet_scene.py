# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh with a colour a facet, as nodes of FreeCAD's scene graph."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from pivy import coin

from gpswb.core.mesh import BoolArray, IntArray, Mesh
from gpswb.gui import compat
from gpswb.gui.aside import aside
from gpswb.gui.colouring import Colouring

CHUNK = 50_000
"""Facets a node: a node of so many is filled, and drawn for the first time, in some 50 ms. Each is
drawn as it is there, so that the window is never long at one."""
_NAME = "GpsFacets"


class FacetScene:
    """The nodes, below ``root``, which `fill` adds to it.

    Args:
        mesh: the mesh, mm.
        colours: those of its facets.
        region: (m,) number of each facet's region, between which there are dark borders.
        edges: whether facets have dark edges, too; they cover the colours where facets are small.
    """

    def __init__(self, mesh: Mesh, colours: Colouring, region: IntArray, edges: bool) -> None:
        self.root = coin.SoSeparator()
        self._mesh, self._region, self._edges = mesh, region, edges
        self._chunks: list[tuple[int, Any]] = []
        self._marked = np.zeros(len(mesh.triangles), dtype=bool)
        # Each colour once, and an index a facet. The colour of the label -1 is the last of the
        # palette; that of what is selected stands behind it.
        last = len(colours.palette) - 1
        self._index = np.where(colours.of_facet < 0, last, colours.of_facet).astype(np.int32)
        self._selected = last + 1
        self._points = coin.SoCoordinate3()
        shading = coin.SoShapeHints()
        shading.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        shading.creaseAngle = 0.0  # facets are what is to be seen
        material = coin.SoMaterial()
        shades = [*colours.palette.tolist(), list(compat.selection_colour())]
        material.diffuseColor.setValues(0, len(shades), shades)
        binding = coin.SoMaterialBinding()
        binding.value = coin.SoMaterialBinding.PER_FACE_INDEXED
        # The facets lie a little behind their own edges, which are drawn over them.
        self._filled = coin.SoSeparator()
        for node in (coin.SoPolygonOffset(), shading, material, binding):
            self._filled.addChild(node)
        self.root.addChild(self._points)
        self.root.addChild(self._filled)

    def fill(self) -> Iterator[None]:
        """Add what is to be seen, in slices: iterate to the end."""
        borders = yield from aside(lambda: _borders(self._mesh, self._region))
        vertices = self._mesh.vertices.astype(np.float32)
        self._points.point.setNum(len(vertices))
        for first in range(0, len(vertices), CHUNK):
            part = vertices[first : first + CHUNK]
            self._points.point.setValues(first, len(part), part)
            yield
        for first in range(0, len(self._mesh.triangles), CHUNK):
            triangles = self._mesh.triangles[first : first + CHUNK]
            corners = np.full((len(triangles), 4), -1, dtype=np.int32)
            corners[:, :3] = triangles
            faces = coin.SoIndexedFaceSet()
            faces.setName(f"{_NAME}{first}")
            faces.coordIndex.setValues(0, corners.size, corners.ravel().tolist())
            self._chunks.append((first, faces))
            self._colour(first, faces)
            alone = coin.SoSeparator()  # drawn from a cache of its own
            alone.addChild(faces)
            self._filled.addChild(alone)
            if self._edges:
                self.root.addChild(_edges(faces))
            yield
        lines = coin.SoIndexedLineSet()
        lines.coordIndex.setValues(0, len(borders), borders)
        self.root.addChild(_dark(lines, 2.0))

    def highlight(self, marked: BoolArray) -> None:
        """Give the facets where (m,) ``marked`` is true the colour of what is selected."""
        before, self._marked = self._marked, marked
        for first, faces in self._chunks:
            here = slice(first, first + CHUNK)
            if not np.array_equal(before[here], marked[here]):
                self._colour(first, faces)

    def facet_of(self, picked: Any) -> int | None:
        """The facet that a picked point lies on; None where it lies on none."""
        detail, name = picked.getDetail(), str(picked.getPath().getTail().getName())
        if not name.startswith(_NAME) or not detail.isOfType(coin.SoFaceDetail.getClassTypeId()):
            return None
        return int(name[len(_NAME) :]) + int(coin.cast(detail, "SoFaceDetail").getFaceIndex())

    def _colour(self, first: int, faces: Any) -> None:
        here = slice(first, first + CHUNK)
        index = np.where(self._marked[here], self._selected, self._index[here])
        faces.materialIndex.setValues(0, len(index), index.tolist())


def _edges(faces: Any) -> Any:
    """The edges of all facets of a node."""
    edges = coin.SoIndexedFaceSet()
    edges.coordIndex.connectFrom(faces.coordIndex)
    return _dark(edges, 1.0)


def _borders(mesh: Mesh, region: IntArray) -> list[int]:
    """The edges between regions, as indices of a line set."""
    one, other = region[mesh.facet_pairs].T
    ends = mesh.pair_edges[one != other]
    lines = np.full((len(ends), 3), -1)
    lines[:, :2] = ends
    found: list[int] = lines.ravel().tolist()
    return found


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
