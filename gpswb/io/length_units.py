# SPDX-License-Identifier: LGPL-2.1-or-later
"""Units of length that a measured file may be in."""

from __future__ import annotations

from collections.abc import Mapping

MILLIMETRES: Mapping[str, float] = {
    "um": 1e-3, "mm": 1.0, "cm": 10.0, "m": 1000.0, "inch": 25.4, "foot": 304.8,
}  # fmt: skip
"""Millimetres of each unit."""

SPELLINGS: Mapping[str, str] = {
    "micron": "um", "millimeter": "mm", "centimeter": "cm", "meter": "m",
}  # fmt: skip
"""Units as a 3MF states them, where they differ (3MF core specification, 3.4)."""
