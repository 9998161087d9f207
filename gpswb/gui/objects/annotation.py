# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document objects of datums, datum systems and specifications, children of a partition.

An object keeps its record as JSON; the other properties say what it comes to on the part as it is
now, and `gpswb.gui.annotation_state` fills them.
"""

from __future__ import annotations

from typing import Any

from gpswb.core.mesh import FloatArray
from gpswb.gui import compat
from gpswb.gui.annotation_record import Record, read_record, record_text
from gpswb.gui.frame_axes import placement_of
from gpswb.gui.objects.stateless import Stateless

_PROPERTIES = (
    # type, name, editor mode (1 read only, 2 hidden), what it is
    ("App::PropertyLinkSubList", "Faces", 1, "Faces of the part"),
    ("App::PropertyString", "Feature", 1, "GPS features that the faces make up"),
    ("App::PropertyStringList", "Cells", 1, "Compartments of the frame"),
    ("App::PropertyString", "Status", 1, "recommended, allowed, not allowed; or: can't be placed"),
    ("App::PropertyString", "Message", 1, "Why, or what it locks and leaves free"),
    ("App::PropertyVector", "Anchor", 2, "Where the leader ends on the part"),
    ("App::PropertyVector", "Normal", 2, "Of the part there"),
    ("App::PropertyVectorDistance", "Place", 1, "Where the frame stands"),
    ("App::PropertyBool", "Kept", 1, "The frame was moved by hand, and keeps its place"),
    ("App::PropertyPlacement", "View", 2, "Orientation of the view that it is laid out for"),
    ("App::PropertyFloat", "Mark", 2, "Height of a datum triangle, mm"),
    ("App::PropertyString", "Annotation", 2, "The annotation, JSON of schema gpswb-annotation/1"),
)


class AnnotationProxy(Stateless):
    """Behaviour of the document object: none, the partition fills it."""

    Type = "GpsAnnotation"

    def __init__(self, obj: Any) -> None:
        obj.Proxy = self
        _add_properties(obj)

    def execute(self, obj: Any) -> None:
        """Nothing depends on anything that the partition doesn't know first."""

    def onDocumentRestored(self, obj: Any) -> None:
        """Give documents of older versions the properties that came later."""
        _add_properties(obj)


def _add_properties(obj: Any) -> None:
    for kind, name, editor, text in _PROPERTIES:
        if not hasattr(obj, name):
            obj.addProperty(kind, name, "GPS", text)
            obj.setEditorMode(name, editor)


def is_annotation(obj: Any) -> bool:
    """Whether a document object is an annotation of ours."""
    return getattr(getattr(obj, "Proxy", None), "Type", "") == AnnotationProxy.Type


def annotations_of(partition: Any) -> list[Any]:
    """The annotations of a partition: datums, systems and specifications as they were made."""
    return [obj for obj in partition.Group if is_annotation(obj)]


def put_annotation(partition: Any, obj: Any, record: Record) -> Any:
    """Change what an annotation says, or with None for it add one; `refresh_annotations` is due."""
    if obj is None:
        return _new(partition, record)
    obj.Annotation = record_text(record)
    return obj


def _new(partition: Any, record: Record) -> Any:
    name = "Gps" + type(record).__name__.removesuffix("Record")
    obj = partition.Document.addObject("App::FeaturePython", name)
    animate(obj)
    obj.Annotation = record_text(record)
    partition.addObject(obj)
    return obj


def animate(obj: Any) -> None:
    """Give a document object and its view their behaviour."""
    AnnotationProxy(obj)
    if compat.has_window():
        from gpswb.gui.objects.annotation_view import AnnotationView

        AnnotationView(obj.ViewObject)


def record_of(obj: Any) -> Record:
    """What an annotation says.

    Raises:
        InputError: it is damaged.
    """
    return read_record(obj.Annotation)


def move_frame(obj: Any, place: FloatArray, axes: FloatArray) -> None:
    """Put a frame where the user wants it: at ``place`` (3,) as a view with these axes shows it."""
    obj.Kept, obj.View = True, placement_of(axes)
    obj.Place = tuple(place.tolist())
    obj.purgeTouched()
