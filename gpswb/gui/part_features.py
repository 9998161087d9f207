# SPDX-License-Identifier: LGPL-2.1-or-later
"""The GPS features of a stored result."""

from __future__ import annotations

from gpswb.gps.feature_table import FeatureTable, feature_table
from gpswb.io.stored_result import StoredResult

_last: list[tuple[StoredResult, FeatureTable]] = []
"""The table that was made last: panels ask for it at every click."""


def features_of(stored: StoredResult) -> FeatureTable:
    """The feature table; each face goes with the region that has most of it.

    Raises:
        InputError: a region lacks what its class needs.
    """
    if _last and _last[0][0] is stored:
        return _last[0][1]
    faces: dict[int, list[str]] = {}
    for face in stored.faces:
        for region in face.regions[:1]:
            faces.setdefault(region, []).append(face.name)
    table = feature_table(stored.partition, faces)
    _last[:] = [(stored, table)]
    return table
