# SPDX-License-Identifier: LGPL-2.1-or-later
"""Annotate a partition: datums, datum systems and specifications as document objects.

    from gpswb.gui.annotation import add_datum, add_specification, set_datums
    set_datums(partition, [("A", ["Face6"]), ("B", ["Face7"])])
    add_specification(partition, ["Face7"], "perpendicularity", value=0.1, datums="A")

All of it works without a window. What doesn't fit the part is refused and leaves the document as it
was. A part that changes later takes its annotations along: their faces are found again by area and
centre, and what has no place any more says so in its ``Status``.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from gpswb.errors import GpswbError, InputError
from gpswb.gps.annotation import Annotation, annotate
from gpswb.gps.datum_system import DatumSystem, Freedom, datum_system
from gpswb.gps.explain import explain_datum_system, explain_freedom
from gpswb.gps.feature_table import FeatureTable
from gpswb.gps.gps_feature import GpsFeature
from gpswb.gps.on_faces import features_on
from gpswb.gps.specifications import permitted_specifications
from gpswb.gps.specified import GeometricalTolerance, SpecificationRow, Specified, specify
from gpswb.gps.twists import rotations_of, translations_of
from gpswb.gui.annotation_record import (
    DatumRecord,
    SpecificationRecord,
    SystemRecord,
    letter_of,
)
from gpswb.gui.face_keys import FaceKey, face_keys, find_faces, named_faces
from gpswb.gui.frame_places import MARK, anchor_on, frame_places
from gpswb.gui.objects.annotation import annotations_of, new_annotation, record_of, set_record
from gpswb.gui.objects.partition import effective_result, stored_datums
from gpswb.gui.part_features import features_of
from gpswb.io.specification_file import specification_row
from gpswb.io.stored_result import StoredResult

UNPLACED = "can't be placed"
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
    choices = [(record.letter, _choice(record.faces)) for record in records]
    rows = [row for row in (_row_or_none(stored, obj) for obj in annotations_of(partition)) if row]
    annotate(features_of(stored), choices, rows, notation)
    old = {_letter(obj): obj for obj in annotations_of(partition) if _letter(obj)}
    for record in records:
        _put(partition, old.pop(record.letter, None), record)
    systems = [obj for obj in annotations_of(partition) if _is(obj, SystemRecord)]
    system = None
    if records:
        system = _put(partition, next(iter(systems), None), SystemRecord(notation))
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
        raise InputError(f"datum {letter} is given twice")
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
        raise InputError("there is no such suggestion")
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


def add_specification(
    partition: Any,
    faces: Sequence[str],
    characteristic: str,
    value: float | str = "?",
    datums: str = "",
    **words: float | str,
) -> Any:
    """Put a specification on the feature that the faces make up.

    Args:
        faces: names.
        characteristic: of ISO 1101, or ``size``.
        value: width or diameter of the zone, mm; "?" is open.
        datums: datum section, as ``A|B``.
        words: ``modifiers`` (M, L, R), ``upper``, ``lower``, ``fit``, as for ``--specs``.

    Raises:
        InputError: it can't be said of that feature, or a datum isn't there.
    """
    return set_specification(
        partition, None, faces, characteristic=characteristic, value=value, datums=datums, **words
    )


def set_specification(partition: Any, obj: Any, faces: Sequence[str], **words: float | str) -> Any:
    """Change a specification, or with None for it add one; see `add_specification`.

    Raises:
        InputError: it can't be said of that feature, or a datum isn't there.
    """
    stored, _ = effective_result(partition)
    record = SpecificationRecord(
        named_faces(stored, faces), {name: str(value) for name, value in words.items()}
    )
    row = specification_row("specification", {"feature": _choice(record.faces), **record.words})
    annotate(features_of(stored), stored_datums(partition), [row], partition.DatumSystem)
    obj = _put(partition, obj, record)
    refresh_annotations(partition)
    return obj


def remove_annotation(partition: Any, obj: Any) -> None:
    """Remove an annotation; of a datum that specifications refer to, they say so afterwards."""
    partition.Document.removeObject(obj.Name)
    refresh_annotations(partition)


def datums_of(partition: Any) -> list[DatumChoice]:
    """Letters and faces of a partition's datum features, as they are now."""
    return [(letter, choice.split("+")) for letter, choice in stored_datums(partition)]


