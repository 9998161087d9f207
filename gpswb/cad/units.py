# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names of length units as STEP files spell them."""

from __future__ import annotations

import re

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


_METRE = re.compile(rb"SI_UNIT\s*\(\s*(\$|\.\w+\.)\s*,\s*\.METRE\.\s*\)", re.IGNORECASE)
_CONVERSION = re.compile(rb"CONVERSION_BASED_UNIT\s*\(\s*'([^']*)'", re.IGNORECASE)
_ENTITY = re.compile(rb"#(\d+)\s*=\s*([^;]*LENGTH_UNIT[^;]*);", re.IGNORECASE)
_CONTEXT = re.compile(rb"GLOBAL_UNIT_ASSIGNED_CONTEXT\s*\(\s*\(([^)]*)\)", re.IGNORECASE)
_PREFIX = {"$": "m", ".MILLI.": "mm", ".CENTI.": "cm", ".KILO.": "km", ".MICRO.": "um"}


def step_units(text: bytes) -> list[str]:
    """Length units that the contexts of a STEP file assign, each once, in the file's order.

    Args:
        text: the file's bytes.
    """
    entity = dict(_ENTITY.findall(text))
    found: list[str] = []
    for context in _CONTEXT.findall(text):
        for number in re.findall(rb"#(\d+)", context):
            name = _length_unit(entity.get(number, b""))
            if name and name not in found:
                found.append(name)
    return found


def _length_unit(entity: bytes) -> str | None:
    conversion = _CONVERSION.search(entity)
    if conversion:
        return unit_name(conversion.group(1).decode("ascii", "replace"))
    metre = _METRE.search(entity)
    if not metre:
        return None
    prefix = metre.group(1).decode().upper()
    return _PREFIX.get(prefix, prefix.strip(".").lower() + "metre")
