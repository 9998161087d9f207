# SPDX-License-Identifier: LGPL-2.1-or-later
"""QIF 3.0 (ISO 23952): features, datums and a datum reference frame as a QIF document.

Threads and extrusions become features of other surfaces: QIF wants a thread specification and a
cross-section's own feature for them, which a mesh doesn't give. Tolerances are left to AP242.
"""

from __future__ import annotations

import uuid
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from xml.etree.ElementTree import Element, ElementTree, SubElement, indent, tostring

import numpy as np

from gpswb.gps.annotation import Annotation
from gpswb.gps.datum_system import DatumSystem
from gpswb.gps.gps_feature import GpsFeature
from gpswb.gps.same_surface import cylindrical_coordinates

NAMESPACE = "http://qifstandards.org/xsd/qif3"
_INSTANCE = "http://www.w3.org/2001/XMLSchema-instance"
_PRECEDENCE = ("PRIMARY", "SECONDARY", "TERTIARY")
_COUNTERSINK = {"counterbore": "IsCounterboredHole", "countersink": "IsCountersunkHole"}


def write_qif(path: Path, annotation: Annotation, source: str) -> None:
    """Write a document with every feature of the table, the datums and their reference frame.

    Lengths in mm, angles in degrees. The frame holds the first three letters.

    Args:
        source: what the features were found in, for the document's attributes.

    Raises:
        OSError: the file can't be written.
    """
    document = _Document(source)
    nominal = {
        feature.id: document.feature(feature)
        for feature in annotation.table.features
        if feature.kind in ("integral", "slot", "rib")
    }
    for feature in annotation.table.features:
        if feature.id not in nominal:
            members = [nominal[i] for i in feature.members if i in nominal]
            nominal[feature.id] = document.group(feature, members)
    labels = {
        letter: document.datum(letter, [nominal[f.id] for f in features])
        for letter, features in annotation.letters.items()
    }
    for datum in annotation.system.datums if annotation.system is not None else ():
        if datum.name not in labels:  # a common datum: one datum on the features of its letters
            labels[datum.name] = document.datum(datum.name, [nominal[f.id] for f in datum.features])
    if annotation.system is not None and annotation.system.datums:
        document.frame(annotation.system, labels)
    document.write(path)


