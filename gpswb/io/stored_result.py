# SPDX-License-Identifier: LGPL-2.1-or-later
"""A finished run read back from result.json and labels.npz."""

from __future__ import annotations

import math
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from gpswb.cad.solid import Face, FaceMap, PointMap, Solid
from gpswb.core.invariance import CLASSES
from gpswb.core.mesh import Mesh
from gpswb.core.partition import Partition, Region
from gpswb.errors import InputError
from gpswb.io.result_json import SCHEMA
from gpswb.validation.face_result import FaceResult


@dataclass(frozen=True, eq=False)
class StoredResult:
    """What a run found, as `result_document` and `write_labels` stored it.

    Args:
        solid: the mesh and its provenance; its faces' truth is not stored, ``faces`` has the class.
        partition: the partition; curvatures are single precision.
        faces: one result a face; empty for a mesh input.
        document: the document itself.
    """

    solid: Solid
    partition: Partition
    faces: tuple[FaceResult, ...]
    document: Mapping[str, Any]


def read_stored_result(document: Mapping[str, Any], labels: Path) -> StoredResult:
    """Put a run together again.

    Args:
        document: of schema ``gpswb-result/1``.
        labels: the labels.npz of the same run.

    Raises:
        InputError: they are damaged, of another version, or not of one run.
    """
    if document.get("schema") != SCHEMA:
        raise InputError(f"the result is of schema {document.get('schema')!r}, not {SCHEMA!r}")
    try:
        with np.load(labels, allow_pickle=False) as file:
            arrays = {name: file[name] for name in file.files}
        return _assembled(document, arrays)
    except (KeyError, TypeError, ValueError, OSError, IndexError, zipfile.BadZipFile) as error:
        reason = f"{type(error).__name__}: {error}"
        raise InputError(f"the stored result is damaged ({reason})") from None


def face_results(document: Mapping[str, Any]) -> tuple[FaceResult, ...]:
    """The results of the faces, from the document alone.

    Raises:
        KeyError, TypeError, ValueError: it isn't such a document.
    """
    return tuple(
        FaceResult(
            name=str(face["name"]),
            invariance_class=_class_or_none(face["class"]),
            true_class=_class_or_none(face["true_class"]),
            surface=str(face["surface"]),
            area=_number(face["area"]),
            share=_number(face["share"]),
            triangles=int(face["triangles"]),
            regions=tuple(int(region) for region in face["regions"]),
            ambiguous=bool(face["ambiguous"]),
            undecided=tuple(_class(name) for name in face["undecided"]),
            solid=int(face.get("solid", 0)),  # documents of 0.1.0 don't tell
        )
        for face in document["faces"]
    )


def read_region(region: Mapping[str, Any]) -> Region:
    """A region from what `region_entry` made of it.

    Raises:
        KeyError, TypeError, ValueError: it isn't such an entry.
    """
    return Region(
        id=int(region["id"]),
        invariance_class=_class(region["class"]),
        area=_number(region["area"]),
        triangles=int(region["triangles"]),
        surface=str(region["surface"]),
        situation={
            str(name): [_number(x) for x in value] for name, value in region["situation"].items()
        },
        intrinsic={str(name): _number(value) for name, value in region["intrinsic"].items()},
        residual=_number(region["residual"]),
        margin=_number(region["margin"]),
        initial_regions=int(region["initial_regions"]),
        log_likelihood={
            _class(name): _number(value) for name, value in region["log_likelihood"].items()
        },
        undecided=tuple(_class(name) for name in region["undecided"]),
    )


def _assembled(document: Mapping[str, Any], arrays: Mapping[str, Any]) -> StoredResult:
    mesh = Mesh(arrays["vertices"], arrays["triangles"])
    m = len(mesh.triangles)
    regions = tuple(read_region(region) for region in document["regions"])
    faces = face_results(document)
    for name in ("region", "face", "shape_type", "initial_region"):
        if arrays[name].shape != (m,):
            raise ValueError(f"{name} has shape {arrays[name].shape} for {m} triangles")
    settings, timings = document["settings"], document["timings_s"]
    partition = Partition(
        mesh=mesh,
        shape_type=arrays["shape_type"].astype(np.int64),
        initial_region=arrays["initial_region"].astype(np.int64),
        region=_indices(arrays["region"], regions),
        regions=regions,
        vertex_shape_type=arrays["vertex_shape_type"].astype(np.int64),
        shape_index=arrays["shape_index"].astype(np.float64),
        curvedness=arrays["curvedness"].astype(np.float64),
        initial_region_count=int(document["initial_region_count"]),
        sharp_edge_regions=int(document["sharp_edge_regions"]),
        sigma=_number(settings["sigma"]),
        mode=str(settings["mode"]),
        method=str(settings["method"]),
    )
    cad = tuple(Face(face.name, face.area, face.solid, None) for face in faces)
    facemap = FaceMap(arrays["face"], cad, arrays["feature_of_face"]) if faces else None
    pointmap = None
    if "point_vertex" in arrays:
        pointmap = PointMap(arrays["point"], arrays["point_vertex"])
    source, made = document["source"], document["mesh"]
    solid = Solid(
        mesh=mesh,
        facemap=facemap,
        source=str(source["path"]),
        unit=str(source["unit"]),
        density=str(made["density"]),
        mesher=str(made["mesher"]),
        notes=tuple(str(note) for note in document["notes"]),
        sha256=str(source["sha256"]),
        timings={str(name): _number(value) for name, value in timings.items()},
        pointmap=pointmap,
    )
    return StoredResult(solid, partition, faces, document)


def _indices(ids: Any, regions: tuple[Region, ...]) -> Any:
    """(m,) index into ``regions`` from (m,) region ids; −1 stays."""
    known = np.array([region.id for region in regions], dtype=np.int64)
    order = np.argsort(known)
    place = np.clip(np.searchsorted(known, ids, sorter=order), 0, max(len(known) - 1, 0))
    found = order[place] if len(known) else np.full(len(ids), -1)
    if len(known) and not np.array_equal(known[found][ids >= 0], ids[ids >= 0]):
        raise ValueError("a triangle names a region that is not listed")
    return np.where(ids >= 0, found, -1)


def _class(name: Any) -> Any:
    if name not in CLASSES:
        raise ValueError(f"{name!r} is no invariance class")
    return name


def _class_or_none(name: Any) -> Any:
    return None if name is None else _class(name)


def _number(value: Any) -> float:
    """JSON's null stands for what was not finite."""
    return math.nan if value is None else float(value)
