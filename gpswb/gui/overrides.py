# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user knows better: regions merged, split and reclassified, kept over a new run.

An override names faces, by name and by area and centre, so that it finds them again in a part that
has changed. It acts on the partition itself, so that colours, tables and exports all follow.
"""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal, get_args

import numpy as np

from gpswb.core.invariance import CLASSES, InvarianceClass
from gpswb.core.mesh import IntArray, Mesh
from gpswb.core.partition import Partition, Region
from gpswb.core.recognition import always, by_parsimony, recognise
from gpswb.core.region_samples import confined_normals, region_samples
from gpswb.core.sharp_edges import feature_edges
from gpswb.core.tolerances import Tolerances
from gpswb.errors import InputError
from gpswb.gui.face_keys import FaceKey, face_key, face_keys, find_faces, named_faces
from gpswb.io.result_json import face_entry, finite, region_entry
from gpswb.io.stored_result import StoredResult
from gpswb.validation.face_result import map_back

Action = Literal["merge", "split", "class"]


@dataclass(frozen=True)
class Override:
    """One decision of the user's; ``invariance_class`` belongs to the action ``class``."""

    action: Action
    faces: tuple[FaceKey, ...]
    invariance_class: InvarianceClass | None = None


def override_on(
    stored: StoredResult,
    action: Action,
    faces: Sequence[str],
    invariance_class: InvarianceClass | None = None,
) -> Override:
    """A decision on faces of a result.

    Raises:
        InputError: no such face, or too few, or no class where one is needed.
    """
    named = named_faces(stored, faces)
    if action == "merge" and len(faces) < 2:
        raise InputError("merging takes at least two faces")
    if (action == "class") != (invariance_class is not None):
        raise InputError("a class is given with the action 'class', and only with it")
    return Override(action, named, invariance_class)


def to_json(overrides: Sequence[Override]) -> str:
    """The text that a document keeps."""
    return json.dumps([dataclasses.asdict(each) for each in overrides]) if overrides else ""


def from_json(text: str) -> tuple[Override, ...]:
    """Read what `to_json` wrote.

    Raises:
        InputError: it is damaged.
    """
    try:
        entries = json.loads(text) if text else []
        return tuple(_override(entry) for entry in entries)
    except (KeyError, TypeError, ValueError) as error:
        raise InputError(f"the stored overrides are damaged ({error})") from None


def apply_overrides(
    stored: StoredResult, overrides: Sequence[Override]
) -> tuple[StoredResult, tuple[str, ...]]:
    """The result as the user wants it, and notes on what could not be applied or has moved."""
    notes: list[str] = []
    facemap = stored.solid.facemap
    if not overrides or facemap is None:
        return stored, ()
    keys = face_keys(stored)
    label = stored.partition.region.copy()
    regions: dict[int, Region] = dict(enumerate(stored.partition.regions))
    for each in overrides:
        faces, moved = find_faces(each.faces, keys, stored.solid.mesh.diagonal)
        notes += [f"{each.action}: {note}" for note in moved]
        touched = [np.flatnonzero(facemap.face_of_triangle == face) for face in faces]
        touched = [facets[label[facets] >= 0] for facets in touched]
        if each.action == "split":
            groups = touched
        elif each.action == "merge":
            groups = [np.concatenate(touched)] if len(touched) > 1 else []
        else:  # whole regions change their class
            whole = np.unique(label[np.concatenate(touched)]) if touched else np.empty(0, np.int64)
            groups = [np.flatnonzero(label == number) for number in whole]
        for facets in groups:
            if len(facets):
                number = max(regions) + 1
                merged = len(np.unique(stored.partition.initial_region[facets]))
                regions[number] = _described(stored.partition, facets, number, merged, each)
                label[facets] = number
    partition = _renumbered(stored.partition, label, regions)
    return _with_partition(stored, partition), tuple(notes)


def _described(
    partition: Partition, facets: IntArray, number: int, merged: int, override: Override
) -> Region:
    """A region of these facets, of the class the user gave or of the one that fits best."""
    used, corner = np.unique(partition.mesh.triangles[facets], return_inverse=True)
    mesh = Mesh(partition.mesh.vertices[used], corner.reshape(-1, 3))
    alone = np.zeros(len(facets), dtype=np.int64)
    normals = confined_normals(mesh, alone, feature_edges(mesh))
    (sample,) = region_samples(mesh, alone, 1, normals)
    given = override.invariance_class
    choose = by_parsimony if given is None else always(given)
    region = recognise(number, sample, merged, partition.sigma, Tolerances(), choose=choose)
    return region if given is None else dataclasses.replace(region, undecided=())


def _renumbered(partition: Partition, label: IntArray, regions: dict[int, Region]) -> Partition:
    """Regions that hold facets, numbered anew; those that lost facets are counted again."""
    kept = [number for number in sorted(regions) if (label == number).any()]
    position = np.full(max(regions, default=-1) + 2, -1, dtype=np.int64)
    position[kept] = np.arange(len(kept))
    areas = partition.mesh.areas
    return dataclasses.replace(
        partition,
        region=position[label],
        regions=tuple(
            dataclasses.replace(
                regions[number],
                id=i,
                triangles=int((label == number).sum()),
                area=float(areas[label == number].sum()),
            )
            for i, number in enumerate(kept)
        ),
    )


def _with_partition(stored: StoredResult, partition: Partition) -> StoredResult:
    facemap = stored.solid.facemap
    assert facemap is not None
    faces = tuple(
        dataclasses.replace(
            new, true_class=old.true_class, surface=old.surface, ambiguous=old.ambiguous
        )
        for new, old in zip(map_back(partition, facemap), stored.faces, strict=True)
    )
    listed = faces if stored.document["faces"] else ()  # a measured part's pieces are no faces
    on_region: dict[int, list[str]] = {}
    for face in listed:
        for region in face.regions:
            on_region.setdefault(region, []).append(face.name)
    document = {
        **stored.document,
        "regions": [finite(region_entry(r, on_region.get(r.id, []))) for r in partition.regions],
        "faces": [finite(face_entry(face)) for face in listed],
    }
    return StoredResult(stored.solid, partition, faces, document)


def _override(entry: Any) -> Override:
    action, given = entry["action"], entry["invariance_class"]
    if action not in get_args(Action) or (given is not None and given not in CLASSES):
        raise ValueError(f"{action!r} with class {given!r}")
    return Override(action, tuple(face_key(face) for face in entry["faces"]), given)
