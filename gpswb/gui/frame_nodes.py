# SPDX-License-Identifier: LGPL-2.1-or-later
"""A frame with its leader, as nodes of FreeCAD's scene graph.

The frame is a picture that keeps its size on the screen and stands before everything; leader and
terminator are drawn full where they are seen and broken where the part hides them. A leader ends in
a dot (ISO 1101, within the outline), a datum feature's in a filled triangle (ISO 5459).
"""

from __future__ import annotations

from typing import Any

import numpy as np
from pivy import coin

from gpswb.core.mesh import FloatArray

_LIFT = 0.002
"""Terminators stand off the surface by this fraction of the leader, or facets would hide them."""
_HIDDEN = 0xCCCC
"""Pattern of a hidden line."""


def frame_nodes(
    picture: Any,
    anchor: FloatArray,
    normal: FloatArray,
    place: FloatArray,
    mark: float,
    axes: FloatArray,
) -> Any:
    """A separator with frame and leader, left out of the scene's extent.

    Args:
        picture: a QImage of the format RGBA8888.
        anchor, normal: (3,) end of the leader on the part, mm, and outward direction there.
        place: (3,) where the frame stands.
        mark: height of the triangle that the leader ends in, mm; 0 for a dot.
        axes: (3, 3) rows: right, up and towards the user in the view that this is laid out for.
    """
    right, _, towards = axes
    length = float(np.linalg.norm(place - anchor))
    end = anchor + _LIFT * length * normal
    start = end
    triangle = None
    if mark:
        across = np.cross(normal, towards)
        if np.linalg.norm(across) < 0.1:
            across = right
        across = across / np.linalg.norm(across) * mark * 0.6
        start = end + mark * normal
        triangle = np.array([end - across, end + across, start])
    seen, hidden = coin.SoSeparator(), coin.SoSeparator()
    seen.addChild(_style(2.0))
    _leader(seen, np.array([start, place]))
    hidden.addChild(_style(1.0, _HIDDEN))
    _leader(hidden, np.array([start, place]))
    if triangle is None:
        _dot(seen, end, "CIRCLE_FILLED_9_9")
        _dot(hidden, end, "CIRCLE_LINE_9_9")
    else:
        _triangle(seen, triangle)
        _leader(hidden, triangle[[0, 1, 2, 0]])
    before = coin.SoAnnotation()
    before.addChild(_ink())
    before.addChild(hidden)
    before.addChild(_image(picture, place, is_on_the_left(place, anchor, axes)))
    root = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()
    inner = coin.SoSeparator()
    inner.addChild(_ink())
    inner.addChild(seen)
    inner.addChild(before)
    root.addChild(inner)
    return root


def is_on_the_left(place: FloatArray, anchor: FloatArray, axes: FloatArray) -> bool:
    """Whether a frame stands at the left of what it points at, so that its right edge is there."""
    return bool((place - anchor) @ axes[0] < 0)


def _ink() -> Any:
    group, flat, colour = coin.SoGroup(), coin.SoLightModel(), coin.SoBaseColor()
    flat.model = coin.SoLightModel.BASE_COLOR
    colour.rgb.setValue(0.0, 0.0, 0.0)
    group.addChild(flat)
    group.addChild(colour)
    return group


def _style(width: float, pattern: int = 0xFFFF) -> Any:
    style = coin.SoDrawStyle()
    style.lineWidth = width
    style.linePattern = pattern
    return style


def _leader(parent: Any, points: FloatArray) -> None:
    places, line = coin.SoCoordinate3(), coin.SoLineSet()
    places.point.setValues(0, len(points), points.tolist())
    line.numVertices.setValue(len(points))
    parent.addChild(places)
    parent.addChild(line)


def _dot(parent: Any, point: FloatArray, marker: str) -> None:
    places, dot = coin.SoCoordinate3(), coin.SoMarkerSet()
    places.point.setValues(0, 1, [point.tolist()])
    dot.markerIndex = getattr(coin.SoMarkerSet, marker)
    parent.addChild(places)
    parent.addChild(dot)


def _triangle(parent: Any, corners: FloatArray) -> None:
    hints, places, face = coin.SoShapeHints(), coin.SoCoordinate3(), coin.SoFaceSet()
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    hints.shapeType = coin.SoShapeHints.UNKNOWN_SHAPE_TYPE  # seen from both sides
    places.point.setValues(0, 3, corners.tolist())
    face.numVertices.setValue(3)
    for node in (hints, places, face):
        parent.addChild(node)


def _image(picture: Any, place: FloatArray, on_the_left: bool) -> Any:
    """The picture with its edge, left or right, at the end of the leader."""
    group, move, image = coin.SoSeparator(), coin.SoTranslation(), coin.SoImage()
    move.translation.setValue(*place.tolist())
    flipped = picture.mirrored()  # Coin's first row is the lowest
    size = coin.SbVec2s(flipped.width(), flipped.height())
    image.image.setValue(size, 4, bytes(flipped.constBits()))
    image.horAlignment = coin.SoImage.RIGHT if on_the_left else coin.SoImage.LEFT
    image.vertAlignment = coin.SoImage.HALF
    group.addChild(move)
    group.addChild(image)
    return group
