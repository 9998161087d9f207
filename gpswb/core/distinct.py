# SPDX-License-Identifier: LGPL-2.1-or-later
"""The different ones of many whole numbers."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from gpswb.core.mesh import IntArray


def distinct(numbers: npt.NDArray[np.signedinteger[Any]]) -> IntArray:
    """The different ones of (n,) numbers, ascending; several times faster than numpy's `unique`."""
    ordered = np.sort(numbers)
    first = np.ones(len(ordered), dtype=bool)
    np.not_equal(ordered[1:], ordered[:-1], out=first[1:])
    found: IntArray = ordered[first].astype(np.int64, copy=False)
    return found
