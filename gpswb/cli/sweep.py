# SPDX-License-Identifier: LGPL-2.1-or-later
"""``gpswb sweep``: accuracy against density (and noise) for one part; table, CSV and plot."""

from __future__ import annotations

import argparse
import csv
import dataclasses
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from gpswb.cad.density import FORMS, Density
from gpswb.cli.guard import guarded
from gpswb.cli.options import Settings, add_pipeline_options, density, non_negative
from gpswb.errors import InputError

OWNED = ("sweep.csv", "sweep.svg")
"""Everything that this verb may write in the output directory."""


@dataclasses.dataclass(frozen=True)
class Point:
    """One run of the sweep."""

    density: str
    noise: float
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
        help="accuracy against density and noise for one part: table, CSV, plot",
        description=f"Densities, separated by commas: {FORMS}.",
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
        rows = guarded(lambda: _measure_all(args, None), str(args.input))
    else:
        with whole_directory(args.out, OWNED) as draft:
            rows = guarded(lambda: _measure_all(args, draft), str(args.input))
    points = [Point(**row) for row in rows]
    for line in aligned(_cells(points), right=range(1, 9)):
        print(line)
    if args.out is not None:
        print("wrote " + " ".join(str(args.out / name) for name in OWNED))
    return 0


def _write(draft: Path, rows: Sequence[dict[str, Any]], name: str) -> None:
    from gpswb.report.sweep_plot import write_sweep_plot

    with (draft / "sweep.csv").open("w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        table.writeheader()
        table.writerows(rows)
    write_sweep_plot(draft / "sweep.svg", rows, name)


def _measure_all(args: argparse.Namespace, draft: Path | None) -> list[dict[str, Any]]:
    from gpswb.cli.progress import count_bar

    rows = []
    with count_bar(len(args.densities) * len(args.noise_added), "run") as step:
        for noise in args.noise_added:
            for asked in args.densities:
                rows.append(dataclasses.asdict(_measure(args, asked, noise)))
                step(f"{asked} {noise:g}")
    if draft is not None:
        _write(draft, rows, args.input.name)
    return rows


def _measure(args: argparse.Namespace, asked: Density, noise: float) -> Point:
    from gpswb.cli.one_part import examine

    settings = Settings(asked, args.mode, args.method, args.kernel, noise_added=noise)
    start = time.perf_counter()
    outcome = examine(args.input, settings)
    judged = outcome.validation
    if judged is None or judged.area_accuracy is None or judged.face_accuracy is None:
        raise InputError(f"{args.input} has no CAD faces to judge by")
    return Point(
        density=str(asked),
        noise=noise,
        triangles=len(outcome.partition.mesh.triangles),
        initial_regions=outcome.partition.initial_region_count,
        regions=len(outcome.partition.regions),
        area_accuracy=judged.area_accuracy,
        face_accuracy=judged.face_accuracy,
        region_f1=judged.region_f1,
        seconds=round(time.perf_counter() - start, 3),
    )


def _cells(points: Sequence[Point]) -> list[tuple[str, ...]]:
    head = ("density", "noise", "triangles", "initial", "regions", "area", "face", "F1", "s")
    return [
        head,
        *(
            (
                p.density,
                f"{p.noise:g}",
                str(p.triangles),
                str(p.initial_regions),
                str(p.regions),
                f"{p.area_accuracy:.4f}",
                f"{p.face_accuracy:.4f}",
                f"{p.region_f1:.4f}",
                f"{p.seconds:.1f}",
            )
            for p in points
        ),
    ]
