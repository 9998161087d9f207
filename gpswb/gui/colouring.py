# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of faces and facets for each way of colouring a partition."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np
from scipy.sparse import csr_matrix

from gpswb.core.invariance import CLASSES, InvarianceClass
from gpswb.core.mesh import FloatArray, IntArray
from gpswb.gps.annotation import annotate
from gpswb.gps.relation import relation
from gpswb.gui.part_features import features_of
from gpswb.io.colours import NONE, SHAPE_TYPES, Rgb
from gpswb.io.stored_result import StoredResult
from gpswb.validation.face_result import facet_classes

ColourBy = Literal[
    "invariance class",
    "shape type",
    "initial region",
    "refined region",
    "agreement with CAD",
    "constraint state",
]
COLOUR_BY: tuple[ColourBy, ...] = get_args(ColourBy)

AGREEMENT: tuple[tuple[str, Rgb], ...] = (
    ("agrees", (0, 114, 178)),
    ("disagrees", (213, 94, 0)),
    ("no CAD class", NONE),
)
"""Blue and orange: the pair that every kind of colour vision tells apart."""
CONSTRAINT: tuple[tuple[str, Rgb], ...] = (
    ("datum", (35, 35, 35)),
    ("fully located", (0, 114, 178)),
    ("oriented, not located", (230, 159, 0)),
    ("not oriented", (213, 94, 0)),
    ("in no feature", NONE),
)


@dataclass(frozen=True, eq=False)
class Colouring:
    """Colours of a part.

    Args:
        names: what the colours mean, by label; empty where they only tell neighbours apart.
        palette: (k + 1, 3) float 0 to 1 by label; the last for the label −1.
        of_facet: (m,) label of each facet of the mesh.
        of_face: (f,) label of each face: the one with most of its area.
    """

    names: tuple[str, ...]
    palette: FloatArray
    of_facet: IntArray
    of_face: IntArray

    @property
    def face_colours(self) -> list[tuple[float, float, float]]:
        """One colour a face."""
        return [(r, g, b) for r, g, b in self.palette[self.of_face].tolist()]

    @property
    def counts(self) -> tuple[int, ...]:
        """Number of faces of each named label."""
        return tuple(int((self.of_face == i).sum()) for i in range(len(self.names)))


def colouring(
    stored: StoredResult,
    by: ColourBy,
    palette: Mapping[InvarianceClass, Rgb],
    datums: Sequence[tuple[str, str]] = (),
    notation: str = "",
) -> Colouring:
    """Colours of a result.

    Args:
        stored: the result, with faces or pieces.
        by: what the colours show.
        palette: colours of the classes.
        datums: letter and choice of each datum, for the constraint state; suggested if not given.
        notation: the datum system of these datums; each letter in turn if not given.

    Raises:
        InputError: a datum's choice doesn't fit the part.
    """
    partition = stored.partition
    if by == "invariance class":
        rows = tuple((name, palette[name]) for name in CLASSES)
        return _by_facet(stored, facet_classes(partition), rows)
    if by == "shape type":
        return _by_facet(stored, np.clip(partition.shape_type + 4, -1, 10), SHAPE_TYPES)
    if by == "initial region":
        return _by_facet(stored, partition.initial_region, ())
    if by == "refined region":
        return _by_facet(stored, partition.region, ())
    if by == "agreement with CAD":
        return _by_face(stored, _agreement(stored), AGREEMENT)
    return _by_face(stored, _constraint(stored, datums, notation), CONSTRAINT)


def _by_facet(stored: StoredResult, label: IntArray, rows: Sequence[tuple[str, Rgb]]) -> Colouring:
    count = len(rows) or int(label.max(initial=-1)) + 1
    return Colouring(_names(rows), _palette(rows, count), label, _majority(stored, label, count))


def _by_face(stored: StoredResult, label: IntArray, rows: Sequence[tuple[str, Rgb]]) -> Colouring:
    facemap = stored.solid.facemap
    assert facemap is not None
    of_facet = np.append(label, -1)[facemap.face_of_triangle]
    return Colouring(_names(rows), _palette(rows, len(rows)), of_facet, label)


def _names(rows: Sequence[tuple[str, Rgb]]) -> tuple[str, ...]:
    return tuple(name for name, _ in rows)


def _palette(rows: Sequence[tuple[str, Rgb]], count: int) -> FloatArray:
    if rows:
        return np.array([*(rgb for _, rgb in rows), NONE], dtype=np.float64) / 255
    # Hues by the golden ratio: numbers near each other, as neighbours' are, get unlike colours.
    hue = (np.arange(count) * 0.6180339887) % 1.0
    level = np.where(np.arange(count) % 2, 0.75, 0.95)
    ramp = np.abs((hue[:, None] * 6 + np.array([0.0, 4.0, 2.0])) % 6 - 3) - 1
    colours = level[:, None] * (1 - 0.6 * (1 - np.clip(ramp, 0, 1)))
    return np.vstack([colours, np.array(NONE) / 255])


def _majority(stored: StoredResult, label: IntArray, count: int) -> IntArray:
    """(f,) the label with most of each face's area; −1 where no facet has one."""
    facemap, area = stored.solid.facemap, stored.solid.mesh.areas
    assert facemap is not None
    use = (facemap.face_of_triangle >= 0) & (label >= 0)
    entries = (area[use], (facemap.face_of_triangle[use], label[use]))
    weight = csr_matrix(entries, shape=(len(facemap.faces), max(count, 1)))
    heaviest = np.asarray(weight.argmax(axis=1)).ravel()
    return np.where(np.diff(weight.indptr) > 0, heaviest, -1)


def _agreement(stored: StoredResult) -> IntArray:
    return np.array(
        [0 if face.agrees else 1 if face.disagrees else 2 for face in stored.faces], dtype=np.int64
    )


def _constraint(stored: StoredResult, datums: Sequence[tuple[str, str]], notation: str) -> IntArray:
    annotation = annotate(features_of(stored), datums, notation=notation)
    index = {face.name: i for i, face in enumerate(stored.faces)}
    label = np.full(len(stored.faces), 4, dtype=np.int64)
    if annotation.system is None:
        return label
    letters = {f.id for chosen in annotation.letters.values() for f in chosen}
    for feature in annotation.table.integral:
        if not feature.recognised:
            continue
        freedom = relation(feature, annotation.system).freedom
        if feature.id in letters:
            state = 0
        else:
            state = 1 if freedom.located else 2 if freedom.oriented else 3
        for name in feature.faces:
            label[index[name]] = state
    return label
