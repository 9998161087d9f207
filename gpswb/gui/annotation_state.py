# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the annotations of a partition come to on the part as it is now.

A part that changes takes its annotations along: their faces are found again by area and centre, and
what has no place any more says so in its ``Status``.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import FreeCAD
import numpy as np

from gpswb.core.mesh import FloatArray
from gpswb.errors import GpswbError, InputError
from gpswb.gps.annotation import Annotation, annotate
from gpswb.gps.datum_system import datum_system
from gpswb.gps.explain import explain_datum_system
from gpswb.gps.feature_table import FeatureTable
from gpswb.gps.specifications import permitted_specifications
from gpswb.gps.specified import GeometricalTolerance, Specified, specify
from gpswb.gui import compat
from gpswb.gui.annotation_record import DatumRecord, SystemRecord
from gpswb.gui.annotation_rows import UNPLACED, choice_of, faces_now, row_of
from gpswb.gui.frame_axes import axes_of, placement_of
from gpswb.gui.frame_places import MARK, FrameView, anchor_on, first_view, frame_places, frame_width
from gpswb.gui.objects.annotation import annotations_of, record_of
from gpswb.gui.part_features import features_of
from gpswb.gui.partition_result import effective_result
from gpswb.io.stored_result import StoredResult
from gpswb.sentence import Sentence, joined


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
            faces, notes = faces_now(stored, record.faces)
            obj.Faces = [(partition.Source, tuple(face.name for face in faces))]
            obj.Message = compat.say(joined("; ", notes))
            if isinstance(record, DatumRecord):
                datums[record.letter] = choice_of(faces)
        except GpswbError as error:
            obj.Status, obj.Message = UNPLACED, compat.say(str(error))
    annotation = _in_force(stored, datums, notation)
    partition.Datums = ",".join(f"{letter}={choice}" for letter, choice in datums.items())
    partition.DatumSystem = notation if annotation.given else ""
    for obj in objects:
        if obj.Status != UNPLACED:
            _describe(obj, stored, annotation)
    _place(partition, stored, [obj for obj in objects if obj.Cells])
    for obj in objects:
        obj.purgeTouched()


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
                raise InputError(Sentence("none of its datums is there"))
            if system.notation != record.notation:
                raise InputError(
                    Sentence("a datum of {system} isn't there", system=record.notation)
                )
            obj.Label = compat.say(Sentence("Datum system {system}", system=system.notation))
            obj.Status = "complete" if system.degrees >= annotation.needed else "not complete"
            obj.Message = compat.say(explain_datum_system(system, annotation.needed))
            return
        if isinstance(record, DatumRecord):
            features = annotation.letters[record.letter]
            obj.Label = compat.say(Sentence("Datum {letter}", letter=record.letter))
            obj.Cells = [record.letter]
            obj.Status, obj.Message = "allowed", notes
        else:
            (said,) = specify([row_of(stored, record)], annotation.table, annotation.letters)
            features = (said.feature,)
            obj.Label = _label(record.words["characteristic"], said.feature.name)
            obj.Cells = list(said.cells)
            obj.Status, why = _judged(said, annotation.table)
            obj.Message = "; ".join(text for text in (compat.say(why), notes) if text)
        obj.Feature = ", ".join(feature.name for feature in features)
    except GpswbError as error:
        obj.Status, obj.Message = UNPLACED, compat.say(str(error))


def _label(characteristic: str, feature: str) -> str:
    text = compat.say(
        Sentence("{what} of {feature}", what=Sentence(characteristic), feature=feature)
    )
    return text[:1].upper() + text[1:]


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


def place_frames(partition: Any, view: FrameView) -> None:
    """Lay all frames of a partition out for a view, those moved by hand too."""
    placement = placement_of(view.axes)
    placement.Base = FreeCAD.Vector(*view.offset)
    partition.FrameView, partition.FrameRow = placement, view.row
    partition.FrameWidth, partition.FrameHeight = view.width, view.height
    for obj in annotations_of(partition):
        obj.Kept = False
    refresh_annotations(partition)


def _view_of(partition: Any, diagonal: float) -> FrameView:
    if not partition.FrameRow > 0:
        return first_view(diagonal)
    placement = partition.FrameView
    size = partition.FrameRow, partition.FrameWidth, partition.FrameHeight
    return FrameView(axes_of(placement), *size, np.array(tuple(placement.Base)))


def _place(partition: Any, stored: StoredResult, objects: Sequence[Any]) -> None:
    """Spread the frames beside the part."""
    index = {face.name: i for i, face in enumerate(stored.faces)}
    diagonal = stored.solid.mesh.diagonal
    view = _view_of(partition, diagonal)
    taken: list[FloatArray] = []
    for obj in objects:
        faces = [index[name] for _, names in obj.Faces for name in names]
        point, normal = anchor_on(stored, faces, taken, view.axes[2])
        taken.append(point)
        if obj.Kept:
            obj.Place = obj.Place - obj.Anchor + FreeCAD.Vector(*point)
        obj.Anchor, obj.Normal = tuple(point.tolist()), tuple(normal.tolist())
        obj.Mark = MARK * diagonal
    free = [i for i, obj in enumerate(objects) if not obj.Kept]
    if free:
        vertices = stored.solid.mesh.vertices
        corners = np.array([vertices.min(axis=0), vertices.max(axis=0)])
        kept = np.array([tuple(obj.Place) for obj in objects if obj.Kept]).reshape(-1, 3)
        widths = np.array([frame_width(objects[i].Cells, view.row) for i in free])
        places = frame_places(np.array(taken)[free], widths, corners, view, kept)
        for i, place in zip(free, places, strict=True):
            objects[i].View = placement_of(view.axes)
            objects[i].Place = tuple(place.tolist())


def _clear(obj: Any) -> None:
    obj.Cells, obj.Status, obj.Message, obj.Feature = [], "", "", ""
