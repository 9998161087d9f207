# SPDX-License-Identifier: LGPL-2.1-or-later
"""``gpswb validate``: many parts, a row each, totals, confusion, failures by kind, pictures."""

from __future__ import annotations

import argparse
from pathlib import Path

from gpswb.batch.settings import Settings
from gpswb.cli.options import (
    add_corpus_options,
    add_density_option,
    add_pipeline_options,
    non_negative,
    whole,
)

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
    add_corpus_options(parser)
    parser.add_argument(
        "--pictures",
        type=whole,
        default=12,
        metavar="N",
        help="of the N worst parts, and close-ups of each kind of failure; 12; 0 for none",
    )
    parser.add_argument(
        "--docs",
        type=Path,
        metavar="FILE.md",
        help="renew the section of this run in a document; of a directory, in its validation.md",
    )
    parser.add_argument("--title", help="of the run, in --docs and the report")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Do it; the exit code."""
    from gpswb.batch.job import Limits
    from gpswb.cli.corpus_files import check_docs, summary_lines, write_corpus, write_docs
    from gpswb.cli.corpus_run import collect, examine_all
    from gpswb.io.whole import whole_directory

    settings = Settings(
        args.density, args.mode, args.method, args.kernel, noise_added=args.noise_added
    )
    limits = Limits(args.time_limit, int(args.memory_limit * 1e9))
    files = collect(args.paths)
    title = args.title or describe(settings)
    command = command_line(args, settings)
    if args.docs:
        args.docs = args.docs / "validation.md" if args.docs.is_dir() else args.docs
        check_docs(args.docs, title)
    with whole_directory(args.out, OWNED) as draft:
        rows = examine_all(files, draft, settings, limits, args.cached, args.jobs)
        names = write_corpus(draft, rows, settings, title, command, args.pictures)
    if args.docs:
        write_docs(args.docs, rows, title, command)
    for line in summary_lines(rows):
        print(line)
    print("wrote " + " ".join(str(args.out / name) for name in names))
    if args.docs:
        print(f"renewed {title!r} in {args.docs}")
    return 0


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
