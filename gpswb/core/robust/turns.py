# SPDX-License-Identifier: LGPL-2.1-or-later
"""Turns of many vectors, small and finite."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import FloatArray

TINY = 1e-12
"""Length below which a vector has no direction."""


def lengths(v: FloatArray) -> FloatArray:
    """(b,) lengths of (b, 3) vectors."""
    length: FloatArray = np.sqrt(np.einsum("bk,bk->b", v, v))
    return length


def turning(v: FloatArray) -> FloatArray:
    """(b, 3, 3) change of (b, 3) vectors v with turns about the axes e: e × v as columns."""
    out = np.zeros((len(v), 3, 3))
    out[:, 1, 0], out[:, 2, 0] = -v[:, 2], v[:, 1]
    out[:, 0, 1], out[:, 2, 1] = v[:, 2], -v[:, 0]
    out[:, 0, 2], out[:, 1, 2] = -v[:, 1], v[:, 0]
    return out


def turned(vectors: FloatArray, turn: FloatArray) -> FloatArray:
    """(k, b, 3) vectors turned by (b, 3) rotation vectors (Rodrigues)."""
    angle = lengths(turn)
    unit = turn / np.maximum(angle, TINY)[:, None]
    against = turning(unit)  # against @ v is v × unit
    cos, sin = np.cos(angle)[:, None, None], np.sin(angle)[:, None, None]
    rotation = (1.0 - cos) * (against @ against) - sin * against
    turned: FloatArray = vectors + np.einsum("bij,kbj->kbi", rotation, vectors)
    return turned
