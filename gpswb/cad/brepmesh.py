# SPDX-License-Identifier: LGPL-2.1-or-later
"""The deflection-based mesher: exactly what BRepMesh gives, welded (no vertex inside a face)."""

from __future__ import annotations

from gpswb.cad.kernel import Shape
from gpswb.cad.weld import Tessellation, weld


def brepmesh(shape: Shape, linear: float, angular: float) -> Tessellation:
    """Tessellate with a linear (mm) and an angular (rad) deflection.

    Faces for which BRepMesh finds no triangulation have no triangle in the result.
    """
    return weld(shape.tessellate(linear, angular), shape.faces)
