# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object `GPS Partition`: what was recognised on a part, linked to the part.

    partition = make_partition(part, density="auto", mode="robust")
    print(partition.Classes)

It keeps its result as JSON and its mesh as a file within the document, never as Python objects, so
that a document opens whatever version of this workbench is there, or none.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from gpswb.cad.density import Density
from gpswb.cad.freecad_measured import is_measurement
from gpswb.core.invariance import InvarianceClass
from gpswb.errors import GpswbError, InputError
from gpswb.gui import compat, preferences
from gpswb.gui.aside import aside
from gpswb.gui.compat import translate
from gpswb.gui.fingerprint import fingerprint
from gpswb.gui.measured_changes import follow_measurements
from gpswb.gui.objects.annotation import animate as animate_annotation
from gpswb.gui.objects.feature import animate as animate_feature
from gpswb.gui.objects.feature import sync_features
from gpswb.gui.objects.stateless import Stateless
from gpswb.gui.overrides import Action, from_json, override_on, regions_to_json, to_json
from gpswb.gui.partition_result import (
    effective,
    effective_result,
    keep,
    read_run,
    stored_result,
)
from gpswb.gui.runs import Run
from gpswb.sentence import Sentence

NOT_RUN, CURRENT, STALE, FAILED = "not run", "up to date", "stale", "failed"
AS_READ = "as read"
"""Density of what was measured."""
STATUSES = (NOT_RUN, CURRENT, STALE, FAILED)

_PROPERTIES = (
    # type, name, group, editor mode (0 free, 1 read only, 2 hidden), what it is
    ("App::PropertyLink", "Source", "GPS", 0, "The part that is partitioned"),
    ("App::PropertyString", "Density", "GPS", 0, "Density of the mesh, as on the command line"),
    ("App::PropertyEnumeration", "Mode", "GPS", 0, "Mode of the partition"),
    ("App::PropertyString", "Datums", "GPS", 1, "Datum features, as A=Face1,B=Face5+Face6"),
    ("App::PropertyString", "DatumSystem", "GPS", 1, "Datum system of these, as A|B-C"),
    ("App::PropertyEnumeration", "Status", "GPS", 1, "Whether the result is that of the part"),
    ("App::PropertyString", "Message", "GPS", 1, "What went wrong, or what to know"),
    ("App::PropertyStringList", "Classes", "Result", 1, "Invariance class of each face, in order"),
    ("App::PropertyInteger", "Triangles", "Result", 1, "Triangles of the mesh"),
    ("App::PropertyInteger", "Regions", "Result", 1, "Recognised regions"),
    ("App::PropertyFloat", "AreaAccuracy", "Result", 1, "Share of the area that agrees with CAD"),
    ("App::PropertyFloat", "FaceAccuracy", "Result", 1, "Share of the faces that agree with CAD"),
    ("App::PropertyString", "Result", "Data", 2, "The result, JSON of schema gpswb-result/1"),
    ("App::PropertyFileIncluded", "Labels", "Data", 2, "The mesh with its labels (npz)"),
    ("App::PropertyPlacement", "FrameView", "Data", 2, "View that frames are laid out for"),
    ("App::PropertyFloat", "FrameRow", "Data", 2, "Between frames, mm; 0: axonometric view"),
    ("App::PropertyFloat", "FrameWidth", "Data", 2, "Of what that view shows, mm"),
    ("App::PropertyFloat", "FrameHeight", "Data", 2, "Of what that view shows, mm"),
    ("App::PropertyString", "Overrides", "Data", 2, "What the user knows better, JSON"),
    ("App::PropertyString", "Described", "Data", 2, "Regions fitted for the overrides, JSON"),
    ("App::PropertyString", "RunKey", "Data", 2, "Fingerprint of part and settings of the result"),
)
_OF_FACES = ("AreaAccuracy", "FaceAccuracy", "Datums", "DatumSystem")
"""Properties that say nothing of a part without faces."""


