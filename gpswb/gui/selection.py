# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user has chosen: a part, a partition, faces."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import FreeCAD
import FreeCADGui

from gpswb.cad.freecad_measured import is_measurement
from gpswb.errors import InputError
from gpswb.gui.objects.annotation import is_annotation
from gpswb.gui.objects.feature import is_feature
from gpswb.gui.objects.partition import is_partition, partitions, usable_source
from gpswb.gui.partition_result import effective_result
from gpswb.gui.pieces import PIECE
from gpswb.validation.face_result import faces_and_bodies


def parts(document: Any) -> list[Any]:
    """Objects of a document that can be partitioned, those that nothing else is made of first."""
    found = []
    for obj in document.Objects:
        if is_partition(obj) or is_feature(obj) or is_annotation(obj):
            continue
        try:
            if usable_source(obj) is obj:
                found.append(obj)
        except InputError:
            continue
    return [obj for obj in found if not any(_is_made_of(user, obj) for user in found)]


def chosen_part() -> Any:
    """The part that is selected, or the only one of the document; None if neither."""
    document = FreeCAD.ActiveDocument
    if document is None:
        return None
    for obj in FreeCADGui.Selection.getSelection():
        if is_partition(obj):
            return obj.Source
        if is_feature(obj):
            continue
        try:
            return usable_source(obj)
        except InputError:
            continue
    known = parts(document)
    return known[0] if len(known) == 1 else None


def chosen_partition() -> Any:
    """The partition that is selected, itself or by its part or feature, or the only visible one."""
    document = FreeCAD.ActiveDocument
    if document is None:
        return None
    known = partitions(document)
    for obj in FreeCADGui.Selection.getSelection():
        for partition in known:
            if obj is partition or obj in partition.Group or obj is partition.Source:
                return partition
    shown = [partition for partition in known if partition.ViewObject.Visibility]
    return shown[0] if len(shown) == 1 else known[0] if len(known) == 1 else None


def with_result() -> Any:
    """The chosen partition, if it has a result."""
    partition = chosen_partition()
    return partition if partition is not None and partition.Result else None


def chosen_faces(partition: Any) -> list[str]:
    """Names of the selected faces of a partition's part; of a measured one, of its pieces."""
    found: list[str] = []
    for entry in FreeCADGui.Selection.getSelectionEx():
        if entry.Object is partition.Source or entry.Object is partition:
            found += [name for name in entry.SubElementNames if name.startswith(("Face", PIECE))]
        elif entry.Object not in partition.Group:
            continue
        elif is_annotation(entry.Object):
            found += [name for _, names in entry.Object.Faces for name in names]
        elif is_feature(entry.Object):
            on_region, _ = faces_and_bodies(effective_result(partition)[0].faces)
            found += on_region.get(entry.Object.Region, [])
    return list(dict.fromkeys(found))


def select_faces(partition: Any, names: Iterable[str]) -> None:
    """Select faces of a partition's part, or pieces of a measured one, and nothing else."""
    source = partition if is_measurement(partition.Source) else partition.Source
    FreeCADGui.Selection.clearSelection()
    for name in names:
        FreeCADGui.Selection.addSelection(source.Document.Name, source.Name, name)


def _is_made_of(user: Any, obj: Any) -> bool:
    return user is not obj and obj in user.OutList
