# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points, directions and placements (ISO 10303-42) as arrays in mm."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import FloatArray
from gpswb.errors import InputError
from gpswb.io.ap242.part21 import Part21, Value
from gpswb.io.ap242.units import number_of


def point(file: Part21, number: Value, mm: float) -> FloatArray:
    """(3,) a CARTESIAN_POINT or the point of a VERTEX_POINT.

    Raises:
        InputError: it is neither.
    """
    vertex = file.get(number, "VERTEX_POINT")
    found = file.get(vertex[1] if vertex else number, "CARTESIAN_POINT")
    return _three(found[1] if found else None, number) * mm


def direction(file: Part21, number: Value) -> FloatArray | None:
    """(3,) unit vector of a DIRECTION; None where it isn't given or has no length."""
    found = file.get(number, "DIRECTION")
    if found is None:
        return None
    vector = _three(found[1], number)
    length = float(np.linalg.norm(vector))
    return vector / length if length > 0 else None


def placement(file: Part21, number: Value, mm: float) -> FloatArray:
    """(4, 4) frame of an AXIS2_PLACEMENT_3D: columns x, y, z and origin; else the identity."""
    found = file.get(number, "AXIS2_PLACEMENT_3D")
    frame = np.eye(4)
    if found is None:
        return frame
    z = direction(file, found[2])
    z = np.array([0.0, 0.0, 1.0]) if z is None else z
    x = direction(file, found[3])
    x = np.array([1.0, 0.0, 0.0]) if x is None else x
    x = x - z * (x @ z)
    if np.linalg.norm(x) < 1e-9:
        x = np.cross(np.eye(3)[np.argmin(np.abs(z))], z)
    x = x / np.linalg.norm(x)
    frame[:3, 0], frame[:3, 1], frame[:3, 2] = x, np.cross(z, x), z
    frame[:3, 3] = point(file, found[1], mm)
    return frame


def _three(values: Value, number: Value) -> FloatArray:
    plain = [number_of(v) for v in values] if isinstance(values, tuple) else []
    if not 1 <= len(plain) <= 3 or None in plain:
        raise InputError(f"entity #{number} of the STEP file is no point or direction")
    return np.array([v for v in plain if v is not None] + [0.0] * (3 - len(plain)))
