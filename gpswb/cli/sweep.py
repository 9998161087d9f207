# SPDX-License-Identifier: LGPL-2.1-or-later
"""``gpswb sweep``: accuracy against density and noise, for a part or a corpus; table, CSV, plot."""

from __future__ import annotations

import argparse
import csv
import dataclasses
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from gpswb.batch.settings import Settings
from gpswb.cad.density import FORMS, Density
from gpswb.cli.guard import guarded
from gpswb.cli.options import add_corpus_options, add_pipeline_options, density, non_negative
from gpswb.errors import InputError

OWNED = ("sweep.csv", "sweep.svg")
"""Everything that this verb may write in the output directory."""


@dataclasses.dataclass(frozen=True)
class Point:
    """One density and one noise: counts summed over the parts, figures their mean."""

    density: str
    noise: float
    parts: int
    triangles: int
    initial_regions: int
    regions: int
    area_accuracy: float
    face_accuracy: float
    region_f1: float
    seconds: float


def register(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the verb to the command's parser."""
    parser = verbs.add_parser(
        "sweep",
        help="accuracy against density and noise: table, CSV, plot",
        description=f"INPUT is a part or a directory. Densities, separated by commas: {FORMS}.",
    )
    parser.add_argument("input", type=Path, metavar="INPUT")
    parser.add_argument("--densities", type=densities, required=True, metavar="A,B,...")
    parser.add_argument(
        "--noise-added",
        type=fractions,
        default=[0.0],
        metavar="X,Y,...",
        help="gaussian noise added to the vertices, fractions of the diagonal",
    )
    parser.add_argument("--out", type=Path, metavar="DIR", help="write sweep.csv and sweep.svg")
    add_pipeline_options(parser)
    add_corpus_options(parser)
    parser.set_defaults(run=run)


def densities(text: str) -> list[Density]:
    """Argparse type of several densities; a bare number belongs to the density before it."""
    pieces: list[str] = []
    for piece in text.split(","):
        if pieces and piece.strip()[:1].isdigit():
            pieces[-1] += "," + piece
        else:
            pieces.append(piece)
    return [density(piece) for piece in pieces]


def fractions(text: str) -> list[float]:
    """Argparse type of several numbers of at least 0."""
    return [non_negative(piece) for piece in text.split(",")]


def run(args: argparse.Namespace) -> int:
    """Do it; the exit code."""
    from gpswb.cli.table import aligned
    from gpswb.io.whole import whole_directory

    if args.out is None:
        points = _measure_all(args)
    else:
        with whole_directory(args.out, OWNED) as draft:
            points = _measure_all(args)
            guarded(lambda: _write(draft, points, args.input.name), "the plot")
    for line in aligned(_cells(points), right=range(1, 10)):
        print(line)
    if args.out is not None:
        print("wrote " + " ".join(str(args.out / name) for name in OWNED))
    return 0


def _measure_all(args: argparse.Namespace) -> list[Point]:
    from gpswb.cli.corpus_run import collect

    files = collect([args.input])
    return [
        _measure(args, files, asked, noise)
        for noise in args.noise_added
        for asked in args.densities
    ]


def _measure(
    args: argparse.Namespace, files: Sequence[Path], asked: Density, noise: float
) -> Point:
    from gpswb.batch.job import Limits
    from gpswb.cli.corpus_run import examine_all
    from gpswb.validation.corpus import totals

    settings = Settings(asked, args.mode, args.method, args.kernel, noise_added=noise)
    limits = Limits(args.time_limit, int(args.memory_limit * 1e9))
    with tempfile.TemporaryDirectory() as scratch:
        rows = examine_all(files, Path(scratch), settings, limits, args.cached, args.jobs)
    judged = [row for row in rows if row.judged]
    if not judged:
        why = next((f": {row.message}" for row in rows if row.message), "")
        raise InputError(f"{args.input} has no CAD faces to judge by{why}")
    figures = totals(judged)
    return Point(
        density=str(asked),
        noise=noise,
        parts=len(judged),
        triangles=figures.triangles,
        initial_regions=sum(row.document["initial_region_count"] for row in judged),
        regions=sum(len(row.document["regions"]) for row in judged),
        area_accuracy=figures.mean_area,
        face_accuracy=figures.mean_face,
        region_f1=figures.mean_f1,
        seconds=round(sum(row.seconds for row in judged), 3),
    )


def _write(draft: Path, points: Sequence[Point], name: str) -> None:
    from gpswb.report.sweep_plot import write_sweep_plot

    rows: list[dict[str, Any]] = [dataclasses.asdict(point) for point in points]
    with (draft / "sweep.csv").open("w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        table.writeheader()
        table.writerows(rows)
    write_sweep_plot(draft / "sweep.svg", rows, name)


def _cells(points: Sequence[Point]) -> list[tuple[str, ...]]:
    head = (
        "density",
        "noise",
        "parts",
        "triangles",
        "initial",
        "regions",
        "area",
        "face",
        "F1",
        "s",
    )
    rows = [
        (
            p.density,
            f"{p.noise:g}",
            str(p.parts),
            str(p.triangles),
            str(p.initial_regions),
            str(p.regions),
            f"{p.area_accuracy:.4f}",
            f"{p.face_accuracy:.4f}",
            f"{p.region_f1:.4f}",
            f"{p.seconds:.1f}",
        )
        for p in points
    ]
    return [head, *rows]
