# SPDX-License-Identifier: LGPL-2.1-or-later
"""Semantic PMI read from the entities of a STEP file.

OCCT's own reader leaves magnitudes and datum features out that some systems write (in the NIST
models: complex measure entities, sets of faces); here they are all read.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

from gpswb.cad.pmi import Pmi, PmiDatum, PmiSize, PmiTolerance, in_order
from gpswb.io.ap242.aspects import Aspects
from gpswb.io.ap242.match import FaceEntity
from gpswb.io.ap242.part21 import Part21, Record, Ref, Typed, Value
from gpswb.io.ap242.units import factor, measure_of

CHARACTERISTICS = {
    "STRAIGHTNESS_TOLERANCE": "straightness",
    "FLATNESS_TOLERANCE": "flatness",
    "ROUNDNESS_TOLERANCE": "roundness",
    "CYLINDRICITY_TOLERANCE": "cylindricity",
    "LINE_PROFILE_TOLERANCE": "line profile",
    "SURFACE_PROFILE_TOLERANCE": "surface profile",
    "PARALLELISM_TOLERANCE": "parallelism",
    "PERPENDICULARITY_TOLERANCE": "perpendicularity",
    "ANGULARITY_TOLERANCE": "angularity",
    "POSITION_TOLERANCE": "position",
    "CONCENTRICITY_TOLERANCE": "concentricity",
    "COAXIALITY_TOLERANCE": "coaxiality",
    "SYMMETRY_TOLERANCE": "symmetry",
    "CIRCULAR_RUNOUT_TOLERANCE": "circular run-out",
    "TOTAL_RUNOUT_TOLERANCE": "total run-out",
}
"""Entity of AP242 and characteristic of ISO 1101."""

MODIFIERS = {
    "COMMON_ZONE": "CZ",
    "MAXIMUM_MATERIAL_REQUIREMENT": "Ⓜ",
    "LEAST_MATERIAL_REQUIREMENT": "Ⓛ",
    "RECIPROCITY_REQUIREMENT": "Ⓡ",
}
ZONES = {"cylindrical or circular": "Ø", "spherical": "SØ"}
_GRAPHIC = (
    "ANNOTATION_OCCURRENCE", "ANNOTATION_CURVE_OCCURRENCE", "ANNOTATION_TEXT_OCCURRENCE",
    "ANNOTATION_PLACEHOLDER_OCCURRENCE", "DRAUGHTING_ANNOTATION_OCCURRENCE",
    "TESSELLATED_ANNOTATION_OCCURRENCE",
)  # fmt: skip
_SIZES = ("DIMENSIONAL_SIZE", "ANGULAR_SIZE", "DIMENSIONAL_SIZE_WITH_PATH")


def read_pmi(file: Part21, entities: Mapping[str, FaceEntity]) -> Pmi:
    """Datums, tolerances and sizes of a file.

    Args:
        entities: of the faces, by name (`match.match_faces`).

    Raises:
        InputError: the file refers to what it doesn't hold.
    """
    names: dict[int, tuple[str, ...]] = {}
    for name, entity in entities.items():
        names[entity.number] = (*names.get(entity.number, ()), name)
    aspects = Aspects(file, names)
    return Pmi(_datums(aspects), _tolerances(aspects), _sizes(aspects))


def graphic_annotations(file: Part21) -> int:
    """Number of annotations that are drawn, whether or not their meaning is in the file as well."""
    return len(set(file.of(*_GRAPHIC)))


def _datums(aspects: Aspects) -> tuple[PmiDatum, ...]:
    file = aspects.file
    found = []
    for number in dict.fromkeys(file.of("DATUM")):
        letter = file[number]["DATUM"]
        faces = aspects.faces(Ref(number))
        target = False
        for other in aspects.around(number):
            keywords = file.keywords(other) if other in file else ()
            if "DATUM_FEATURE" in keywords or "DIMENSIONAL_SIZE_WITH_DATUM_FEATURE" in keywords:
                faces |= aspects.faces(other)
            elif any("DATUM_TARGET" in keyword for keyword in keywords):
                target = True
                for feature in aspects.around(other):
                    if feature != number:
                        faces |= aspects.faces(feature)
        if letter:
            found.append(PmiDatum(str(letter[-1]), in_order(faces), target))
    return tuple(sorted(found, key=lambda datum: datum.letter))


def _tolerances(aspects: Aspects) -> tuple[PmiTolerance, ...]:
    file = aspects.file
    prefixes = _prefixes(file)
    numbers = [*file.of("GEOMETRIC_TOLERANCE"), *file.of(*CHARACTERISTICS)]
    found = []
    for number in sorted(set(numbers)):
        record = file[number]
        keyword = next((k for k in CHARACTERISTICS if k in record), "")
        own = record.get("GEOMETRIC_TOLERANCE") or record.get(keyword, ())
        if len(own) < 4:
            continue
        measure = measure_of(file, own[2])
        value = None if measure is None else 1000.0 * measure[0] * factor(file, measure[1])
        section = record.get("GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE") or own[4:5]
        said = record.get("GEOMETRIC_TOLERANCE_WITH_MODIFIERS", ((),))[0]
        words = [str(word) for word in said] if isinstance(said, tuple) else []
        found.append(
            PmiTolerance(
                name=str(own[0] or ""),
                characteristic=CHARACTERISTICS.get(keyword, ""),
                value=value,
                prefix=prefixes.get(Ref(number), ""),
                modifiers=tuple(MODIFIERS.get(w, w.lower().replace("_", " ")) for w in words),
                datums=_section(file, section[0] if section else None),
                faces=in_order(aspects.faces(own[3])),
            )
        )
    return tuple(found)


def _prefixes(file: Part21) -> dict[Ref, str]:
    """Ø or SØ of tolerances, by the shape of their zones."""
    found: dict[Ref, str] = {}
    for number in file.of("TOLERANCE_ZONE"):
        zone = file[number]["TOLERANCE_ZONE"]
        form = file.get(zone[-1], "TOLERANCE_ZONE_FORM")
        tolerances = zone[-2] if len(zone) > 1 else ()
        if form and isinstance(tolerances, tuple):
            for each in tolerances:
                if isinstance(each, Ref):
                    found[each] = ZONES.get(str(form[0]), "")
    return found


def _section(file: Part21, systems: Value) -> str:
    """Datum section of a tolerance: ``A|B-C``."""
    cells: list[tuple[int, str]] = []
    for system in systems if isinstance(systems, tuple) else ():
        compartments = file.get(system, "DATUM_SYSTEM")
        if compartments is not None and isinstance(compartments[-1], tuple):
            for compartment in compartments[-1]:
                cell = file.get(compartment, "DATUM_REFERENCE_COMPARTMENT")
                if cell is not None:
                    cells.append((len(cells), _cell(file, cell)))
        reference = file.get(system, "DATUM_REFERENCE")
        if reference is not None and isinstance(reference[0], int):
            cells.append((reference[0], _letter(file, reference[1])))
    return "|".join(text for _, text in sorted(cells))


def _cell(file: Part21, parameters: tuple[Value, ...]) -> str:
    base, modifiers = parameters[4], parameters[5] if len(parameters) > 5 else None
    text = _letter(file, base)
    if isinstance(base, Typed) and base.parameters and isinstance(base.parameters[0], tuple):
        elements = [file.get(e, "DATUM_REFERENCE_ELEMENT") for e in base.parameters[0]]
        text = "-".join(_letter(file, element[4]) for element in elements if element)
    said = [
        str(m.parameters[0]) for m in (modifiers if isinstance(modifiers, tuple) else ())
        if isinstance(m, Typed) and m.parameters
    ]  # fmt: skip
    return text + ("><" if "ORIENTATION" in said else "")


def _letter(file: Part21, datum: Value) -> str:
    found = file.get(datum, "DATUM") or file.get(datum, "COMMON_DATUM")
    return str(found[-1]) if found else ""


def _sizes(aspects: Aspects) -> tuple[PmiSize, ...]:
    file = aspects.file
    nominal: dict[Value, Value] = {}
    for number in file.of("DIMENSIONAL_CHARACTERISTIC_REPRESENTATION"):
        dimension, shown = file[number]["DIMENSIONAL_CHARACTERISTIC_REPRESENTATION"][:2]
        nominal[dimension] = shown
    ranges: dict[Value, Value] = {}
    for number in file.of("PLUS_MINUS_TOLERANCE"):
        limits, dimension = file[number]["PLUS_MINUS_TOLERANCE"][:2]
        ranges[dimension] = limits
    found = []
    for number in sorted(set(file.of(*_SIZES))):
        record = file[number]
        own = record.get("DIMENSIONAL_SIZE") or record.get("ANGULAR_SIZE")
        if not own or len(own) < 2:
            continue
        key = Ref(number)
        lower, upper, fit = _range(file, ranges.get(key))
        found.append(
            PmiSize(
                kind="angle" if "ANGULAR_SIZE" in record else str(own[1] or ""),
                nominal=_nominal(file, nominal.get(key)),
                lower=lower,
                upper=upper,
                fit=fit,
                faces=in_order(aspects.faces(own[0])),
            )
        )
    return tuple(found)


def _nominal(file: Part21, shown: Value) -> float | None:
    """The nominal value among a dimension's items; limits and other values are left alone."""
    representation = file.get(shown, "SHAPE_DIMENSION_REPRESENTATION")
    items = representation[1] if representation and len(representation) > 1 else ()
    values: list[float] = []
    for item in items if isinstance(items, tuple) else ():
        if not isinstance(item, Ref) or item not in file:
            continue
        record = file[item]
        value = _value(file, item)
        if value is not None and _item_name(record) in ("nominal value", ""):
            values.append(value)
    return values[0] if values else None


def _item_name(record: Record) -> str:
    for keyword in ("REPRESENTATION_ITEM", "MEASURE_REPRESENTATION_ITEM"):
        if record.get(keyword):
            return str(record[keyword][0])
    return ""


def _range(file: Part21, limits: Value) -> tuple[float | None, float | None, str]:
    deviations = file.get(limits, "TOLERANCE_VALUE")
    if deviations is not None and len(deviations) == 2:
        return _value(file, deviations[0]), _value(file, deviations[1]), ""
    fit = file.get(limits, "LIMITS_AND_FITS")
    if fit is not None and len(fit) > 2:
        return None, None, f"{fit[0]}{fit[2]}"
    return None, None, ""


def _value(file: Part21, measure: Value) -> float | None:
    """A measure in mm or degrees."""
    found = measure_of(file, measure)
    if found is None:
        return None
    value, unit = found
    keywords = file.keywords(unit) if isinstance(unit, Ref) and unit in file else ()
    if "PLANE_ANGLE_UNIT" in keywords:
        return math.degrees(value * factor(file, unit))
    return 1000.0 * value * factor(file, unit)