class PartitionProxy(Stateless):
    """Behaviour of the document object."""

    Type = "GpsPartition"

    def __init__(self, obj: Any) -> None:
        obj.Proxy = self
        compat.add_group(obj)
        _add_properties(obj)
        follow_measurements()

    def execute(self, obj: Any) -> None:
        """Recompute what is quick, mark as stale what is not."""
        self.refresh(obj)

    def refresh(self, obj: Any) -> None:
        """Bring the state up to date; run again if the last run was quick."""
        if not obj.Result:
            return
        if run_key(obj) == obj.RunKey:
            obj.Status = CURRENT
            return
        obj.Status, obj.Message = (
            STALE,
            compat.say(Sentence("part or settings have changed: run it again")),
        )
        if _last_run_s(obj) > preferences.recompute_limit_s():
            return
        try:
            run(obj)
        except GpswbError as error:
            obj.Status, obj.Message = FAILED, compat.say(str(error))

    def onDocumentRestored(self, obj: Any) -> None:
        """Give documents of older versions the properties that came later."""
        _add_properties(obj)
        follow_measurements()


def _add_properties(obj: Any) -> None:
    for kind, name, group, editor, text in _PROPERTIES:
        if not hasattr(obj, name):
            obj.addProperty(kind, name, group, text)
            obj.setEditorMode(name, editor)
            if name == "Mode":
                obj.Mode = list(preferences.MODES)
            elif name == "Status":
                obj.Status = list(STATUSES)


def is_partition(obj: Any) -> bool:
    """Whether a document object is a partition of ours."""
    return getattr(getattr(obj, "Proxy", None), "Type", "") == PartitionProxy.Type


def partitions(document: Any) -> list[Any]:
    """The partitions of a document.

    A FreeCAD without this workbench keeps all properties of our objects but not their behaviour: a
    document that was saved there gets it back here.
    """
    for obj in document.Objects:
        if getattr(obj, "Proxy", obj) is None:
            if hasattr(obj, "RunKey"):
                animate(obj)
            elif hasattr(obj, "LogLikelihood"):
                animate_feature(obj)
            elif hasattr(obj, "Annotation"):
                animate_annotation(obj)
    return [obj for obj in document.Objects if is_partition(obj)]


def animate(obj: Any) -> None:
    """Give a document object and its view their behaviour."""
    PartitionProxy(obj)
    if compat.has_window():
        from gpswb.gui.objects.partition_view import PartitionView

        PartitionView(obj.ViewObject)


def make_partition(source: Any, density: str = "", mode: str = "", *, compute: bool = True) -> Any:
    """Add a partition of ``source`` to its document.

    Args:
        source: a document object with a shape that has faces, a mesh or points.
        density, mode: as on the command line; the preferences' if not given. What was measured is
            taken as it is: its density is `AS_READ`.
        compute: run it, and wait; otherwise it stays `NOT_RUN` until `run`.

    Raises:
        InputError: the source has nothing to partition, or the density isn't valid.
        GpswbError: the run failed; the document is as it was.
    """
    source = usable_source(source)
    density = AS_READ if is_measurement(source) else density or preferences.default_density()
    check_density(density)
    obj = source.Document.addObject("App::FeaturePython", "GpsPartition")
    try:
        animate(obj)
        obj.Label = str(translate("GPS", "GPS Partition of {}")).format(source.Label)
        obj.Source = source
        obj.Density = density
        obj.Mode = mode or preferences.default_mode()
        parent = source.getParentGeoFeatureGroup()
        if parent is not None:
            parent.addObject(obj)
        if compute:
            run(obj)
    except BaseException:
        source.Document.removeObject(obj.Name)
        raise
    return obj


def usable_source(source: Any) -> Any:
    """The object to link to: of a feature within a body the body.

    Raises:
        InputError: it has no shape with faces, no mesh and no points.
    """
    parent = source.getParentGeoFeatureGroup()
    if parent is not None and parent.isDerivedFrom("PartDesign::Body"):
        source = parent
    if is_measurement(source):
        mesh = source.isDerivedFrom("Mesh::Feature")
        if not (source.Mesh.CountFacets if mesh else source.Points.CountPoints):
            raise InputError(Sentence("{part} is empty", part=source.Label))
    elif not getattr(getattr(source, "Shape", None), "Faces", None):
        raise InputError(Sentence("{part} has no faces to partition", part=source.Label))
    return source


def check_density(text: str) -> None:
    """Raise InputError where a density isn't valid."""
    if text == AS_READ:
        return
    try:
        Density.parse(text)
    except ValueError as error:
        raise InputError(str(error)) from None


