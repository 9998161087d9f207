# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which geometrical specifications a feature may carry (ISO 1101, 2692, 5458; design, 7)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from gpswb.gps.characteristics import GROUPED, RULES, Characteristic, Family, Group, family
from gpswb.gps.datum_system import DatumSystem, datum_system
from gpswb.gps.explain import explain_freedom
from gpswb.gps.gps_feature import UNRECOGNISED, GpsFeature
from gpswb.gps.relation import Relation, relation
from gpswb.gps.zones import zone_shape
from gpswb.sentence import Sentence

Status = Literal["recommended", "allowed", "not allowed"]
Need = Literal["none", "optional", "required"]


@dataclass(frozen=True)
class Specification:
    """One geometrical characteristic for one feature.

    Args:
        characteristic: its name in ISO 1101; ``symbol`` its sign, ``group`` form, profile, ...
        status: recommended, allowed or not allowed, with its ``reason``.
        datum: whether a datum must, may or must not stand in the frame.
        datums: the datum section, empty without datums: the one datum that an orientation, an axis
            or a median refers to, the whole system for the rest.
        modifiers: material modifiers that may follow the value; empty if none may.
        combination: CZ for a pattern, UF for an interrupted surface.
        zone: shape of the tolerance zone; ``prefix`` of the value: nothing, Ø or SØ.
        value: "?" until the user says otherwise: a tolerance is never invented.
    """

    characteristic: Characteristic
    symbol: str
    group: Group
    status: Status
    reason: Sentence
    datum: Need
    datums: str
    modifiers: tuple[str, ...]
    combination: str
    zone: Sentence
    prefix: str
    value: str = "?"


def permitted_specifications(
    feature: GpsFeature, system: DatumSystem | None = None
) -> tuple[Specification, ...]:
    """Every characteristic of ISO 1101 for a feature under a datum system.

    A feature that is a datum of the system itself is judged under the letters before its own.

    Returns:
        15 rows in the standard's order, not allowed ones included, each with its reason.
    """
    kind = family(feature)
    stands = None
    before = _letters_before(feature, system) if system is not None else None
    if before is not None and before.datums and feature.recognised:
        stands = relation(feature, before)
    best = _recommended(feature, kind, stands)
    rows = []
    for name, rule in RULES.items():
        need = _need(name, kind, rule.group)
        status, reason = _judge(name, feature, kind, stands)
        if name == best and status == "allowed":
            status = "recommended"
        zone, prefix = zone_shape(name, kind)
        rows.append(
            Specification(
                characteristic=name,
                symbol=rule.symbol,
                group=rule.group,
                status=status,
                reason=reason,
                datum=need,
                datums=_section(name, rule.group, before, stands) if need != "none" else "",
                modifiers=_modifiers(name, feature, kind),
                combination=_combination(feature, kind, rule.group),
                zone=zone,
                prefix=prefix,
            )
        )
    return tuple(rows)


def _letters_before(feature: GpsFeature, system: DatumSystem) -> DatumSystem:
    for i, datum in enumerate(system.datums):
        if any(_shared(f, feature) for f in datum.features):
            return datum_system(system.datums[:i], system.frame, system.tolerances)
    return system


def _shared(one: GpsFeature, other: GpsFeature) -> bool:
    """Whether two features are one, or one is made of the other."""
    return one.id == other.id or one.id in other.members or other.id in one.members


def _section(
    name: Characteristic, group: Group, system: DatumSystem | None, stands: Relation | None
) -> str:
    if system is None or stands is None:
        return ""
    refers: dict[str, str] = {
        "coaxiality": "axis", "concentricity": "centre", "symmetry": "median",
    }  # fmt: skip
    key = "axis" if group == "run-out" else refers.get(name, name)
    if key == "angularity":  # it may take several datums to fix an angle
        return system.notation
    return stands.by.get(key) or stands.by.get("axis" if key == "centre" else "") or system.notation


def _need(name: Characteristic, kind: Family, group: Group) -> Need:
    if group == "form":
        return "none"
    if group == "profile" or (name == "position" and kind == "group"):
        return "optional"
    return "required"


def _modifiers(name: Characteristic, feature: GpsFeature, kind: Family) -> tuple[str, ...]:
    """Material modifiers go with the derived feature of a linear feature of size (ISO 2692)."""
    derived = RULES[name].group == "orientation" or name in ("position", "coaxiality", "symmetry")
    derived |= name == "straightness" and kind == "cylinder"
    derived |= name == "flatness" and kind == "opposed planes"
    return ("Ⓜ", "Ⓛ", "Ⓡ") if derived and feature.of_linear_size else ()


