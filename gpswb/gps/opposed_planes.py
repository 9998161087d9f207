# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slots and ribs: two opposed parallel planes as one feature of size (ISO 14405-1, 22432)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from gpswb.core.mesh import FloatArray
from gpswb.gps.gps_feature import GpsFeature, Size, group_of
from gpswb.gps.tolerances import DEFAULT, Tolerances
from gpswb.gps.twists import Frame, SituationFeature, perpendiculars, vector

# Opposed planes have to face each other over this share of the smaller one.
_OVERLAP = 0.5


def opposed_planes(
    features: Sequence[GpsFeature],
    frame: Frame,
    first_id: int,
    tolerances: Tolerances = DEFAULT,
) -> list[GpsFeature]:
    """Pairs of parallel planes with opposite outward normals that face each other.

    With air between them they are a slot, with material between them a rib. A plane is paired with
    the nearest that it faces, so a wall isn't paired through the next slot.

    Args:
        features: maximal integral features; those of ids ``first_id`` and on are returned.
        frame: of the part.
    """
    planes = [f for f in features if f.surface == "plane" and len(f.points)]
    pairs: dict[tuple[int, int], tuple[GpsFeature, GpsFeature, float]] = {}
    for one in planes:
        normal = np.array(one.place.direction)
        nearest: dict[bool, tuple[float, GpsFeature]] = {}
        for other in planes:
            if float(normal @ other.place.direction) > -np.cos(tolerances.angle):
                continue
            step = float(normal @ np.subtract(other.place.point, one.place.point))
            gap = abs(step)
            inside = step > 0
            if gap <= tolerances.distance * frame.length:
                continue
            if inside in nearest and nearest[inside][0] <= gap:
                continue
            if _overlap(one.points, other.points, normal) >= _OVERLAP:
                nearest[inside] = (gap, other)
        for inside, (gap, other) in nearest.items():
            first, second = sorted((one, other), key=lambda f: f.id)
            pairs[first.id, second.id] = (first, second, gap if inside else -gap)
    found = sorted(pairs.values(), key=lambda pair: -(pair[0].area + pair[1].area))
    counts = {"slot": 0, "rib": 0}
    compounds: list[GpsFeature] = []
    for first, second, gap in found:
        kind = "slot" if gap > 0 else "rib"
        counts[kind] += 1
        compounds.append(_compound(first, second, gap, first_id + len(compounds), counts[kind]))
    return compounds


def _overlap(a: FloatArray, b: FloatArray, normal: FloatArray) -> float:
    """Share of the smaller's box that two plane patches have in common, seen along the normal."""
    u, w = perpendiculars(normal)
    flat = a @ np.column_stack([u, w])
    # Boxes along the first patch's own sides, or an oblique slot would seem to be far wider.
    turn = np.linalg.svd(flat - flat.mean(axis=0), full_matrices=False)[2]
    flat, other = flat @ turn.T, b @ np.column_stack([u, w]) @ turn.T
    low = np.maximum(flat.min(axis=0), other.min(axis=0))
    high = np.minimum(flat.max(axis=0), other.max(axis=0))
    smaller = min(float(np.prod(np.ptp(flat, axis=0))), float(np.prod(np.ptp(other, axis=0))))
    common = float(np.prod(np.clip(high - low, 0.0, None)))
    return common / smaller if smaller > 0 else 0.0


def _compound(
    first: GpsFeature, second: GpsFeature, gap: float, id_: int, number: int
) -> GpsFeature:
    slot = gap > 0
    normal = first.place.direction
    middle = vector(np.mean([first.place.point, second.place.point], axis=0))
    feature = group_of(
        (first, second),
        id_=id_,
        name=f"{'Slot' if slot else 'Rib'} {number}",
        kind="slot" if slot else "rib",
        invariance_class="planar",
        situations=(SituationFeature("planar", middle, normal),),
        situation={"point": list(middle), "normal": list(normal)},
        intrinsic={"width": abs(gap)},
        size=Size("width", abs(gap)),
        derived="median plane",
    )
    return replace(feature, material="internal" if slot else "external")
