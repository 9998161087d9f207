# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces that the user has named, found again in a part that has changed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from gpswb.errors import InputError
from gpswb.gui.pieces import PIECE
from gpswb.io.stored_result import StoredResult
from gpswb.sentence import Sentence

SAME_AREA = 1e-6
"""Relative: areas come from the kernel and repeat to rounding."""
SAME_CENTRE = 0.01
"""Of the diagonal: centres come from the mesh, which may be of another density."""
SAME_PIECE = 0.1
"""Relative, for the areas of a measured part's regions: their borders lie where a run puts them."""


@dataclass(frozen=True)
class FaceKey:
    """A face as it was when the user named it: area mm², centre mm."""

    name: str
    area: float
    centre: tuple[float, float, float]


def face_keys(stored: StoredResult) -> list[FaceKey]:
    """A key for each face of a part, in order."""
    facemap = stored.solid.facemap
    if facemap is None:
        return []
    face, mesh = facemap.face_of_triangle, stored.solid.mesh
    inside, count = face >= 0, len(facemap.faces)
    weight = np.bincount(face[inside], mesh.areas[inside], minlength=count)
    centre = np.stack(
        [
            np.bincount(face[inside], (mesh.areas * mesh.centroids[:, k])[inside], minlength=count)
            for k in range(3)
        ],
        axis=1,
    ) / np.maximum(weight, 1e-300)[:, None]  # fmt: skip
    return [
        FaceKey(result.name, result.area, (float(c[0]), float(c[1]), float(c[2])))
        for result, c in zip(stored.faces, centre, strict=True)
    ]


def named_faces(stored: StoredResult, names: Sequence[str]) -> tuple[FaceKey, ...]:
    """The keys of faces by name.

    Raises:
        InputError: there is no such face, or no name.
    """
    known = {key.name: key for key in face_keys(stored)}
    missing = [name for name in names if name not in known]
    if missing or not names:
        raise InputError(
            Sentence("no face {name!r}", name=missing[0])
            if missing
            else Sentence("no face is chosen")
        )
    return tuple(known[name] for name in dict.fromkeys(names))


def find_faces(
    wanted: Sequence[FaceKey], keys: Sequence[FaceKey], diagonal: float
) -> tuple[list[int], list[Sentence]]:
    """Indices of faces in a part as it is now, and notes on those that moved, changed or went.

    Args:
        keys: of the part, in order.
        diagonal: the part's, mm.
    """
    by_name = {key.name: i for i, key in enumerate(keys)}
    found: list[int] = []
    notes: list[Sentence] = []
    for face in wanted:
        same = by_name.get(face.name)
        alike = [i for i, key in enumerate(keys) if _alike(key, face, diagonal)]
        if same is not None and same in alike:
            found.append(same)
        elif len(alike) == 1:
            notes.append(
                Sentence("{face} is now {other}", face=face.name, other=keys[alike[0]].name)
            )
            found.append(alike[0])
        elif same is not None and not face.name.startswith(PIECE):  # numbers of regions say nothing
            notes.append(Sentence("{face} has changed", face=face.name))
            found.append(same)
        else:
            notes.append(Sentence("{face} is gone", face=face.name))
    return list(dict.fromkeys(found)), notes


def face_key(entry: Any) -> FaceKey:
    """Read a key that `dataclasses.asdict` wrote.

    Raises:
        KeyError, TypeError, ValueError: it is damaged.
    """
    x, y, z = (float(value) for value in entry["centre"])
    return FaceKey(str(entry["name"]), float(entry["area"]), (x, y, z))


def _alike(key: FaceKey, wanted: FaceKey, diagonal: float) -> bool:
    near = float(np.linalg.norm(np.subtract(key.centre, wanted.centre))) <= SAME_CENTRE * diagonal
    same = SAME_PIECE if key.name.startswith(PIECE) else SAME_AREA
    return near and abs(key.area - wanted.area) <= same * max(key.area, wanted.area)
