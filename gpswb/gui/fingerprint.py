# SPDX-License-Identifier: LGPL-2.1-or-later
"""A fingerprint of a part, that changes when its geometry does and at no other time."""

from __future__ import annotations

import hashlib
from typing import Any

import numpy as np

from gpswb.cad.freecad_measured import is_measurement, measurement_of

DIGITS = 9
"""Digits kept of lengths over the part's size: a file keeps some 15 of them."""


def fingerprint(source: Any) -> str:
    """Hash of a document object's shape, mesh or points."""
    if not is_measurement(source):
        return shape_fingerprint(source.Shape)
    part = measurement_of(source)
    found = hashlib.sha256(f"{len(part.vertices)} {len(part.triangles)}".encode())
    found.update(part.vertices.tobytes())
    found.update(part.triangles.tobytes())
    return found.hexdigest()


def shape_fingerprint(shape: Any) -> str:
    """Hash of a FreeCAD shape's vertices, edges and faces, in order.

    Its BREP text would not do: display meshes, flags and locations in it change by themselves.
    """
    vertices = [tuple(vertex.Point) for vertex in shape.Vertexes]
    lengths = [edge.Length for edge in shape.Edges]
    middles = [tuple(_middle(face)) for face in shape.Faces]
    numbers = np.array([x for point in (*vertices, *middles) for x in point] + lengths)
    size = float(np.abs(numbers).max(initial=0.0)) or 1.0
    whole = np.rint(numbers / size * 10**DIGITS).astype(np.int64)
    counts = f"{len(vertices)} {len(lengths)} {len(middles)} {size:.{DIGITS}e}"
    return hashlib.sha256(counts.encode() + whole.tobytes()).hexdigest()


def _middle(face: Any) -> Any:
    """The point at the middle of the face's parameters: none of its edges need lie on it."""
    u0, u1, v0, v1 = face.ParameterRange
    return face.valueAt((u0 + u1) / 2, (v0 + v1) / 2)
