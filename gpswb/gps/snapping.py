# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nearly parallel, perpendicular and coplanar directions made exact before ranks are taken."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from gpswb.core.mesh import FloatArray
from gpswb.gps.twists import SituationFeature, vector

# With more directions nearly every new one is close to some plane of two others.
_MOST_PLANES = 12


def snap_directions(
    features: Sequence[SituationFeature], angle: float
) -> tuple[SituationFeature, ...]:
    """Turn each direction by at most ``angle`` (rad) to agree with those before it.

    Two planes 0.05° from parallel are meant parallel; left alone their union is prismatic instead
    of planar. Earlier features never move, so a datum keeps its direction whatever is compared with
    it. Order them by trust: datum precedence, or area.
    """
    near = float(np.sin(angle))
    seen: list[FloatArray] = []
    poles: list[FloatArray] = []
    snapped = []
    for feature in features:
        if not feature.directed:
            snapped.append(feature)
            continue
        d, known = _snap(np.asarray(feature.direction, dtype=np.float64), poles, near)
        if not known:
            if len(seen) < _MOST_PLANES:
                normals = [np.cross(d, other) for other in seen]
                poles += [n / np.linalg.norm(n) for n in normals]
            seen.append(d)
            poles.insert(len(seen) - 1, d)
        snapped.append(replace(feature, direction=vector(d)))
    return tuple(snapped)


def _snap(d: FloatArray, poles: list[FloatArray], near: float) -> tuple[FloatArray, bool]:
    """``d`` snapped to a pole, or into the plane across one; and whether it is a pole itself."""
    d = d / np.linalg.norm(d)
    if not poles:
        return d, False
    table = np.array(poles)
    along = table @ d
    across = np.linalg.norm(np.cross(table, d), axis=1)
    nearest = int(np.argmin(across))
    if across[nearest] <= near:
        return np.copysign(1.0, along[nearest]) * table[nearest], True
    square = np.flatnonzero(np.abs(along) <= near)
    if len(square):
        d = d - along[square[0]] * table[square[0]]
    return d / np.linalg.norm(d), False
