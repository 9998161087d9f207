# SPDX-License-Identifier: LGPL-2.1-or-later
"""Axes of a view, and the placement that keeps them in a document."""

from __future__ import annotations

from typing import Any

import FreeCAD
import numpy as np

from gpswb.core.mesh import FloatArray


def axes_of(placement: Any) -> FloatArray:
    """(3, 3) rows: right, up and towards the user for a camera that is turned like this."""
    turn = placement.Rotation
    unit = np.eye(3).tolist()
    return np.array([tuple(turn.multVec(FreeCAD.Vector(*axis))) for axis in unit])


def placement_of(axes: FloatArray) -> Any:
    """The placement of which `axes_of` gives these."""
    matrix = np.eye(4)
    matrix[:3, :3] = axes.T
    return FreeCAD.Placement(FreeCAD.Matrix(*matrix.ravel().tolist()))
