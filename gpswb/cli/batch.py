# SPDX-License-Identifier: LGPL-2.1-or-later
"""``gpswb batch``: many parts, a process each, resumable, here or on a cluster; a table."""

from __future__ import annotations

import argparse
import re
from collections.abc import Generator, Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from gpswb.batch.messages import one_line
from gpswb.batch.settings import Settings
from gpswb.cli.options import (
    add_corpus_options,
    add_density_option,
    add_pipeline_options,
    add_unit_option,
)
from gpswb.errors import InputError

if TYPE_CHECKING:
    from gpswb.batch.job import End, Job
    from gpswb.batch.records import Summary

AMBIGUOUS = (".txt", ".csv")
"""Endings of point clouds that in a directory mostly are something else."""


def register(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the verb to the command's parser."""
    parser = verbs.add_parser(
        "batch",
        help="partition many parts, resumably, on one machine or many; a table",
        description="Take every part, mesh and point cloud below DIR, a directory or a URL "
        "(s3://..., zip://::parts.zip). The same command again goes on where a run was ended.",
    )
    parser.add_argument("directory", metavar="DIR")
    parser.add_argument("--out", type=Path, required=True, metavar="DIR")
    add_density_option(parser)
    add_pipeline_options(parser)
    add_unit_option(parser)
    add_corpus_options(parser)
    parser.add_argument(
        "--shard", type=shard, default=(1, 1), metavar="I/N", help="do the I-th of N shares only"
    )
    parser.add_argument(
        "--retry", action="store_true", help="do parts again that crashed or met a limit"
    )
    parser.add_argument(
        "--scheduler",
        metavar="ADDRESS",
        help="of Dask, tcp://HOST:PORT: its workers do the parts, --jobs is theirs to say",
    )
    parser.set_defaults(run=run)


def shard(text: str) -> tuple[int, int]:
    """Argparse type of ``I/N``."""
    match = re.fullmatch(r"([0-9]{1,6})/([0-9]{1,6})", text)
    if not match or not 1 <= int(match[1]) <= int(match[2]):
        raise argparse.ArgumentTypeError(f"{text!r} is not I/N with 1 <= I <= N")
    return int(match[1]), int(match[2])


def run(args: argparse.Namespace) -> int:
    """Do it; the exit code."""
    from gpswb.batch.cache import Cache
    from gpswb.batch.job import Limits
    from gpswb.batch.local import run_local
    from gpswb.batch.run import run_batch
    from gpswb.batch.shard import Shard
    from gpswb.batch.source import CAD, find_parts, is_url
    from gpswb.cli.progress import count_bar
    from gpswb.io.measured_file import SUFFIXES

    settings = Settings(args.density, args.mode, args.method, args.kernel, unit=args.unit)
    limits = Limits(args.time_limit, int(args.memory_limit * 1e9))
    # Absolute, because a worker may have another current directory.
    where = args.directory if is_url(args.directory) else str(Path(args.directory).absolute())
    suffixes = [suffix for suffix in (*CAD, *SUFFIXES) if suffix not in AMBIGUOUS]
    parts = find_parts(where, suffixes)
    if not parts:
        raise InputError(f"nothing to examine in {args.directory}; taken are {', '.join(suffixes)}")

    def execute(jobs: Iterable[Job]) -> Generator[tuple[Job, End]]:
        if args.scheduler:
            from gpswb.batch.cluster import run_on_cluster

            return run_on_cluster(jobs, settings, limits, args.cached, args.scheduler)
        cache = Cache.of_user() if args.cached else None
        return run_local(jobs, settings, limits, cache, args.jobs)

    summary = run_batch(
        parts,
        args.out,
        settings,
        execute,
        Shard(*args.shard),
        args.retry,
        lambda total, done: count_bar(total, "part", done),
    )
    for line in lines(summary, len(parts)):
        print(line)
    print("wrote " + " ".join(str(args.out / name) for name in (*summary.files, "parts")))
    return 0


def lines(summary: Summary, parts: int) -> list[str]:
    """What is printed: parts without a result, how many ended how."""
    said = [f"{r['part']}: {r['status']}: {r['message']}" for r in summary.lacking]
    ended, done = summary.ends.total(), summary.ends["done"]
    if ended - done > len(said):
        said.append(f"... and {ended - done - len(said)} more without a result")
    if summary.damaged:
        said.append(f"{summary.damaged} damaged lines in the record: their parts were done again")
    counts = ", ".join(f"{n} {status}" for status, n in summary.ends.most_common())
    said.append(f"{ended} of {parts} parts: {counts}")
    return [one_line(line) for line in said]
