# SPDX-License-Identifier: LGPL-2.1-or-later
"""All compound features of a part."""

from __future__ import annotations

from collections.abc import Sequence

from gpswb.gps.coaxial import coaxial_features
from gpswb.gps.gps_feature import GpsFeature
from gpswb.gps.opposed_planes import opposed_planes
from gpswb.gps.patterns import hole_patterns
from gpswb.gps.tolerances import DEFAULT, Tolerances
from gpswb.gps.twists import Frame


def compound_features(
    features: Sequence[GpsFeature], frame: Frame, tolerances: Tolerances = DEFAULT
) -> tuple[GpsFeature, ...]:
    """Slots, ribs, coaxial groups, sunk holes and patterns; their ids follow the features'.

    Args:
        features: the maximal integral features of a part.
        frame: of the part.
    """
    found: list[GpsFeature] = []
    known = [feature for feature in features if feature.recognised]
    for detect in (opposed_planes, coaxial_features, hole_patterns):
        found += detect(known, frame, len(features) + len(found), tolerances)
    return tuple(found)
