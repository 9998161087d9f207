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


_SI = re.compile(rb"LENGTH_UNIT\s*\(\s*\)[^;]*?SI_UNIT\s*\(\s*(\$|\.\w+\.)\s*,\s*\.METRE\.\s*\)", re.I)
_SI_FIRST = re.compile(
    rb"SI_UNIT\s*\(\s*(\$|\.\w+\.)\s*,\s*\.METRE\.\s*\)[^;]*?LENGTH_UNIT\s*\(\s*\)", re.I
)
_CONVERSION = re.compile(
    rb"CONVERSION_BASED_UNIT\s*\(\s*'([^']*)'[^;]*?\)[^;]*?LENGTH_UNIT\s*\(\s*\)", re.I
)
_PREFIX = {b"$": "m", b".MILLI.": "mm", b".CENTI.": "cm", b".KILO.": "km", b".MICRO.": "um"}


def step_units(text: bytes) -> list[str]:
    """Length units that the contexts of a STEP file assign, each once, in the file's order.

    Args:
        text: the file's bytes.
    """
    entity = {
        m.group(1): m.group(2)
        for m in re.finditer(rb"#(\d+)\s*=\s*([^;]*UNIT[^;]*);", text, re.I)
    }
    found = []
    for context in re.finditer(
        rb"GLOBAL_UNIT_ASSIGNED_CONTEXT\s*\(\s*\(([^)]*)\)", text, re.I
    ):
        for number in re.findall(rb"#(\d+)", context.group(1)):
            name = _length_unit(entity.get(number, b""))
            if name and name not in found:
                found.append(name)
    return found


def _length_unit(entity: bytes) -> str | None:
    conversion = _CONVERSION.search(entity) or re.search(
        rb"LENGTH_UNIT\s*\(\s*\)[^;]*?CONVERSION_BASED_UNIT\s*\(\s*'([^']*)'", entity, re.I
    )
    if conversion:
        return unit_name(conversion.group(1).decode("ascii", "replace"))
    si = _SI.search(entity) or _SI_FIRST.search(entity)
    if not si:
        return None
    return _PREFIX.get(si.group(1).upper(), si.group(1).decode().strip(".").lower() + "metre")