def annotation_of(partition: Any) -> Annotation:
    """GPS features, datum system and specifications of a partition, as `gpswb annotate` has them.

    Raises:
        InputError: it has no result, or an annotation doesn't fit the part.
    """
    stored, _ = effective_result(partition)
    rows = specification_rows(partition)
    return annotate(features_of(stored), stored_datums(partition), rows, partition.DatumSystem)


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
                rows.append(_row(stored, record))
            except InputError as error:
                raise InputError(f"{obj.Label}: {error}") from None
    return rows


def refresh_annotations(partition: Any, without: Any = None) -> None:
    """Find the faces of all annotations again, and say what each comes to.

    Args:
        without: an annotation that is about to be deleted.
    """
    objects = [obj for obj in annotations_of(partition) if obj is not without]
    if not objects:
        if partition.Datums:
            partition.Datums = partition.DatumSystem = ""
        return
    stored, _ = effective_result(partition)
    datums: dict[str, str] = {}
    notation = ""
    for obj in objects:
        _clear(obj)
        try:
            record = record_of(obj)
            if isinstance(record, SystemRecord):
                notation = notation or record.notation
                continue
            names = _find(stored, record.faces, obj)
            obj.Faces = [(partition.Source, tuple(names))]
            if isinstance(record, DatumRecord):
                datums[record.letter] = "+".join(names)
        except GpswbError as error:
            obj.Status, obj.Message = UNPLACED, str(error)
    annotation = _in_force(stored, datums, notation)
    partition.Datums = ",".join(f"{letter}={choice}" for letter, choice in datums.items())
    partition.DatumSystem = notation if annotation.given else ""
    for obj in objects:
        if obj.Status != UNPLACED:
            _describe(obj, stored, annotation)
    _place(stored, [obj for obj in objects if obj.Cells])
    for obj in objects:
        obj.purgeTouched()


def explain_system(system: DatumSystem, needed: int) -> str:
    """What each letter locks, and what stays free of the part."""
    text = explain_datum_system(system, needed)
    if not 0 < system.degrees < 6:
        return text
    free = Freedom(translations_of(system.free), rotations_of(system.free), False)
    said = explain_freedom(free)
    return f"{text}\nOf the part {said}."


def _in_force(stored: StoredResult, datums: dict[str, str], notation: str) -> Annotation:
    """Features and datum system; where the system names a datum that is gone, every letter in turn;
    with no datum the suggested one."""
    table = features_of(stored)
    try:
        return annotate(table, list(datums.items()), (), notation if datums else "")
    except InputError:
        return annotate(table, list(datums.items()))


def _describe(obj: Any, stored: StoredResult, annotation: Annotation) -> None:
    record, notes = record_of(obj), obj.Message
    try:
        if isinstance(record, SystemRecord):
            system = annotation.system
            if system is None or not annotation.given:
                raise InputError("none of its datums is there")
            if system.notation != record.notation:
                raise InputError(f"a datum of {record.notation} isn't there")
            obj.Label = f"Datum system {system.notation}"
            obj.Status = "complete" if system.degrees >= annotation.needed else "not complete"
            obj.Message = explain_system(system, annotation.needed)
            return
        if isinstance(record, DatumRecord):
            features = annotation.letters[record.letter]
            obj.Label, obj.Cells = f"Datum {record.letter}", [record.letter]
            obj.Status, obj.Message = "allowed", notes
        else:
            (said,) = specify([_row(stored, record)], annotation.table, annotation.letters)
            features = (said.feature,)
            obj.Label = f"{record.words['characteristic'].capitalize()} of {said.feature.name}"
            obj.Cells = list(said.cells)
            obj.Status, why = _judged(said, annotation.table)
            obj.Message = "; ".join(text for text in (why, notes) if text)
        obj.Feature = ", ".join(feature.name for feature in features)
    except GpswbError as error:
        obj.Status, obj.Message = UNPLACED, str(error)


