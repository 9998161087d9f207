# SPDX-License-Identifier: LGPL-2.1-or-later
"""The GPS features of a stored result."""

from __future__ import annotations

from gpswb.gps.feature_table import FeatureTable, feature_table
from gpswb.io.stored_result import StoredResult
from gpswb.validation.face_result import faces_and_bodies

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
    table = feature_table(stored.partition, faces, bodies=bodies)
    _last[:] = [(stored, table)]
    return table
