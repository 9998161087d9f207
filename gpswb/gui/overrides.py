# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user knows better: regions merged, split and reclassified, kept over a new run.

An override names faces, by name and by area and centre, so that it finds them again in a part that
has changed. It acts on the partition itself, so that colours, tables and exports all follow.
"""

from __future__ import annotations

import dataclasses
import hashlib
import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Literal, get_args

import numpy as np

from gpswb.cad.solid import FaceMap
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
from gpswb.io.stored_result import StoredResult, read_region
from gpswb.sentence import Sentence, joined
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
        raise InputError(Sentence("merging takes at least two faces"))
    if (action == "class") != (invariance_class is not None):
        raise InputError(Sentence("a class is given with the action 'class', and only with it"))
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
        raise InputError(
            Sentence("the stored overrides are damaged ({error})", error=error)
        ) from None


def regions_to_json(described: Mapping[str, Region]) -> str:
    """The text that a document keeps of regions that were fitted."""
    entries = {key: finite(region_entry(region, ())) for key, region in described.items()}
    return json.dumps(entries) if entries else ""


def regions_from_json(text: str) -> dict[str, Region]:
    """Read what `regions_to_json` wrote.

    Raises:
        InputError: it is damaged.
    """
    try:
        return {key: read_region(entry) for key, entry in json.loads(text or "{}").items()}
    except (AttributeError, KeyError, TypeError, ValueError) as error:
        raise InputError(
            Sentence("the stored overrides are damaged ({error})", error=error)
        ) from None


@dataclass(frozen=True, eq=False)
class Effective:
    """A result as the user wants it.

    Args:
        stored: the result.
        notes: on overrides that found no place, and on faces that have moved.
        described: the regions that were fitted for it, by `Group.key`.
    """

    stored: StoredResult
    notes: tuple[Sentence, ...]
    described: Mapping[str, Region]


def apply_overrides(
    stored: StoredResult,
    overrides: Sequence[Override],
    known: Mapping[str, Region] = MappingProxyType({}),
    tell: Callable[[float], None] = lambda share: None,
) -> Effective:
    """The result as the user wants it.

    Args:
        known: regions that need not be fitted again, from an earlier `Effective`.
        tell: called with the share of the fits that is done; each may take a second.
    """
    facemap = stored.solid.facemap
    if not overrides or facemap is None:
        return Effective(stored, (), {})
    label, groups, notes = _regrouped(stored, facemap, overrides)
    regions: dict[int, Region] = dict(enumerate(stored.partition.regions))
    described = {}
    for i, group in enumerate(groups):
        tell(i / len(groups))
        found = known.get(group.key) or _described(stored.partition, group)
        described[group.key] = found
        regions[group.number] = found
    partition = _renumbered(stored.partition, label, regions)
    return Effective(_with_partition(stored, partition), tuple(notes), described)


@dataclass(frozen=True, eq=False)
class Group:
    """Facets that an override makes one region of that number.

    ``key`` tells whether it is the same as one that was described before.
    """

    number: int
    facets: IntArray
    invariance_class: InvarianceClass | None
    key: str


def _regrouped(
    stored: StoredResult, facemap: FaceMap, overrides: Sequence[Override]
) -> tuple[IntArray, list[Group], list[Sentence]]:
    """(m,) number of each facet's region, the regions that are new, and notes."""
    notes: list[Sentence] = []
    keys = face_keys(stored)
    label = stored.partition.region.copy()
    groups: list[Group] = []
    for each in overrides:
        faces, moved = find_faces(each.faces, keys, stored.solid.mesh.diagonal)
        notes += [joined(": ", [Sentence(each.action), note]) for note in moved]
        touched = [np.flatnonzero(facemap.face_of_triangle == face) for face in faces]
        touched = [facets[label[facets] >= 0] for facets in touched]
        if each.action == "split":
            united = touched
        elif each.action == "merge":
            united = [np.concatenate(touched)] if len(touched) > 1 else []
        else:  # whole regions change their class
            whole = np.unique(label[np.concatenate(touched)]) if touched else np.empty(0, np.int64)
            united = [np.flatnonzero(label == number) for number in whole]
        for facets in united:
            if len(facets):
                number = len(stored.partition.regions) + len(groups)
                key = _key(stored.partition, facets, each.invariance_class)
                groups.append(Group(number, facets, each.invariance_class, key))
                label[facets] = number
    return label, groups, notes


def _key(partition: Partition, facets: IntArray, given: InvarianceClass | None) -> str:
    """Hash of all that `_described` depends on."""
    mesh = partition.mesh
    found = hashlib.sha256(f"{given} {partition.sigma!r}".encode())
    found.update(mesh.vertices[mesh.triangles[facets]].tobytes())
    found.update(partition.initial_region[facets].tobytes())
    return found.hexdigest()


def _described(partition: Partition, group: Group) -> Region:
    """A region of these facets, of the class the user gave or of the one that fits best."""
    facets, given = group.facets, group.invariance_class
    used, corner = np.unique(partition.mesh.triangles[facets], return_inverse=True)
    mesh = Mesh(partition.mesh.vertices[used], corner.reshape(-1, 3))
    alone = np.zeros(len(facets), dtype=np.int64)
    normals = confined_normals(mesh, alone, feature_edges(mesh))
    (sample,) = region_samples(mesh, alone, 1, normals)
    merged = len(np.unique(partition.initial_region[facets]))
    choose = by_parsimony if given is None else always(given)
    region = recognise(group.number, sample, merged, partition.sigma, Tolerances(), choose=choose)
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
