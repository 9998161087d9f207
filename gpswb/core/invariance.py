# SPDX-License-Identifier: LGPL-2.1-or-later
"""The seven ISO GPS invariance classes (ISO 17450-1; paper, Table 2): one vocabulary for all."""

from __future__ import annotations

from typing import Literal, get_args

InvarianceClass = Literal[
    "planar", "cylindrical", "spherical", "revolute", "prismatic", "helical", "complex"
]

CLASSES: tuple[InvarianceClass, ...] = get_args(InvarianceClass)
"""Order used for every integer class label (`labels.npz`, confusion matrices)."""

DIMENSION: dict[InvarianceClass, int] = {
    "planar": 3,
    "cylindrical": 2,
    "spherical": 3,
    "revolute": 1,
    "prismatic": 1,
    "helical": 1,
    "complex": 0,
}
"""Dimension of the group of motions that leave a surface of the class in place (helical: 1, where
the paper's Table 2 prints 2)."""