def start_run(source: Any, density: str, mode: str, overrides: str = "") -> Run:
    """Start to partition a part in a process of its own; see `finish_run`.

    Args:
        overrides: what the partition's ``Overrides`` says; its regions are then fitted there, too.

    Raises:
        InputError: the density isn't valid.
    """
    if is_measurement(source):
        return Run("partition_measurement", source, mode, overrides)
    check_density(density)
    return Run("partition_shape", source, density, mode, overrides)


def finish_run(obj: Any, found: dict[str, Any], labels: Path) -> Iterator[None]:
    """Put the result of a run into the object, in slices: iterate to the end."""
    document = found["document"]
    obj.Labels = str(labels)
    obj.Result = json.dumps(document)
    obj.Described = found["described"]
    yield
    obj.RunKey = run_key(obj)
    stored = yield from aside(lambda: read_run(document, labels))
    keep(obj, stored)
    yield from show_result(obj)


def show_result(obj: Any) -> Iterator[None]:
    """Properties and children from the stored result and the overrides, in slices."""
    plain, overrides, described = stored_result(obj), obj.Overrides, obj.Described
    found = yield from aside(lambda: effective(plain, overrides, described))
    obj.Described = regions_to_json(found.described)
    stored, notes = found.stored, found.notes
    document = stored.document
    obj.Classes = [face.invariance_class or "none" for face in stored.faces]
    obj.Triangles = document["mesh"]["triangles"]
    obj.Regions = len(document["regions"])
    judged = document["validation"] or {}
    for name in _OF_FACES:
        obj.setEditorMode(name, 1 if document["faces"] else 2)
    obj.AreaAccuracy = judged.get("area_accuracy") or 0.0
    obj.FaceAccuracy = judged.get("face_accuracy") or 0.0
    obj.Message = "; ".join([*document["notes"], *map(compat.say, notes)])
    obj.Status = CURRENT
    yield
    yield from sync_features(obj, stored)
    from gpswb.gui.annotation_state import refresh_annotations

    refresh_annotations(obj)
    obj.purgeTouched()


def run(obj: Any) -> None:
    """Partition the source with the object's settings, and wait for it.

    Raises:
        GpswbError: it failed; the object keeps what it had.
    """
    work = start_run(usable_source(obj.Source), obj.Density, obj.Mode, obj.Overrides)
    try:
        for _ in finish_run(obj, work.result(), work.folder / "labels.npz"):
            pass
    finally:
        work.close()


def run_key(obj: Any) -> str:
    """What the result depends on: density, mode and the part's fingerprint."""
    part = fingerprint(obj.Source) if obj.Source else "none"
    return f"{obj.Density} {obj.Mode} {part}"


def add_override(
    obj: Any, action: Action, faces: Sequence[str], invariance_class: InvarianceClass | None = None
) -> None:
    """Merge or split the regions of faces, or change their class, from now on, and wait for it.

    Raises:
        InputError: the faces don't exist, or the action can't be done on them.
    """
    for _ in finish_change(obj, with_override(obj, action, faces, invariance_class)):
        pass


def clear_overrides(obj: Any) -> None:
    """Go back to what was recognised."""
    for _ in finish_change(obj, ""):
        pass


def with_override(
    obj: Any, action: Action, faces: Sequence[str], invariance_class: InvarianceClass | None = None
) -> str:
    """What ``Overrides`` says with one more; nothing is changed.

    Raises:
        InputError: as `add_override`.
    """
    current, _ = effective_result(obj)
    new = override_on(current, action, faces, invariance_class)
    return to_json([*from_json(obj.Overrides), new])


def start_change(obj: Any, overrides: str) -> Run:
    """Start to fit the regions of other overrides in a process of its own; see `finish_change`."""
    return Run("describe_overrides", obj, overrides, obj.Described)


def finish_change(obj: Any, overrides: str, described: str = "") -> Iterator[None]:
    """Make overrides those in force, in slices: iterate to the end.

    Args:
        described: what the run returned; without it regions are fitted here.
    """
    obj.Overrides = overrides
    obj.Described = described or obj.Described
    yield from show_result(obj)


def _last_run_s(obj: Any) -> float:
    """Seconds that the last run took, the start of its process included."""
    timings = json.loads(obj.Result)["timings_s"]
    return 1.0 + sum(value or 0.0 for value in timings.values())
