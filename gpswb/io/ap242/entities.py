# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entities of semantic PMI (ISO 10303-242; CAx-IF recommended practices for PMI, 4.0)."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from gpswb.errors import InputError
from gpswb.gps.datum_system import Datum
from gpswb.gps.gps_feature import GpsFeature
from gpswb.gps.specified import GeometricalTolerance, SizeTolerance
from gpswb.io.ap242.match import FaceEntity
from gpswb.io.ap242.read_pmi import CHARACTERISTICS, MODIFIERS, ZONES
from gpswb.io.ap242.strings import encode
from gpswb.io.ap242.structure import ShapeOfProduct

_KEYWORDS = {name: keyword for keyword, name in CHARACTERISTICS.items()}
_MODIFIER_WORDS = {sign: word for word, sign in MODIFIERS.items()}
_ZONE_FORMS = {prefix: form for form, prefix in ZONES.items()}
_SIZE_WORDS = {
    "diameter": "diameter",
    "spherical diameter": "spherical diameter",
    "width": "thickness",
}


class Entities:
    """Entities to be appended to a file, numbered from ``first``.

    Lengths are written in mm with a unit of their own, whatever the file's unit: the user's values
    are in mm, and readers convert measures in inches less reliably (OCCT leaves them as they are).

    Args:
        shapes, entities: of the file and its faces.
    """

    def __init__(
        self, first: int, shapes: Sequence[ShapeOfProduct], entities: Mapping[str, FaceEntity]
    ) -> None:
        self.lines: list[str] = []
        self._next = first
        self._shapes = shapes
        self._entities = entities
        self._aspects: dict[tuple[str, ...], str] = {}
        self._datums: dict[str, str] = {}
        self._systems: dict[str, str] = {}
        self._forms: dict[str, str] = {}
        self._units: dict[str, str] = {}
        self._product = ""

    def add(self, body: str) -> str:
        """Append an entity; its reference."""
        number = f"#{self._next}"
        self._next += 1
        self.lines.append(f"{number}={body};")
        return number

    def datum(self, letter: str, features: Sequence[GpsFeature]) -> None:
        """A datum letter with one datum feature on all faces of its features."""
        faces = [face for feature in features for face in feature.faces]
        name = " + ".join(feature.name for feature in features)
        aspect = self._aspect("DATUM_FEATURE", name, faces)
        datum = self.add(f"DATUM('','',{self._product},.F.,{encode(letter)})")
        self.add(f"SHAPE_ASPECT_RELATIONSHIP('','',{aspect},{datum})")
        self._datums[letter] = datum

    def tolerance(self, tolerance: GeometricalTolerance) -> None:
        """A geometrical tolerance that has a value."""
        assert tolerance.value is not None
        feature = self._feature(tolerance.feature)
        value = self.add(
            f"LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE({_real(tolerance.value)}),{self._mm()})"
        )
        words = ",".join(f".{_MODIFIER_WORDS[m]}." for m in tolerance.modifiers)
        keyword = _KEYWORDS[tolerance.characteristic]
        own = f"{encode(tolerance.characteristic)},'',{value},{feature}"
        parts = {"GEOMETRIC_TOLERANCE": own, keyword: ""}
        if tolerance.datums:
            parts["GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE"] = (
                f"({self._system(tolerance.datums)})"
            )
        if words:
            parts["GEOMETRIC_TOLERANCE_WITH_MODIFIERS"] = f"({words})"
        # Readers know the complex form of what has datums or modifiers only.
        complex_form = "".join(f"{part}({parts[part]})" for part in sorted(parts))
        number = self.add(f"({complex_form})" if len(parts) > 2 else f"{keyword}({own})")
        if tolerance.prefix in _ZONE_FORMS:
            form = _ZONE_FORMS[tolerance.prefix]
            if form not in self._forms:
                self._forms[form] = self.add(f"TOLERANCE_ZONE_FORM({encode(form)})")
            self.add(f"TOLERANCE_ZONE('','',{self._product},.F.,({number}),{self._forms[form]})")

    def size(self, tolerance: SizeTolerance) -> None:
        """A size with its nominal value and its signed deviations or tolerance class."""
        size = tolerance.feature.size
        assert size is not None
        feature = self._feature(tolerance.feature)
        if size.linear:
            word = encode(_SIZE_WORDS[size.kind])
            dimension = self.add(f"DIMENSIONAL_SIZE({feature},{word})")
        else:
            dimension = self.add(f"ANGULAR_SIZE({feature},'',.SMALL.)")
        nominal = self._measure("nominal value", size.value, linear=size.linear)
        shape = self._shapes[self._entities[tolerance.feature.faces[0]].shape]
        context = f"#{int(shape.context)}"  # type: ignore[arg-type]
        shown = self.add(f"SHAPE_DIMENSION_REPRESENTATION('',({nominal}),{context})")
        self.add(f"DIMENSIONAL_CHARACTERISTIC_REPRESENTATION({dimension},{shown})")
        if tolerance.fit:
            zone = "hole" if tolerance.fit[0].isupper() else "shaft"
            letters = tolerance.fit.rstrip("0123456789")
            grade = encode(tolerance.fit[len(letters) :])
            limits = self.add(f"LIMITS_AND_FITS({encode(letters)},{encode(zone)},{grade},'')")
        else:
            assert tolerance.lower is not None
            assert tolerance.upper is not None
            lower = self._measure("lower limit", tolerance.lower, linear=size.linear)
            upper = self._measure("upper limit", tolerance.upper, linear=size.linear)
            limits = self.add(f"TOLERANCE_VALUE({lower},{upper})")
        self.add(f"PLUS_MINUS_TOLERANCE({limits},{dimension})")

    def _feature(self, feature: GpsFeature) -> str:
        """The aspect of a feature; of several faces a composite, since readers take but one face of
        a plain aspect."""
        key = feature.faces
        if key not in self._aspects:
            if len(key) == 1:
                self._aspects[key] = self._aspect("SHAPE_ASPECT", feature.name, key)
            else:
                parts = [self._aspect("SHAPE_ASPECT", feature.name, [face]) for face in key]
                # What is one feature (UF; ASME's CF) is told from a group of several.
                keyword = "CONTINUOUS" if feature.kind == "integral" else "COMPOSITE_GROUP"
                whole = self.add(
                    f"{keyword}_SHAPE_ASPECT({encode(feature.name)},'multiple elements',"
                    f"{self._product},.F.)"
                )
                for part in parts:
                    self.add(f"SHAPE_ASPECT_RELATIONSHIP('','',{whole},{part})")
                self._aspects[key] = whole
        return self._aspects[key]

    def _aspect(self, keyword: str, name: str, faces: Sequence[str]) -> str:
        """An aspect of the part on faces, each by a usage of its own."""
        missing = [face for face in faces if face not in self._entities]
        if missing or not faces:
            raise InputError(
                f"{name}: {missing[0] if missing else 'it'} isn't found among the faces of the "
                "STEP text, so PMI can't be attached to it"
            )
        shapes = [self._shapes[self._entities[face].shape] for face in faces]
        products = {shape.definition for shape in shapes}
        product = shapes[0].definition
        if len(products) > 1 or product is None:
            raise InputError(f"{name}: its faces aren't all of one product of the STEP file")
        if self._product not in ("", f"#{int(product)}"):
            raise InputError(
                f"{name} is on another part of the assembly than the features before: AP242 PMI "
                "is written for one part at a time"
            )
        self._product = f"#{int(product)}"
        aspect = self.add(f"{keyword}({encode(name)},'',{self._product},.T.)")
        numbers = dict.fromkeys(
            (int(shape.representation), int(self._entities[face].number))
            for shape, face in zip(shapes, faces, strict=True)
        )
        for shown, number in numbers:
            self.add(f"GEOMETRIC_ITEM_SPECIFIC_USAGE('','',{aspect},#{shown},#{number})")
        return aspect

    def _system(self, datums: Sequence[Datum]) -> str:
        """A datum system, written once."""
        notation = "|".join(datum.notation for datum in datums)
        if notation not in self._systems:
            cells = ",".join(self._compartment(datum) for datum in datums)
            self._systems[notation] = self.add(
                f"DATUM_SYSTEM({encode(notation)},'',{self._product},.F.,({cells}))"
            )
        return self._systems[notation]

    def _compartment(self, datum: Datum) -> str:
        letters = datum.name.split("-")
        modifiers = (
            "(SIMPLE_DATUM_REFERENCE_MODIFIER(.ORIENTATION.))" if datum.orientation_only else "$"
        )
        base = self._datums[letters[0]]
        if len(letters) > 1:
            elements = [
                self.add(
                    f"DATUM_REFERENCE_ELEMENT('','',{self._product},.F.,{self._datums[letter]},$)"
                )
                for letter in letters
            ]
            base = f"COMMON_DATUM_LIST(({','.join(elements)}))"
        return self.add(
            f"DATUM_REFERENCE_COMPARTMENT('','',{self._product},.F.,{base},{modifiers})"
        )

    def _measure(self, name: str, value: float, *, linear: bool) -> str:
        kind, unit = ("LENGTH", self._mm()) if linear else ("PLANE_ANGLE", self._degree())
        return self.add(
            f"({kind}_MEASURE_WITH_UNIT()MEASURE_REPRESENTATION_ITEM()"
            f"MEASURE_WITH_UNIT({kind}_MEASURE({_real(value)}),{unit})"
            f"REPRESENTATION_ITEM({encode(name)}))"
        )

    def _mm(self) -> str:
        if "mm" not in self._units:
            unit = self.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))")
            self._units["mm"] = unit
        return self._units["mm"]

    def _degree(self) -> str:
        if "degree" not in self._units:
            radian = self.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))")
            turn = f"PLANE_ANGLE_MEASURE({_real(math.radians(1.0))})"
            measure = self.add(f"PLANE_ANGLE_MEASURE_WITH_UNIT({turn},{radian})")
            exponents = self.add("DIMENSIONAL_EXPONENTS(0.,0.,0.,0.,0.,0.,0.)")
            self._units["degree"] = self.add(
                f"(CONVERSION_BASED_UNIT('DEGREE',{measure})NAMED_UNIT({exponents})"
                "PLANE_ANGLE_UNIT())"
            )
        return self._units["degree"]


def _real(value: float) -> str:
    """A real as Part 21 wants it: with a point, and an upper-case exponent."""
    text = repr(float(value)).upper()
    mantissa, _, exponent = text.partition("E")
    if "." not in mantissa:
        mantissa += "."
    return f"{mantissa}E{exponent}" if exponent else mantissa
