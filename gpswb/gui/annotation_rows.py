# SPDX-License-Identifier: LGPL-2.1-or-later
"""The specifications of a partition as rows of a table for ``--specs``."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from gpswb.errors import InputError
from gpswb.gps.specified import SpecificationRow
from gpswb.gui.annotation_record import SpecificationRecord
from gpswb.gui.face_keys import FaceKey, face_keys, find_faces
from gpswb.gui.objects.annotation import annotations_of, record_of
from gpswb.gui.partition_result import effective_result
from gpswb.io.specification_file import specification_row
from gpswb.io.stored_result import StoredResult
from gpswb.sentence import Sentence, joined

UNPLACED = "can't be placed"
"""Status of an annotation that doesn't fit the part."""


def specification_rows(partition: Any) -> list[SpecificationRow]:
    """The specifications of a partition as rows of a table for ``--specs``.

    Raises:
        InputError: a face of one is gone.
    """
    stored, _ = effective_result(partition)
    rows = []
    for obj in annotations_of(partition):
        record = record_of(obj)
        if isinstance(record, SpecificationRecord):
            try:
                rows.append(row_of(stored, record))
            except InputError as error:
                raise InputError(joined(": ", [obj.Label, str(error)])) from None
    return rows


def placed_rows(partition: Any, stored: StoredResult) -> list[SpecificationRow]:
    """The rows of those specifications of a partition that have a place on the part."""
    placed = [obj for obj in annotations_of(partition) if obj.Status != UNPLACED]
    records = [record_of(obj) for obj in placed]
    return [row_of(stored, each) for each in records if isinstance(each, SpecificationRecord)]


def row_of(stored: StoredResult, record: SpecificationRecord) -> SpecificationRow:
    """The row of a specification on the part as it is now.

    Raises:
        InputError: its faces are gone.
    """
    faces, _ = faces_now(stored, record.faces)
    return specification_row("specification", {"feature": choice_of(faces), **record.words})


def faces_now(
    stored: StoredResult, faces: Sequence[FaceKey]
) -> tuple[tuple[FaceKey, ...], list[Sentence]]:
    """The faces of an annotation as they are now, and notes on those that moved or changed.

    Raises:
        InputError: all of them are gone.
    """
    keys = face_keys(stored)
    found, notes = find_faces(faces, keys, stored.solid.mesh.diagonal)
    if not found:
        raise InputError(joined("; ", notes) or Sentence("it has no face"))
    return tuple(keys[i] for i in found), notes


def choice_of(faces: Sequence[FaceKey]) -> str:
    """Faces as a choice of datums or a table of specifications names them."""
    return "+".join(face.name for face in faces)
