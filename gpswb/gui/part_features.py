# SPDX-License-Identifier: LGPL-2.1-or-later
"""The GPS features of a stored result."""

from __future__ import annotations

from collections.abc import Sequence

from gpswb.gps.feature_table import FeatureTable, feature_table
from gpswb.gps.gps_feature import GpsFeature
from gpswb.gps.on_faces import features_on
from gpswb.io.stored_result import StoredResult
from gpswb.validation.face_result import faces_and_bodies, faces_without_region

_last: list[tuple[StoredResult, FeatureTable]] = []
"""The table that was made last: panels ask for it at every click."""


def features_of(stored: StoredResult) -> FeatureTable:
    """The feature table; each face goes with the region that has most of it.

    Raises:
        InputError: a region lacks what its class needs.
    """
    if _last and _last[0][0] is stored:
        return _last[0][1]
    faces, bodies = faces_and_bodies(stored.faces)
    without = faces_without_region(stored.faces)
    table = feature_table(stored.partition, faces, bodies=bodies, without=without)
    _last[:] = [(stored, table)]
    return table


def features_at(stored: StoredResult, faces: Sequence[str]) -> list[GpsFeature]:
    """Features that faces may mean: what they make up, then the compounds that hold them."""
    table = features_of(stored)
    found = list(features_on(table.features, faces)[0])
    wanted = set(faces)
    return found + [f for f in table.compounds if wanted <= set(f.faces) and f not in found]
