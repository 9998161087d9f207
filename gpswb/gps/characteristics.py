# SPDX-License-Identifier: LGPL-2.1-or-later
"""The geometrical characteristics of ISO 1101 and the kinds of feature that can carry each."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from gpswb.gps.gps_feature import GpsFeature
from gpswb.sentence import Sentence

Characteristic = Literal[
    "straightness",
    "flatness",
    "roundness",
    "cylindricity",
    "line profile",
    "surface profile",
    "parallelism",
    "perpendicularity",
    "angularity",
    "position",
    "concentricity",
    "coaxiality",
    "symmetry",
    "circular run-out",
    "total run-out",
]
Group = Literal["form", "profile", "orientation", "location", "run-out"]
Family = Literal[
    "plane",
    "cylinder",
    "sphere",
    "cone",
    "revolute",
    "prismatic",
    "helical",
    "complex",
    "opposed planes",
    "group",
    "unrecognised",
]

_ALL = frozenset(get_args(Family))
_ROUND = frozenset({"cylinder", "cone", "revolute", "group"})
_DIRECTED = _ALL - {"sphere", "complex"}


@dataclass(frozen=True)
class Rule:
    """A characteristic's symbol (Unicode), group, the families it fits and why it fits no other."""

    symbol: str
    group: Group
    families: frozenset[str]
    otherwise: Sentence | None


RULES: dict[Characteristic, Rule] = {
    "straightness": Rule(
        "⏤",
        "form",
        frozenset({"plane", "cylinder", "cone", "prismatic", "opposed planes", "group"}),
        Sentence("it has no straight line elements"),
    ),
    "flatness": Rule(
        "⏥", "form", frozenset({"plane", "opposed planes"}), Sentence("it isn't flat")
    ),
    "roundness": Rule("○", "form", _ROUND | {"sphere"}, Sentence("its sections aren't circles")),
    "cylindricity": Rule(
        "⌭", "form", frozenset({"cylinder", "group"}), Sentence("it isn't a cylinder")
    ),
    "line profile": Rule("⌒", "profile", _ALL, None),
    "surface profile": Rule("⌓", "profile", _ALL, None),
    "parallelism": Rule("∥", "orientation", _DIRECTED, Sentence("it has no direction to orient")),
    "perpendicularity": Rule(
        "⟂", "orientation", _DIRECTED, Sentence("it has no direction to orient")
    ),
    "angularity": Rule("∠", "orientation", _DIRECTED, Sentence("it has no direction to orient")),
    "position": Rule(
        "⌖",
        "location",
        _ALL - {"complex"},
        Sentence("a freeform surface is located by a surface profile"),
    ),
    "concentricity": Rule("◎", "location", _ROUND | {"sphere"}, Sentence("it has no centre point")),
    "coaxiality": Rule("◎", "location", _ROUND | {"helical"}, Sentence("it has no axis")),
    "symmetry": Rule(
        "⌯",
        "location",
        frozenset({"cylinder", "prismatic", "opposed planes", "group"}),
        Sentence("it has no median plane or line"),
    ),
    "circular run-out": Rule(
        "↗", "run-out", _ROUND | {"sphere", "plane"}, Sentence("it doesn't turn about an axis")
    ),
    "total run-out": Rule(
        "⌰",
        "run-out",
        frozenset({"cylinder", "plane", "group"}),
        Sentence("total run-out is defined for cylinders and planes"),
    ),
}

GROUPED: dict[str, Family] = {"cylinder": "cylinder", "cone": "cone", "helicoid": "helical"}
"""Family of each surface that a group can hold."""


def family(feature: GpsFeature) -> Family:
    """The family whose specifications a feature shares."""
    if feature.kind in ("slot", "rib"):
        return "opposed planes"
    if feature.kind != "integral":
        return "group"
    match feature.invariance_class:
        case "planar":
            return "plane"
        case "cylindrical":
            return "cylinder"
        case "spherical":
            return "sphere"
        case "revolute":
            return "cone" if feature.surface == "cone" else "revolute"
        case None:
            return "unrecognised"
        case other:
            return other
