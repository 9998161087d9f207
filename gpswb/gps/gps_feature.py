# SPDX-License-Identifier: LGPL-2.1-or-later
"""A GPS feature: one maximal integral feature, or a compound of several."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray
from gpswb.gps.twists import SituationFeature
from gpswb.sentence import Sentence

Kind = Literal[
    "integral",
    "slot",
    "rib",
    "coaxial group",
    "hole pattern",
    "pin pattern",
    "counterbore",
    "countersink",
]
Material = Literal["internal", "external", "neither"]
SizeKind = Literal["diameter", "spherical diameter", "width", "cone angle"]


@dataclass(frozen=True)
class Size:
    """Size of a feature of size: mm, or degrees for a cone angle (ISO 14405-1, 14405-3)."""

    kind: SizeKind
    value: float

    @property
    def linear(self) -> bool:
        """Linear sizes take material modifiers (ISO 2692), angular ones don't."""
        return self.kind != "cone angle"


@dataclass(frozen=True, eq=False)
class GpsFeature:
    """A feature that a specification or a datum can name.

    Args:
        id: index in the feature table.
        name: ``Plane 1``, ``Hole 2`` ..., numbered by falling area.
        kind: integral, or the kind of compound.
        invariance_class: of the feature, of a compound's union; None for a face that the mesh has
            no region of: nobody has recognised it, so that it has no situation feature either.
        surface: the region's word (plane, cylinder, ...); the kind's for a compound.
        situations: what datum arithmetic reads: one for an integral feature or a median plane, each
            member's for a group; points near the feature itself.
        situation: what the table prints: point (mm), direction or outward normal (unit).
        intrinsic: radius, half_angle_deg, ...; count, pitch, ... for a pattern.
        size: None where there is no feature of size (an arc of at most half a turn has none).
        material: internal (hole, slot) or external (shaft, rib) by the side of the material.
        derived: the derived feature in words, empty for none (ISO 22432).
        arrangement: of a pattern: linear, grid, circle or free.
        interrupted: several surfaces that are to be taken as one (UF).
        sure: recognition left no other class open.
        whole: a cylinder or cone that goes all round its axis; True for other features.
        members: ids of the features that a compound is made of; ``surfaces``: their surfaces.
        regions: ids of its regions.
        faces: names of its B-rep faces.
        area: mm².
        body: number of the solid that it belongs to; features of several are never taken as one.
        points: (k, 3) vertices of it, mm, for extents.
        facets: (f, 3, 3) corners of its facets, mm, for overlaps; none for a compound.
    """

    id: int
    name: str
    kind: Kind
    invariance_class: InvarianceClass | None
    surface: str
    situations: tuple[SituationFeature, ...]
    situation: Mapping[str, list[float]]
    intrinsic: Mapping[str, float]
    size: Size | None
    material: Material
    derived: str
    regions: tuple[int, ...]
    faces: tuple[str, ...]
    area: float
    arrangement: str = ""
    interrupted: bool = False
    sure: bool = True
    whole: bool = True
    members: tuple[int, ...] = ()
    surfaces: frozenset[str] = frozenset()
    body: int = 0
    points: FloatArray = field(default_factory=lambda: np.zeros((0, 3)))
    facets: FloatArray = field(default_factory=lambda: np.zeros((0, 3, 3)))

    @property
    def recognised(self) -> bool:
        """Whether it has a class and a situation feature."""
        return bool(self.situations)

    @property
    def place(self) -> SituationFeature:
        """The situation feature; of a group the first member's."""
        return self.situations[0]

    @property
    def of_linear_size(self) -> bool:
        """Whether this is a linear feature of size."""
        return self.size is not None and self.size.linear


def numbered(word: Sentence, number: int) -> Sentence:
    """A feature's name: what it is called, and which of these it is."""
    return Sentence("{word} {number}", word=word, number=number)


UNRECOGNISED = Sentence("not recognised: no region of the mesh lies on it")
"""Why a feature without a class can be neither a datum nor toleranced."""


def unrecognised(id_: int, number: int, face: str, body: int) -> GpsFeature:
    """The feature of one face that the mesh has no region of: ``Unrecognised 1`` ..."""
    return GpsFeature(
        id=id_,
        name=numbered(Sentence("Unrecognised"), number),
        kind="integral",
        invariance_class=None,
        surface="none",
        situations=(),
        situation={},
        intrinsic={},
        size=None,
        material="neither",
        derived="",
        regions=(),
        faces=(face,),
        area=0.0,
        sure=False,
        body=body,
    )


def group_of(
    members: Sequence[GpsFeature],
    *,
    id_: int,
    name: str,
    kind: Kind,
    invariance_class: InvarianceClass,
    situations: tuple[SituationFeature, ...],
    situation: Mapping[str, list[float]],
    intrinsic: Mapping[str, float],
    size: Size | None,
    derived: str,
    arrangement: str = "",
) -> GpsFeature:
    """A compound with its members' regions, faces, area and, where they agree, material side."""
    sides = {member.material for member in members}
    return GpsFeature(
        id=id_,
        name=name,
        kind=kind,
        invariance_class=invariance_class,
        surface=kind,
        situations=situations,
        situation=situation,
        intrinsic=intrinsic,
        size=size,
        material=sides.pop() if len(sides) == 1 else "neither",
        derived=derived,
        regions=tuple(r for member in members for r in member.regions),
        faces=tuple(name for member in members for name in member.faces),
        area=sum(member.area for member in members),
        arrangement=arrangement,
        sure=all(member.sure for member in members),
        members=tuple(member.id for member in members),
        surfaces=frozenset(member.surface for member in members),
        body=members[0].body,
    )
