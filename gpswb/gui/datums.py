# SPDX-License-Identifier: LGPL-2.1-or-later
"""Datum features and datum systems of a partition, as document objects.

    from gpswb.gui.datums import set_datums
    set_datums(partition, [("A", ["Face6"]), ("B", ["Face7"])])

It works without a window. What doesn't fit the part is refused and leaves the document as it was.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from gpswb.errors import InputError
from gpswb.gps.annotation import annotate
from gpswb.gui.annotation_record import DatumRecord, Record, SystemRecord, letter_of
from gpswb.gui.annotation_rows import choice_of, placed_rows
from gpswb.gui.annotation_state import refresh_annotations
from gpswb.gui.face_keys import named_faces
from gpswb.gui.objects.annotation import annotations_of, put_annotation, record_of
from gpswb.gui.part_features import features_of
from gpswb.gui.partition_result import effective_result, stored_datums
from gpswb.sentence import Sentence

DatumChoice = tuple[str, Sequence[str]]
"""A letter and the names of its faces."""


def set_datums(partition: Any, datums: Sequence[DatumChoice], notation: str = "") -> Any:
    """Make these the datum features of a partition, and its datum system the one in force.

    Args:
        datums: letters with their faces, in order of precedence.
        notation: the system, as ``A|B-C|D><``; each letter in turn if not given.

    Returns:
        The object of the datum system; None if there are no datums.

    Raises:
        InputError: letters, faces or notation don't fit the part, or a specification names a datum
            that would be gone.
    """
    stored, _ = effective_result(partition)
    records = [DatumRecord(letter_of(name), named_faces(stored, faces)) for name, faces in datums]
    notation = notation or "|".join(record.letter for record in records)
    choices = [(record.letter, choice_of(record.faces)) for record in records]
    rows = placed_rows(partition, stored)
    annotate(features_of(stored), choices, rows, notation)
    old = {_letter(obj): obj for obj in annotations_of(partition) if _letter(obj)}
    for record in records:
        put_annotation(partition, old.pop(record.letter, None), record)
    systems = [obj for obj in annotations_of(partition) if isinstance(_record(obj), SystemRecord)]
    system = None
    if records:
        system = put_annotation(partition, next(iter(systems), None), SystemRecord(notation))
    for obj in [*old.values(), *(systems if not records else ())]:
        partition.Document.removeObject(obj.Name)
    refresh_annotations(partition)
    return system


def add_datum(partition: Any, letter: str, faces: Sequence[str]) -> Any:
    """Make faces a datum feature, the last of the datum system in force.

    Raises:
        InputError: the letter is taken, or the faces aren't of a feature.
    """
    present = datums_of(partition)
    if letter in dict(present):
        raise InputError(Sentence("datum {letter} is given twice", letter=letter))
    notation = partition.DatumSystem
    set_datums(
        partition, [*present, (letter, faces)], f"{notation}|{letter}" if notation else letter
    )
    return next(obj for obj in annotations_of(partition) if _letter(obj) == letter)


def take_suggestion(partition: Any, rank: int = 0) -> Any:
    """Make a suggested datum system the partition's: the best, or with rank 1 the runner-up.

    Raises:
        InputError: there is no such suggestion.
    """
    suggestions = suggested_datums(partition)
    if rank >= len(suggestions):
        raise InputError(Sentence("there is no such suggestion"))
    return set_datums(partition, suggestions[rank])


def suggested_datums(partition: Any) -> list[list[DatumChoice]]:
    """The best complete datum system, and the runner-up.

    Raises:
        InputError: the partition has no result.
    """
    stored, _ = effective_result(partition)
    suggestions = annotate(features_of(stored)).suggestions
    return [
        [(d.name, [face for f in d.features for face in f.faces]) for d in each.system.datums]
        for each in suggestions
    ]


def datums_of(partition: Any) -> list[DatumChoice]:
    """Letters and faces of a partition's datum features, as they are now."""
    return [(letter, choice.split("+")) for letter, choice in stored_datums(partition)]


def _letter(obj: Any) -> str:
    """Letter of a datum; empty for any other annotation."""
    record = _record(obj)
    return record.letter if isinstance(record, DatumRecord) else ""


def _record(obj: Any) -> Record | None:
    """What an annotation says; None if it is damaged."""
    try:
        return record_of(obj)
    except InputError:
        return None