def _combination(feature: GpsFeature, kind: Family, group: Group) -> str:
    """CZ holds the zones of a group to one another (ISO 5458); form and run-out are of each."""
    if kind == "group":
        return "" if group in ("form", "run-out") else "CZ"
    return "UF" if feature.interrupted else ""


def _recommended(feature: GpsFeature, kind: Family, stands: Relation | None) -> Characteristic:
    """The one characteristic that says most of the feature's function."""
    if stands is None:
        if kind == "cylinder" and feature.size is not None:
            return "cylindricity"
        plain: dict[Family, Characteristic] = {
            "plane": "flatness", "opposed planes": "flatness", "group": "position",
        }  # fmt: skip
        return plain.get(kind, "surface profile")
    if kind in ("prismatic", "complex"):
        return "surface profile"
    if kind == "cone" and feature.size is not None and stands.coaxial:
        return "circular run-out"
    centred = feature.of_linear_size or kind in ("group", "helical")
    if centred and stands.coaxial:
        return "coaxiality"
    if kind == "opposed planes" and stands.symmetric:
        return "symmetry"
    located: Characteristic = "position" if centred else "surface profile"
    # A corner's radius or a blend follows its neighbours: its own axis is of no use.
    if stands.partly_located or not stands.orientations or not (centred or kind == "plane"):
        return located
    return stands.orientations[0]


def _judge(
    name: Characteristic, feature: GpsFeature, kind: Family, stands: Relation | None
) -> tuple[Status, Sentence]:
    rule = RULES[name]
    if not feature.recognised:
        return "not allowed", UNRECOGNISED
    if kind not in rule.families:
        return "not allowed", Sentence("{feature}: {why}", feature=feature.name, why=rule.otherwise)
    if kind == "group" and rule.group in ("form", "run-out"):  # it is said of each by itself
        for surface in sorted(feature.surfaces):
            if GROUPED[surface] not in rule.families:
                return "not allowed", Sentence(
                    "{feature} holds a {surface}: {why}",
                    feature=feature.name,
                    surface=Sentence(surface),
                    why=rule.otherwise,
                )
    if name == "symmetry" and kind == "cylinder" and feature.size is None:
        return "not allowed", Sentence("an arc of at most half a turn has no median line")
    if rule.group == "form":
        if kind == "group":
            return "allowed", Sentence("form of each of its features by itself, without a datum")
        return "allowed", Sentence("form of the feature itself, without a datum")
    if stands is None:
        if rule.group == "profile":
            return "allowed", Sentence("without a datum it bounds the form")
        if _need(name, kind, rule.group) == "optional":
            return "allowed", Sentence(
                "CZ holds the features of the group to one another, without a datum"
            )
        return "not allowed", Sentence("it needs a datum, and none stands before this feature")
    if rule.group == "orientation":
        return _judge_orientation(name, stands)
    if rule.group == "run-out" and not stands.turning:
        return "not allowed", Sentence("it doesn't turn about an axis of these datums")
    if name == "coaxiality" and not stands.coaxial:
        return "not allowed", Sentence("its axis isn't a datum axis: use position")
    if name == "concentricity" and not stands.concentric:
        return "not allowed", Sentence("its centre isn't on a datum axis or point: use position")
    if name == "symmetry" and not stands.symmetric:
        return (
            "not allowed",
            Sentence("its median feature isn't that of a datum: use position"),
        )
    if rule.group == "run-out":
        return "allowed", Sentence("it turns about the datum axis")
    return "allowed", explain_freedom(stands.freedom)


def _judge_orientation(name: Characteristic, stands: Relation) -> tuple[Status, Sentence]:
    if not stands.orientations:
        return "not allowed", Sentence("the datums have no direction")
    if name == "angularity":
        return "allowed", Sentence("it serves any angle to the datums")
    if name in stands.orientations:
        return "allowed", Sentence("that is the nominal angle to a datum")
    return "not allowed", Sentence(
        "the nominal angle to the first datum is {angle:.4g}°: use {characteristic}",
        angle=stands.angle_deg,
        characteristic=Sentence(stands.orientations[0]),
    )
