# SPDX-License-Identifier: LGPL-2.1-or-later
"""Integer arrays packed small for a page: differences, byte planes, deflate, base64."""

from __future__ import annotations

import base64
import zlib
from typing import Any

import numpy as np
import numpy.typing as npt


def pack(values: npt.ArrayLike) -> dict[str, Any]:
    """Pack integers that fit 32 bits, row by row: ``{"length": n, "data": base64}``.

    Neighbours differ little in meshes, so that most byte planes of the differences are nearly
    constant; part_view.js holds the inverse.
    """
    flat = np.asarray(values).astype(np.int32).reshape(-1)
    with np.errstate(over="ignore"):
        steps = np.diff(flat, prepend=np.int32(0)).astype("<i4")
    planes = steps.view(np.uint8).reshape(-1, 4).T
    packed = zlib.compress(np.ascontiguousarray(planes).tobytes(), 6)
    return {"length": len(flat), "data": base64.b64encode(packed).decode("ascii")}