def _judged(said: Specified, table: FeatureTable) -> tuple[str, str]:
    """Status of a specification under its own datums, and the reason."""
    if not isinstance(said, GeometricalTolerance):
        return "allowed", ""
    if said.remark:
        return "not allowed", said.remark
    system = datum_system(said.datums, table.frame) if said.datums else None
    rows = permitted_specifications(said.feature, system)
    row = next(row for row in rows if row.characteristic == said.characteristic)
    return row.status, row.reason


def _place(stored: StoredResult, objects: Sequence[Any]) -> None:
    """Spread the frames beside the part."""
    index = {face.name: i for i, face in enumerate(stored.faces)}
    taken: list[Any] = []
    for obj in objects:
        faces = [index[name] for _, names in obj.Faces for name in names]
        point, normal = anchor_on(stored, faces, taken)
        taken.append(point)
        obj.Anchor, obj.Normal = tuple(point.tolist()), tuple(normal.tolist())
    if objects:
        vertices = stored.solid.mesh.vertices
        corners = np.array([vertices.min(axis=0), vertices.max(axis=0)])
        for obj, place in zip(objects, frame_places(np.array(taken), corners), strict=True):
            obj.Mark = MARK * stored.solid.mesh.diagonal
            obj.Place = tuple(place.tolist())


def _find(stored: StoredResult, faces: Sequence[FaceKey], obj: Any) -> list[str]:
    """Names of an annotation's faces now; notes on what moved go into its message."""
    keys = face_keys(stored)
    found, notes = find_faces(faces, keys, stored.solid.mesh.diagonal)
    if not found:
        raise InputError("; ".join(notes) or "it has no face")
    obj.Message = "; ".join(notes)
    return [keys[i].name for i in found]


def _row(stored: StoredResult, record: SpecificationRecord) -> SpecificationRow:
    keys = face_keys(stored)
    found, notes = find_faces(record.faces, keys, stored.solid.mesh.diagonal)
    if not found:
        raise InputError("; ".join(notes) or "it has no face")
    choice = _choice([keys[i] for i in found])
    return specification_row("specification", {"feature": choice, **record.words})


def _row_or_none(stored: StoredResult, obj: Any) -> SpecificationRow | None:
    """The row of a specification that is in order; None for any other annotation."""
    if obj.Status == UNPLACED or not _is(obj, SpecificationRecord):
        return None
    record = record_of(obj)
    assert isinstance(record, SpecificationRecord)
    return _row(stored, record)


def _put(partition: Any, obj: Any, record: Any) -> Any:
    if obj is None:
        return new_annotation(partition, record)
    set_record(obj, record)
    return obj


def _clear(obj: Any) -> None:
    obj.Cells, obj.Status, obj.Message, obj.Feature = [], "", "", ""


def _is(obj: Any, kind: type) -> bool:
    try:
        return isinstance(record_of(obj), kind)
    except InputError:
        return False


def _letter(obj: Any) -> str:
    """Letter of a datum; empty for any other annotation."""
    if not _is(obj, DatumRecord):
        return ""
    record = record_of(obj)
    assert isinstance(record, DatumRecord)
    return record.letter


def _choice(faces: Sequence[FaceKey]) -> str:
    return "+".join(face.name for face in faces)


def features_at(stored: StoredResult, faces: Sequence[str]) -> list[GpsFeature]:
    """Features that faces may mean: what they make up, then the compounds that hold them."""
    table = features_of(stored)
    found = list(features_on(table.features, faces)[0])
    wanted = set(faces)
    return found + [f for f in table.compounds if wanted <= set(f.faces) and f not in found]
