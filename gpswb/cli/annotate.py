# SPDX-License-Identifier: LGPL-2.1-or-later
"""``gpswb annotate``: GPS features, datum systems and specifications of one part."""

from __future__ import annotations

import argparse
import re
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from gpswb.batch.settings import Settings
from gpswb.cli.guard import guarded
from gpswb.cli.options import add_density_option, add_pipeline_options, add_unit_option
from gpswb.io.whole import whole_directory

if TYPE_CHECKING:
    from gpswb.batch.one_part import Outcome
    from gpswb.gps.feature_table import FeatureTable

OWNED = (
    "features.json",
    "features.csv",
    "specifications.csv",
    "ap242.step",
    "part.qif",
    "coloured.step",
    "report.html",
)
"""Every file that this verb may write in the output directory."""

_DATUM = re.compile(r"\s*([A-Z]{1,3})\s*=\s*([^,=]+?)\s*")


def register(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the verb to the command's parser."""
    parser = verbs.add_parser(
        "annotate",
        help="GPS features, datum systems and permitted specifications of one part",
        description="INPUT is a part (STEP, BREP, FCStd) or a mesh (STL, PLY, OFF, OBJ).",
    )
    parser.add_argument("input", type=Path, metavar="INPUT")
    parser.add_argument("--out", type=Path, required=True, metavar="DIR")
    parser.add_argument(
        "--datums",
        type=datums,
        default=(),
        metavar="A=Face1,B=Face5+Face6,...",
        help="datum features in order of precedence, by faces or by names of the feature table",
    )
    parser.add_argument(
        "--system",
        default="",
        metavar="A|B-C|D><",
        help="datum system of these datums: B-C is a common datum, >< locks orientation only; "
        "default: each letter in turn",
    )
    parser.add_argument(
        "--specs",
        type=Path,
        metavar="FILE",
        help="tolerance values, JSON or CSV: feature, characteristic, value, datums, modifiers, "
        "upper, lower, fit",
    )
    parser.add_argument(
        "--ap242",
        action="store_true",
        help="write ap242.step: INPUT's own text with datums and given tolerances as semantic PMI",
    )
    parser.add_argument("--qif", action="store_true", help="write part.qif (QIF 3.0)")
    parser.add_argument("--csv", action="store_true", help="write features and specifications.csv")
    parser.add_argument(
        "--coloured",
        action="store_true",
        help="write coloured.step: faces named and coloured by class",
    )
    parser.add_argument("--no-report", action="store_true", help="don't write report.html")
    add_density_option(parser)
    add_pipeline_options(parser)
    add_unit_option(parser)
    parser.set_defaults(run=run)


def datums(text: str) -> tuple[tuple[str, str], ...]:
    """Argparse type of ``A=Face1,B=Face5+Face6``."""
    found = []
    for part in text.split(","):
        match = _DATUM.fullmatch(part)
        if match is None:
            raise argparse.ArgumentTypeError(f"{part!r} is no datum; write A=Face1,B=Face5+Face6")
        found.append((match[1], match[2]))
    return tuple(found)


def run(args: argparse.Namespace) -> int:
    """Do it; the exit code."""
    with whole_directory(args.out, OWNED) as draft:
        lines, names = guarded(lambda: _work(args, draft), str(args.input))
    for line in lines:
        print(line)
    print("wrote " + " ".join(str(args.out / name) for name in names))
    return 0


def _work(args: argparse.Namespace, draft: Path) -> tuple[list[str], list[str]]:
    """What is printed and the names of the files written in ``draft``."""
    from gpswb.batch.one_part import examine
    from gpswb.cli.annotation_files import STEP, read_present, write_all
    from gpswb.cli.annotation_lines import annotation_lines, review_lines
    from gpswb.cli.progress import stage_bar
    from gpswb.errors import InputError
    from gpswb.gps.annotation import annotate
    from gpswb.gps.review import review
    from gpswb.io.ap242.write import check_letters, read_text
    from gpswb.io.specification_file import read_specifications

    for option, asked in (("--ap242", args.ap242), ("--coloured", args.coloured)):
        if asked and args.input.suffix.lower() not in STEP:
            raise InputError(f"{args.input}: {option} is for STEP files")
    if args.system and not args.datums:
        raise InputError("--system is made of the letters that --datums gives")
    if args.ap242 and args.datums:
        # Said before the partition, not after it.
        check_letters(read_text(args.input), [letter for letter, _ in args.datums], str(args.input))
    rows = read_specifications(args.specs) if args.specs else ()
    settings = Settings(args.density, args.mode, args.method, args.kernel, unit=args.unit)
    with stage_bar() as progress:
        outcome = examine(args.input, settings, progress)
    table = features_of(outcome)
    present, note = read_present(args.input, outcome.solid)
    taken = {datum.letter for datum in present.datums} if present else set()
    annotation = annotate(table, args.datums, rows, args.system, taken)
    if note:
        outcome = replace(outcome, solid=replace(outcome.solid, notes=(*outcome.solid.notes, note)))
    remarks = review(present, table) if present else ()
    lines = annotation_lines(outcome.solid, annotation) + review_lines(remarks)
    said, names = write_all(draft, outcome, annotation, remarks, args)
    return lines + said, names


def features_of(outcome: Outcome) -> FeatureTable:
    """The feature table of a part; each B-rep face goes with the region that covers most of it."""
    from gpswb.gps.feature_table import feature_table
    from gpswb.validation.face_result import faces_and_bodies, faces_without_region

    results = outcome.validation.faces if outcome.validation else ()
    faces, bodies = faces_and_bodies(results)
    without = faces_without_region(results)
    return feature_table(outcome.partition, faces or None, bodies=bodies, without=without)
