# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that a partition can be written as, with the user's overrides in them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from gpswb.cad.freecad_measured import is_measurement
from gpswb.errors import InputError
from gpswb.gps.review import review
from gpswb.gui.annotation import annotation_of
from gpswb.gui.annotation_rows import specification_rows
from gpswb.gui.original_file import original_of
from gpswb.gui.partition_result import effective_result
from gpswb.gui.pieces import without_pieces
from gpswb.io.ap242.part21 import Part21
from gpswb.io.ap242.present import present_pmi
from gpswb.io.ap242.verified import write_verified_ap242
from gpswb.io.ap242.write import read_text
from gpswb.io.faces_csv import write_faces
from gpswb.io.features_csv import write_features_csv, write_specifications_csv
from gpswb.io.features_json import features_document, write_features_json
from gpswb.io.labels_npz import write_labels
from gpswb.io.ply import write_ply
from gpswb.io.qif import write_qif
from gpswb.io.result_json import write_result
from gpswb.io.specification_file import write_specifications
from gpswb.io.step_coloured import write_coloured_step
from gpswb.io.stored_result import StoredResult
from gpswb.io.whole import whole_file
from gpswb.report.part_report import write_report
from gpswb.sentence import Sentence


def _plain(obj: Any) -> StoredResult:
    return without_pieces(effective_result(obj)[0])


def _result(path: Path, obj: Any) -> None:
    write_result(path, dict(_plain(obj).document))


def _faces(path: Path, obj: Any) -> None:
    write_faces(path, _plain(obj).faces)


def _labels(path: Path, obj: Any) -> None:
    stored = _plain(obj)
    solid = stored.solid
    write_labels(path, stored.partition, solid.facemap, solid.pointmap)


def _ply(path: Path, obj: Any) -> None:
    write_ply(path, _plain(obj).partition)


def _report(path: Path, obj: Any) -> None:
    stored = _plain(obj)
    facemap = stored.solid.facemap
    features = _document(obj) if facemap is not None else None
    write_report(path, dict(stored.document), stored.partition, facemap, features)


def _features(path: Path, obj: Any) -> None:
    write_features_json(path, _document(obj))


def _document(obj: Any) -> dict[str, Any]:
    """Features and annotations, with a review of the PMI that the part's own STEP file holds."""
    stored, annotation = _plain(obj), annotation_of(obj)
    try:
        present, _ = present_pmi(*original_of(obj.Source, stored.solid))
    except InputError:  # there is no such file, or not any more
        present = None
    remarks = review(present, annotation.table) if present else ()
    return features_document(annotation, stored.document["source"], remarks)


def _features_csv(path: Path, obj: Any) -> None:
    write_features_csv(path, annotation_of(obj))


def _specifications_csv(path: Path, obj: Any) -> None:
    write_specifications_csv(path, annotation_of(obj))


def _given_csv(path: Path, obj: Any) -> None:
    annotation_of(obj)  # a document may be damaged: only what a table can say goes into one
    write_specifications(path, specification_rows(obj))


def _ap242(path: Path, obj: Any) -> str:
    """The text of the part's own STEP file with the annotations appended as `gpswb annotate` does;
    where that can't be, the part as FreeCAD writes it, and why."""
    solid, annotation = effective_result(obj)[0].solid, annotation_of(obj)
    pmi = annotation.letters, annotation.specified
    try:
        write_verified_ap242(path, *original_of(obj.Source, solid), *pmi)
    except InputError as error:
        write_verified_ap242(path, _as_freecad_writes(obj), solid, *pmi)
        return Sentence(
            "PMI is not on the original STEP text but on the part as FreeCAD writes it: {why}",
            why=str(error),
        )
    return Sentence("PMI is appended to the text of {path}", path=obj.Source.StepFile)


def _coloured(path: Path, obj: Any) -> None:
    stored = effective_result(obj)[0]
    classes = {f.name: f.invariance_class for f in stored.faces if f.invariance_class is not None}
    features = annotation_of(obj).table.integral
    names = {name: f.name for f in features for name in f.faces}
    try:
        write_coloured_step(path, *original_of(obj.Source, stored.solid), classes, names)
    except InputError:
        write_coloured_step(path, _as_freecad_writes(obj), stored.solid, classes, names)


def _as_freecad_writes(obj: Any) -> Part21:
    with TemporaryDirectory() as folder:
        plain = Path(folder) / "part.step"
        obj.Source.Shape.exportStep(str(plain))
        return read_text(plain)


def _qif(path: Path, obj: Any) -> None:
    write_qif(path, annotation_of(obj), obj.Source.Label)


FORMATS: Mapping[str, tuple[str, Callable[[Path, Any], str | None]]] = {
    ".html": ("Report", _report),
    ".json": ("Result", _result),
    ".csv": ("Faces", _faces),
    ".features.json": ("GPS features", _features),
    ".features.csv": ("GPS features, table", _features_csv),
    ".specifications.csv": ("Permitted specifications, table", _specifications_csv),
    ".given.csv": ("Given specifications, table", _given_csv),
    ".ap242.step": ("AP242 with semantic PMI", _ap242),
    ".coloured.step": ("STEP, faces named and coloured by class", _coloured),
    ".qif": ("QIF 3.0", _qif),
    ".ply": ("Mesh coloured by class", _ply),
    ".npz": ("Mesh with labels", _labels),
}
"""Kind and writer by suffix, the longer where two fit; a writer may have something to say."""
_OF_MEASURED = (".html", ".json", ".ply", ".npz")
"""What a part without faces can be written as."""


def formats_of(obj: Any) -> dict[str, str]:
    """Kind by suffix of all that a partition can be written as."""
    fitting = _OF_MEASURED if is_measurement(obj.Source) else tuple(FORMATS)
    return {suffix: FORMATS[suffix][0] for suffix in fitting}


def export(obj: Any, path: Path) -> str:
    """Write a partition as what the file's suffix says, whole or not at all.

    Returns:
        What there is to say of it; empty for nothing.

    Raises:
        InputError: it has no result, or the suffix is unknown or needs faces that a mesh hasn't.
        OutputError: the file can't be written.
    """
    name = path.name.lower()
    fitting = [suffix for suffix in FORMATS if name.endswith(suffix)]
    if not fitting:
        raise InputError(
            Sentence(
                "{name}: the name must end in one of {suffixes}",
                name=path.name,
                suffixes=", ".join(FORMATS),
            )
        )
    suffix = max(fitting, key=len)
    kind, write = FORMATS[suffix]
    if suffix not in formats_of(obj):
        raise InputError(
            Sentence(
                "{name}: {kind}: {part} is a mesh without CAD faces",
                name=path.name,
                kind=Sentence(kind),
                part=obj.Source.Label,
            )
        )
    with whole_file(path) as draft:
        return write(draft, obj) or ""
