# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slots and ribs: two opposed parallel planes as one feature of size (ISO 14405-1, 22432)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from gpswb.gps.facing import faced_first
from gpswb.gps.gps_feature import GpsFeature, Size, group_of, numbered
from gpswb.gps.tolerances import DEFAULT, Tolerances
from gpswb.gps.twists import Frame, SituationFeature, vector
from gpswb.sentence import Sentence

# One of the planes has to face the other over half of itself ...
_MOST = 0.5
# ... and the other over a tenth: a detail on a large face gives a distance, not a size.
_LEAST = 0.1


def opposed_planes(
    features: Sequence[GpsFeature],
    frame: Frame,
    first_id: int,
    tolerances: Tolerances = DEFAULT,
) -> list[GpsFeature]:
    """Pairs of parallel planes of one body with opposite outward normals that face each other.

    With air between them they are a slot, with material between them a rib. Each place of a plane
    faces the nearest opposed one only, so a wall isn't paired through the next slot.

    Args:
        features: maximal integral features; those of ids ``first_id`` and on are returned.
        frame: of the part.
    """
    planes = [f for f in features if f.surface == "plane" and len(f.facets)]
    near = tolerances.distance * frame.length
    shares: dict[tuple[int, int, bool], tuple[float, float]] = {}
    for plane in planes:
        normal = np.array(plane.place.direction)
        opposed = [
            other
            for other in planes
            if other.body == plane.body
            and float(normal @ other.place.direction) <= -np.cos(tolerances.angle)
        ]
        for (id_, outside), met in faced_first(plane, opposed, near).items():
            shares[plane.id, id_, outside] = met
    by_id = {plane.id: plane for plane in planes}
    found = []
    for (one, other, outside), (share, gap) in shares.items():
        back = shares.get((other, one, outside), (0.0, gap))[0]
        if one < other and max(share, back) >= _MOST and min(share, back) >= _LEAST:
            found.append((by_id[one], by_id[other], gap, outside))
    found.sort(key=lambda pair: -(pair[0].area + pair[1].area))
    counts = {"slot": 0, "rib": 0}
    compounds: list[GpsFeature] = []
    for first, second, gap, slot in found:
        kind = "slot" if slot else "rib"
        counts[kind] += 1
        id_ = first_id + len(compounds)
        compounds.append(_compound(first, second, gap, id_, counts[kind], slot=slot))
    return compounds


def _compound(
    first: GpsFeature, second: GpsFeature, width: float, id_: int, number: int, *, slot: bool
) -> GpsFeature:
    normal = first.place.direction
    middle = vector(np.mean([first.place.point, second.place.point], axis=0))
    feature = group_of(
        (first, second),
        id_=id_,
        name=numbered(Sentence("Slot") if slot else Sentence("Rib"), number),
        kind="slot" if slot else "rib",
        invariance_class="planar",
        situations=(SituationFeature("planar", middle, normal),),
        situation={"point": list(middle), "normal": list(normal)},
        intrinsic={"width": width},
        size=Size("width", width),
        derived="median plane",
    )
    return replace(feature, material="internal" if slot else "external")
