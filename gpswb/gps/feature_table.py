# SPDX-License-Identifier: LGPL-2.1-or-later
"""The feature table of a part: integral features, compounds, and the frame of its datums."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from gpswb.core.partition import Partition
from gpswb.gps.compound import compound_features
from gpswb.gps.features import maximal_features
from gpswb.gps.gps_feature import GpsFeature, unrecognised
from gpswb.gps.tolerances import DEFAULT, Tolerances
from gpswb.gps.twists import Frame


@dataclass(frozen=True, eq=False)
class FeatureTable:
    """All features of a part, the maximal integral ones first; ``frame`` is the part's."""

    features: tuple[GpsFeature, ...]
    frame: Frame

    @property
    def integral(self) -> tuple[GpsFeature, ...]:
        """Maximal integral features, by falling area: every face is in exactly one."""
        return tuple(f for f in self.features if f.kind == "integral")

    @property
    def compounds(self) -> tuple[GpsFeature, ...]:
        """Slots, ribs, groups, patterns and sunk holes."""
        return tuple(f for f in self.features if f.kind != "integral")


def feature_table(
    partition: Partition,
    faces: Mapping[int, Sequence[str]] | None = None,
    tolerances: Tolerances = DEFAULT,
    bodies: Mapping[int, int] | None = None,
    without: Sequence[tuple[str, int]] = (),
) -> FeatureTable:
    """Features of a partition.

    Args:
        partition: mesh in mm, oriented outwards.
        faces: names of the B-rep faces of each region id.
        bodies: number of the solid of each region id; all are of one where it isn't given.
        without: name and solid of each face that no region lies on: a feature each, without a
            class, after all others that are no compounds.

    Raises:
        InputError: a region lacks what its class needs, or the part has no extent.
    """
    frame = Frame.around(partition.mesh.vertices)
    known = maximal_features(partition, faces, tolerances, bodies)
    rest = (
        unrecognised(len(known) + i, i + 1, name, body) for i, (name, body) in enumerate(without)
    )
    integral = (*known, *rest)
    return FeatureTable((*integral, *compound_features(integral, frame, tolerances)), frame)
