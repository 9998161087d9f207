# SPDX-License-Identifier: LGPL-2.1-or-later
"""``gpswb validate``: many parts, a row each, totals, confusion, failures by kind, pictures."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from gpswb.cli.options import (
    Settings,
    add_density_option,
    add_pipeline_options,
    non_negative,
    positive,
    positive_int,
)
from gpswb.errors import InputError

if TYPE_CHECKING:
    from gpswb.cli.corpus_job import Job, Limits
    from gpswb.validation.corpus import PartRow

SUFFIXES = (".step", ".stp", ".p21", ".brep", ".brp", ".rle", ".fcstd")
"""Endings, in lower case, of the files that are taken from a directory."""

OWNED = ("summary.csv", "summary.json", "faces.csv", "report.html", "parts", "pictures")
"""Everything that this verb may write in the output directory."""


def register(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the verb to the command's parser."""
    parser = verbs.add_parser(
        "validate",
        help="validate many parts against CAD: figures, confusion, failures by kind",
        description="Take every STEP, BREP and FCStd file named, or in the directories named.",
    )
    parser.add_argument("paths", type=Path, nargs="+", metavar="PATH")
    parser.add_argument("--out", type=Path, required=True, metavar="DIR")
    add_density_option(parser)
    add_pipeline_options(parser)
    parser.add_argument(
        "--noise-added",
        type=non_negative,
        default=0.0,
        metavar="FRACTION",
        help="displace the vertices by gaussian noise of this fraction of the diagonal",
    )
    parser.add_argument("--jobs", type=positive_int, default=2, metavar="N", help="at once; 2")
    parser.add_argument(
        "--time-limit", type=positive, default=300.0, metavar="SECONDS", help="a file; 300"
    )
    parser.add_argument(
        "--memory-limit", type=positive, default=6.0, metavar="GB", help="a file; 6"
    )
    parser.add_argument(
        "--pictures", type=int, default=12, metavar="N", help="of the N worst parts; 12"
    )
    parser.add_argument(
        "--docs", type=Path, metavar="FILE.md", help="renew the section of this run in a document"
    )
    parser.add_argument("--title", help="of the run, in --docs and the report")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Do it; the exit code."""
    from gpswb.cli.corpus_files import check_docs, summary_lines, write_corpus, write_docs
    from gpswb.cli.corpus_job import Limits
    from gpswb.io.whole import whole_directory

    settings = Settings(
        args.density, args.mode, args.method, args.kernel, noise_added=args.noise_added
    )
    limits = Limits(args.time_limit, int(args.memory_limit * 1e9))
    files = collect(args.paths)
    title = args.title or describe(settings)
    command = command_line(args, settings)
    if args.docs:
        check_docs(args.docs, title)
    with whole_directory(args.out, OWNED) as draft:
        rows = _examine_all(files, draft, settings, limits, args.jobs)
        names = write_corpus(draft, rows, settings, title, command, args.pictures)
    if args.docs:
        write_docs(args.docs, rows, title, command)
    for line in summary_lines(rows):
        print(line)
    print("wrote " + " ".join(str(args.out / name) for name in names))
    if args.docs:
        print(f"renewed {title!r} in {args.docs}")
    return 0


def _examine_all(
    files: Sequence[Path], draft: Path, settings: Settings, limits: Limits, parallel: int
) -> list[PartRow]:
    """Rows in the order of the files; the largest start first, so that none is left over."""
    from gpswb.cli.corpus_job import Job, run_jobs
    from gpswb.cli.progress import count_bar

    jobs = []
    taken: set[str] = set()
    for path in files:
        name, n = path.name, 2
        while name.lower() in taken:
            name, n = f"{path.name} ({n})", n + 1
        taken.add(name.lower())
        jobs.append(Job(path, name, draft / "parts" / name))
    rows: dict[Job, PartRow] = {}
    large_first = sorted(jobs, key=lambda job: -job.path.stat().st_size)
    with count_bar(len(jobs), "part") as step:
        for job, row in run_jobs(large_first, settings, limits, parallel):
            rows[job] = row
            step(job.name)
    return [rows[job] for job in jobs]


def collect(paths: Sequence[Path]) -> list[Path]:
    """The files named, and those with a CAD ending in the directories named, sorted by path.

    Raises:
        InputError: a path does not exist, or there is no file at all.
    """
    files: list[Path] = []
    for path in paths:
        if path.is_dir():
            try:
                inside = sorted(p for p in path.rglob("*") if p.suffix.lower() in SUFFIXES)
            except OSError as error:
                raise InputError(f"can't read {path}: {error.strerror or error}") from error
            files += [p for p in inside if p.is_file()]
        elif path.is_file():
            files.append(path)
        else:
            raise InputError(f"{path}: no such file or directory")
    unique = list(dict.fromkeys(files))
    if not unique:
        raise InputError(f"no STEP, BREP or FCStd file in {', '.join(map(str, paths))}")
    return unique


def describe(settings: Settings) -> str:
    """A title that tells runs of different settings apart."""
    parts = [f"density {settings.density}"]
    if settings.noise_added:
        parts.append(f"noise {100 * settings.noise_added:g} % of the diagonal")
    for value, usual in ((settings.mode, "robust"), (settings.method, "hybrid")):
        if value != usual:
            parts.append(value)
    if settings.kernel != "ocp":
        parts.append(f"kernel {settings.kernel}")
    return ", ".join(parts)


def command_line(args: argparse.Namespace, settings: Settings) -> str:
    """The command that makes the same figures again, with paths relative to here."""
    import os
    import shlex

    words = ["gpswb", "validate", *(os.path.relpath(path) for path in args.paths)]
    words += ["--density", str(settings.density)]
    if settings.noise_added:
        words += ["--noise-added", f"{settings.noise_added:g}"]
    for name in ("mode", "method", "kernel"):
        usual = {"mode": "robust", "method": "hybrid", "kernel": "ocp"}[name]
        if getattr(settings, name) != usual:
            words += [f"--{name}", getattr(settings, name)]
    if args.title:
        words += ["--title", args.title]
    words += ["--out", os.path.relpath(args.out)]
    if args.docs:
        words += ["--docs", os.path.relpath(args.docs)]
    return shlex.join(words)