class _Document:
    """The document under way; QIF ids count from 1."""

    def __init__(self, source: str) -> None:
        self.root = Element("QIFDocument", xmlns=NAMESPACE, versionQIF="3.0.0")
        self.root.set("xmlns:xsi", _INSTANCE)
        self.root.set("xsi:schemaLocation", f"{NAMESPACE} QIFDocument.xsd")
        self._last = 0
        self._persistent = SubElement(self.root, "QPId")
        attributes = SubElement(self.root, "Attributes", n="1")
        SubElement(attributes, "AttributeStr", name="gpswb source", value=_printable(source))
        _text(SubElement(SubElement(self.root, "Header"), "Application"), "Name", "gpswb")
        self._units()
        self._datums = SubElement(self.root, "DatumDefinitions")
        self._frames = SubElement(self.root, "DatumReferenceFrames")
        features = SubElement(self.root, "Features")
        self._definitions = SubElement(features, "FeatureDefinitions")
        self._nominals = SubElement(features, "FeatureNominals")

    def feature(self, feature: GpsFeature) -> str:
        """A definition and a nominal; the nominal's id."""
        kind, define, place = _mapping(feature)
        definition = self._identified(self._definitions, f"{kind}FeatureDefinition")
        define(definition, feature)
        nominal = self._nominal(kind, feature, definition.get("id", ""))
        place(nominal, feature)
        return nominal.get("id", "")

    def group(self, feature: GpsFeature, members: Sequence[str]) -> str:
        """A compound as a group of features."""
        definition = self._identified(self._definitions, "GroupFeatureDefinition")
        if feature.kind in _COUNTERSINK:
            _text(definition, _COUNTERSINK[feature.kind], "true")
        nominal = self._nominal("Group", feature, definition.get("id", ""))
        _ids(nominal, "FeatureNominalIds", members)
        return nominal.get("id", "")

    def datum(self, letter: str, nominals: Sequence[str]) -> str:
        """A datum with its features; its id."""
        datum = self._identified(self._datums, "DatumDefinition")
        _text(datum, "DatumLabel", letter)
        _ids(datum, "FeatureNominalIds", nominals)
        return datum.get("id", "")

    def frame(self, system: DatumSystem, labels: dict[str, str]) -> None:
        """The datum system as a reference frame."""
        frame = self._identified(self._frames, "DatumReferenceFrame")
        chosen = list(zip(system.datums, _PRECEDENCE, strict=False))
        datums = SubElement(frame, "Datums", n=str(len(chosen)))
        for datum, precedence in chosen:
            entry = SubElement(datums, "Datum")
            simple = SubElement(entry, "SimpleDatum")
            _text(simple, "DatumDefinitionId", labels[datum.name])
            _text(simple, "MaterialModifier", "NONE")
            _text(simple, "ReferencedComponent", "ACTUAL")
            _text(SubElement(entry, "Precedence"), "PrecedenceEnum", precedence)
        _text(frame, "Name", system.notation)

    def write(self, path: Path) -> None:
        """Count the lists, drop the empty ones and write."""
        for parent in (self.root, self.root.find("Features")):
            assert parent is not None
            for each in (self._datums, self._frames, self._definitions, self._nominals):
                if each in list(parent):
                    each.set("n", str(len(each)))
                    if not len(each):
                        parent.remove(each)
        self.root.set("idMax", str(self._last))
        indent(self.root)
        # The same features give the same document, and so the same identifier.
        content = tostring(self.root, encoding="unicode")
        self._persistent.text = str(uuid.uuid5(uuid.NAMESPACE_URL, content))
        ElementTree(self.root).write(path, encoding="utf-8", xml_declaration=True)

    def _units(self) -> None:
        primary = SubElement(SubElement(self.root, "FileUnits"), "PrimaryUnits")
        for name, si, unit, factor in (
            ("AngularUnit", "radian", "degree", repr(float(np.radians(1.0)))),
            ("LinearUnit", "meter", "mm", "0.001"),
        ):
            each = SubElement(primary, name)
            _text(each, "SIUnitName", si)
            _text(each, "UnitName", unit)
            _text(SubElement(each, "UnitConversion"), "Factor", factor)

    def _identified(self, parent: Element, tag: str) -> Element:
        self._last += 1
        return SubElement(parent, tag, id=str(self._last))

    def _nominal(self, kind: str, feature: GpsFeature, definition: str) -> Element:
        nominal = self._identified(self._nominals, f"{kind}FeatureNominal")
        about = {
            "invariance class": feature.invariance_class or "none",
            "faces": " ".join(feature.faces),
        }
        said = {name: value for name, value in about.items() if value}
        attributes = SubElement(nominal, "Attributes", n=str(len(said)))
        for name, value in said.items():
            SubElement(attributes, "AttributeStr", name=f"gpswb {name}", value=value)
        _text(nominal, "Name", feature.name)
        _text(nominal, "FeatureDefinitionId", definition)
        return nominal


_Writer = Callable[[Element, GpsFeature], None]


def _mapping(feature: GpsFeature) -> tuple[str, _Writer, _Writer]:
    """QIF's kind of feature, and what writes its definition and its place."""
    if feature.kind in ("slot", "rib"):
        return "OppositeParallelPlanes", _define_slot, _place_slot
    if feature.surface == "plane":
        return "Plane", _define_nothing, _place_plane
    if feature.material != "neither":
        match feature.surface:
            case "cylinder":
                return "Cylinder", _define_round, _place_axis
            case "sphere":
                return "Sphere", _define_round, _place_point
            case "torus":
                return "Torus", _define_torus, _place_torus
            case "cone" if len(feature.points) and "half_angle_deg" in feature.intrinsic:
                return "Cone", _define_cone, _place_cone
        if feature.invariance_class == "revolute":
            return "SurfaceOfRevolution", _define_side, _place_axis
    return "OtherSurface", _define_nothing, _define_nothing


