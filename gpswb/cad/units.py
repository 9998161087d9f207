# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names of length units as STEP files spell them."""

from __future__ import annotations

_SHORT = {
    "MILLIMETRE": "mm",
    "MILLIMETER": "mm",
    "CENTIMETRE": "cm",
    "CENTIMETER": "cm",
    "METRE": "m",
    "METER": "m",
    "KILOMETRE": "km",
    "MICROMETRE": "um",
    "INCH": "inch",
    "FOOT": "foot",
}


def unit_name(text: str) -> str:
    """``mm`` for ``MILLIMETRE``, ``inch`` for ``INCH`` and so on; an unknown name in lower case."""
    return _SHORT.get(text.strip().strip("'").upper(), text.strip().lower())
