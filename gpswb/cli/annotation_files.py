# SPDX-License-Identifier: LGPL-2.1-or-later
"""What `annotate` reads and writes beside the features themselves."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from gpswb.batch.one_part import Outcome
from gpswb.cad.pmi import Pmi
from gpswb.cad.solid import Solid
from gpswb.errors import InputError
from gpswb.gps.annotation import Annotation
from gpswb.gps.review import Remark
from gpswb.io.ap242.compare import differences
from gpswb.io.ap242.present import present_pmi
from gpswb.io.ap242.verified import check_read_back, write_verified_ap242
from gpswb.io.ap242.write import read_text
from gpswb.io.features_csv import write_features_csv, write_specifications_csv
from gpswb.io.features_json import features_document, write_features_json
from gpswb.io.qif import write_qif
from gpswb.io.result_json import result_document
from gpswb.io.step_coloured import write_coloured_step
from gpswb.report.part_report import write_report

STEP = (".step", ".stp", ".p21")


def read_present(path: Path, solid: Solid) -> tuple[Pmi | None, str]:
    """Semantic PMI that a STEP file holds, None for none; and what there is to say of it."""
    if path.suffix.lower() not in STEP or solid.facemap is None:
        return None, ""
    try:
        return present_pmi(read_text(path), solid)
    except InputError as error:
        # The kernel may read what is too odd for us: the features are there, the PMI isn't.
        return None, f"PMI in the file can't be reviewed: {error}"


def write_all(
    directory: Path,
    outcome: Outcome,
    annotation: Annotation,
    remarks: Sequence[Remark],
    args: argparse.Namespace,
) -> tuple[list[str], list[str]]:
    """Write what was asked for: lines to print, and the files' names, the main one first."""
    solid = outcome.solid
    source = {"path": solid.source, "sha256": solid.sha256, "unit": solid.unit}
    document = features_document(annotation, source, remarks)
    write_features_json(directory / "features.json", document)
    lines: list[str] = []
    names = ["features.json"]
    if not args.no_report:
        result = result_document(solid, outcome.partition, outcome.validation)
        report = directory / "report.html"
        write_report(report, result, outcome.partition, solid.facemap, document)
        names.append("report.html")
    if args.csv:
        write_features_csv(directory / "features.csv", annotation)
        write_specifications_csv(directory / "specifications.csv", annotation)
        names += ["features.csv", "specifications.csv"]
    if args.ap242:
        lines += ["", _export(directory / "ap242.step", args.input, solid, annotation)]
        names.append("ap242.step")
    if args.qif:
        write_qif(directory / "part.qif", annotation, Path(solid.source).name)
        names.append("part.qif")
    if args.coloured:
        lines += _colour(directory / "coloured.step", args.input, outcome, annotation)
        names.append("coloured.step")
    return lines, names


def _colour(path: Path, source: Path, outcome: Outcome, annotation: Annotation) -> list[str]:
    faces = outcome.validation.faces if outcome.validation else ()
    classes = {f.name: f.invariance_class for f in faces if f.invariance_class is not None}
    names = {name: f.name for f in annotation.table.integral for name in f.faces}
    lost = write_coloured_step(path, read_text(source), outcome.solid, classes, names)
    return [f"coloured.step: not found in the text: {' '.join(lost)}"] if lost else []


def _export(path: Path, source: Path, solid: Solid, annotation: Annotation) -> str:
    """Write AP242 and read it back, by our reader and by OCCT's where it is installed."""
    wanted = write_verified_ap242(
        path, read_text(source), solid, annotation.letters, annotation.specified
    )
    by = "read back"
    try:
        from gpswb.cad.pmi_read import read_pmi_ocp
    except ImportError:
        pass
    else:
        check_read_back(path, differences(wanted, read_pmi_ocp(path), occt=True))
        by = "read back, by OCCT as well"
    whose = "" if annotation.given else "suggested "
    counts = {
        f"{whose}datum": len(wanted.datums),
        "tolerance": len(wanted.tolerances),
        "size": len(wanted.sizes),
    }
    appended = ", ".join(f"{n} {what}{'' if n == 1 else 's'}" for what, n in counts.items())
    left = sum(each.open for each in annotation.specified)
    rest = f"; {left} without a value left out" if left else ""
    return f"ap242.step: {appended} appended and {by}{rest}"