def _define_nothing(element: Element, feature: GpsFeature) -> None:
    pass


def _define_side(element: Element, feature: GpsFeature) -> None:
    _text(element, "InternalExternal", feature.material.upper())


def _define_round(element: Element, feature: GpsFeature) -> None:
    _define_side(element, feature)
    _text(element, "Diameter", _number(2.0 * feature.intrinsic["radius"]))


def _define_torus(element: Element, feature: GpsFeature) -> None:
    _define_side(element, feature)
    _text(element, "MinorDiameter", _number(2.0 * feature.intrinsic["minor_radius"]))
    _text(element, "MajorDiameter", _number(2.0 * feature.intrinsic["major_radius"]))


def _define_slot(element: Element, feature: GpsFeature) -> None:
    _define_side(element, feature)
    _text(element, "Width", _number(feature.intrinsic["width"]))
    _text(SubElement(element, "EndType"), "SlotEndEnum", "OPEN")


def _define_cone(element: Element, feature: GpsFeature) -> None:
    small, _, large = _cone(feature)
    _define_side(element, feature)
    _text(element, "Diameter", _number(2.0 * small))
    _text(element, "HalfAngle", _number(feature.intrinsic["half_angle_deg"]))
    _text(element, "LargeEndDistance", _number(large))
    _text(element, "SmallEndDistance", "0")


def _place_plane(element: Element, feature: GpsFeature) -> None:
    _text(element, "Location", _numbers(feature.place.point))
    _text(element, "Normal", _numbers(feature.place.direction))


def _place_point(element: Element, feature: GpsFeature) -> None:
    _text(element, "Location", _numbers(feature.place.point))


def _place_axis(element: Element, feature: GpsFeature) -> None:
    _axis(element, feature.place.point, feature.place.direction)


def _place_torus(element: Element, feature: GpsFeature) -> None:
    _text(element, "Location", _numbers(feature.situation["point"]))
    _text(element, "AxisVector", _numbers(feature.place.direction))


def _place_slot(element: Element, feature: GpsFeature) -> None:
    plane = SubElement(element, "CenterPlane")
    _text(plane, "Point", _numbers(feature.place.point))
    _text(plane, "Normal", _numbers(feature.place.direction))


def _place_cone(element: Element, feature: GpsFeature) -> None:
    _, start, _ = _cone(feature)
    point, direction = np.array(feature.place.point), np.array(feature.place.direction)
    _axis(element, point + start * direction, _widening(feature))


def _widening(feature: GpsFeature) -> np.ndarray:
    """Unit axis towards the cone's large end."""
    direction = np.array(feature.place.direction)
    rho, z = cylindrical_coordinates(feature.points, np.array(feature.place.point), direction)
    return direction if np.polyfit(z, rho, 1)[0] >= 0 else -direction


def _cone(feature: GpsFeature) -> tuple[float, float, float]:
    """Radius at the small end, its place along the feature's direction, and the length."""
    direction = np.array(feature.place.direction)
    rho, z = cylindrical_coordinates(feature.points, np.array(feature.place.point), direction)
    small, length = float(rho.min()), float(np.ptp(z))
    return small, float(z[rho.argmin()]), length


def _axis(element: Element, point: Iterable[float], direction: Iterable[float]) -> None:
    axis = SubElement(element, "Axis")
    _text(axis, "AxisPoint", _numbers(point))
    _text(axis, "Direction", _numbers(direction))


def _ids(element: Element, tag: str, ids: Sequence[str]) -> None:
    listed = SubElement(element, tag, n=str(len(ids)))
    for each in ids:
        _text(listed, "Id", each)


def _text(parent: Element, tag: str, text: str) -> None:
    SubElement(parent, tag).text = text


def _number(value: float) -> str:
    return f"{value:.12g}"


def _numbers(values: Iterable[float]) -> str:
    return " ".join(_number(float(value) + 0.0) for value in values)


def _printable(text: str) -> str:
    """Text without what XML can't hold."""
    return "".join(c if c.isprintable() else " " for c in text)
