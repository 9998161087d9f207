# SPDX-License-Identifier: LGPL-2.1-or-later
"""Unite adjacent faces on the same surface to maximal integral features."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gpswb.cad.kernel import Shape
from gpswb.cad.solid import FaceTruth
from gpswb.core.mesh import IntArray


def maximal_features(shape: Shape, truths: Sequence[FaceTruth | None]) -> IntArray:
    """(f,) feature of each face."""
    return np.arange(len(shape.faces), dtype=np.int64)
