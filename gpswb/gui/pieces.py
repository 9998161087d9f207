# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can be picked on a measured part, which has no faces: its regions as they were recognised.

They stand in for faces, so that colours, picks and what the user knows better work alike on both.
They are no faces of CAD, and no file names them as such.
"""

from __future__ import annotations

import dataclasses

import numpy as np

from gpswb.cad.solid import Face, FaceMap
from gpswb.io.stored_result import StoredResult
from gpswb.validation.face_result import map_back

PIECE = "Region"
"""What names of pieces begin with; a region's number follows."""


def with_pieces(stored: StoredResult) -> StoredResult:
    """A result whose recognised regions stand in for faces; of a part with faces as it is."""
    if stored.faces:
        return stored
    partition = stored.partition
    pieces = tuple(Face(f"{PIECE}{r.id}", r.area, 0, None) for r in partition.regions)
    facemap = FaceMap(partition.region, pieces, np.arange(len(pieces)))
    return StoredResult(
        dataclasses.replace(stored.solid, facemap=facemap),
        partition,
        map_back(partition, facemap),
        stored.document,
    )


def without_pieces(stored: StoredResult) -> StoredResult:
    """A result as files show it: a measured part has no faces there."""
    if stored.document["faces"]:
        return stored
    return StoredResult(
        dataclasses.replace(stored.solid, facemap=None), stored.partition, (), stored.document
    )
