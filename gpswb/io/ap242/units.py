# SPDX-License-Identifier: LGPL-2.1-or-later
"""Units of a representation's context (ISO 10303-41), as factors to mm and radians."""

from __future__ import annotations

import math
from dataclasses import dataclass

from gpswb.errors import InputError
from gpswb.io.ap242.part21 import Part21, Ref, Typed, Value

_PREFIX = {
    "EXA": 1e18, "PETA": 1e15, "TERA": 1e12, "GIGA": 1e9, "MEGA": 1e6, "KILO": 1e3, "HECTO": 1e2,
    "DECA": 1e1, "DECI": 1e-1, "CENTI": 1e-2, "MILLI": 1e-3, "MICRO": 1e-6, "NANO": 1e-9,
    "PICO": 1e-12, "FEMTO": 1e-15, "ATTO": 1e-18,
}  # fmt: skip
_DEEPEST = 8


@dataclass(frozen=True)
class Units:
    """Length and angle units: their entities, None where the file has none; mm and rad a unit."""

    length: Ref | None = None
    angle: Ref | None = None
    mm: float = 1.0
    rad: float = 1.0


def units_of(file: Part21, context: Value) -> Units:
    """Units of a representation context; mm and radians where it says nothing."""
    assigned = file.get(context, "GLOBAL_UNIT_ASSIGNED_CONTEXT")
    units = assigned[0] if assigned and isinstance(assigned[0], tuple) else ()
    length = angle = None
    mm = rad = 1.0
    for unit in units:
        if not isinstance(unit, Ref) or unit not in file:
            continue
        keywords = file.keywords(unit)
        if "LENGTH_UNIT" in keywords:
            length, mm = unit, 1000.0 * factor(file, unit)
        elif "PLANE_ANGLE_UNIT" in keywords:
            angle, rad = unit, factor(file, unit)
    return Units(length, angle, mm, rad)


def factor(file: Part21, unit: Value, deep: int = _DEEPEST) -> float:
    """How many SI units (m, rad) a unit is.

    Raises:
        InputError: the unit is made of other things than SI units and conversions of them.
    """
    si = file.get(unit, "SI_UNIT")
    if si is not None:
        words = [str(value) for value in si if value is not None and value != "*"]
        return _PREFIX.get(words[0], 1.0) if len(words) > 1 else 1.0
    converted = file.get(unit, "CONVERSION_BASED_UNIT")
    if converted is not None and len(converted) > 1 and deep:
        measure = measure_of(file, converted[1])
        if measure is not None:
            value, base = measure
            return value * factor(file, base, deep - 1)
    raise InputError(f"the STEP file's unit {_spelt(unit)} can't be understood")


def measure_of(file: Part21, number: Value) -> tuple[float, Value] | None:
    """Value and unit of a measure with unit, in whichever of its forms; None if it is none."""
    if not isinstance(number, Ref) or number not in file:
        return None
    for keyword, parameters in file[number].items():
        if keyword.endswith("MEASURE_WITH_UNIT") or keyword == "MEASURE_REPRESENTATION_ITEM":
            for i, value in enumerate(parameters):
                plain = number_of(value)
                if plain is not None and i + 1 < len(parameters):
                    return plain, parameters[i + 1]
    return None


def number_of(value: Value) -> float | None:
    """A number, bare or typed; None for anything else."""
    if isinstance(value, Typed) and len(value.parameters) == 1:
        value = value.parameters[0]
    if isinstance(value, int | float) and not isinstance(value, Ref) and math.isfinite(value):
        return float(value)
    return None


def _spelt(unit: Value) -> str:
    return f"#{int(unit)}" if isinstance(unit, Ref) else repr(unit)
