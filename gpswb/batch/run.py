# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many parts into one directory, by one run or by several that go on where others were ended.

``record.jsonl`` says which parts are done, ``parts/NAME`` holds what they gave. A part's results
are moved into place before the record names it: a run that is killed at any moment loses no part
that is in the record, and the next one does no such part again.
"""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Callable, Generator, Iterable, Sequence
from contextlib import AbstractContextManager, closing
from pathlib import Path

import gpswb
from gpswb.batch.columns import document_columns
from gpswb.batch.job import RESULTS, End, Job
from gpswb.batch.record import Entry, Record
from gpswb.batch.records import Known, Summary, read_records, summarise
from gpswb.batch.settings import Settings
from gpswb.batch.shard import Shard
from gpswb.batch.source import Part
from gpswb.errors import OutputError

SCHEMA = "gpswb-record/1"

RETRIED = ("crashed", "timeout", "memory")
"""Ends that another try, with other limits or on another machine, may turn into a result."""

Execute = Callable[[Iterable[Job]], Generator[tuple[Job, End]]]
"""Examines jobs: yields each with its end, its results in its directory."""

Counted = Callable[[int, int], AbstractContextManager[Callable[[str], None]]]


def run_batch(
    parts: Sequence[Part],
    out: Path,
    settings: Settings,
    execute: Execute,
    shard: Shard,
    retry: bool,
    counted: Counted,
) -> Summary:
    """Examine the parts that no record in ``out`` has, and renew the summary of all that do.

    Args:
        parts: all parts, those of other shards too.
        out: the directory; made if it is missing.
        settings: how each part is examined; the same in every run that writes in ``out``.
        execute: `run_local`, or `run_on_cluster`, with its arguments.
        shard: which parts are this run's.
        retry: whether parts are done again that crashed, or ran out of time or memory.
        counted: given how many parts this run has and how many of them are done, the context in
            which what it yields is told the name of each part that ends.

    Raises:
        InputError: ``out`` holds a run of other settings, or another run has this shard.
        OutputError: ``out`` can't be written.
    """
    header: Entry = {"schema": SCHEMA, "gpswb": gpswb.__version__, "settings": settings.plain()}
    try:
        out.mkdir(parents=True, exist_ok=True)
        with Record(out / shard.record, header) as record:
            known, _ = read_records(out, shard.record, header)
            mine = [part for part in parts if part in shard]
            waiting = [p for p in mine if not _done(p, known.get(p.name), out, retry)]
            del known
            with counted(len(mine), len(mine) - len(waiting)) as ended:
                _examine(waiting, out, shard, record, execute, ended)
            return summarise(parts, out, *read_records(out, shard.record, header))
    except OSError as error:
        raise OutputError(f"can't write {out}: {error.strerror or error}") from error


def _done(part: Part, known: Known | None, out: Path, retry: bool) -> bool:
    if known is None or (known.size, known.stamp) != (part.size, part.stamp):
        return False
    if known.status == "done":
        return (out / "parts" / part.name / "result.json").exists()
    return not (retry and known.status in RETRIED)


def _examine(
    parts: Iterable[Part],
    out: Path,
    shard: Shard,
    record: Record,
    execute: Execute,
    ended: Callable[[str], None],
) -> None:
    work = out / f".{shard.record}.work"
    shutil.rmtree(work, ignore_errors=True)  # of a run that was killed
    # The largest start first: none is left over at the end.
    ordered = sorted(parts, key=lambda part: -part.size)
    part_of = {part.name: part for part in ordered}
    jobs = (Job(part.url, part.name, work / str(i)) for i, part in enumerate(ordered))
    try:
        with closing(execute(jobs)) as ends:  # its processes end before their directories go
            for job, end in ends:
                part = part_of[job.name]
                columns = _publish(job, end, out / "parts" / part.name)
                record.append({**_entry(part, end), **columns})
                ended(part.name)
    finally:
        shutil.rmtree(work, ignore_errors=True)


def _entry(part: Part, end: End) -> Entry:
    return {
        "part": part.name,
        "stamp": part.stamp,
        "status": end.status,
        "message": end.message or None,
        "seconds": round(end.seconds, 3),
        "cpu_s": end.cpu_s,
        "memory_mb": end.memory_mb,
        "cached": end.cached,
        "bytes": part.size,
    }


def _publish(job: Job, end: End, place: Path) -> Entry:
    """Move a part's results into place; its columns. What an earlier run left there goes."""
    if end.status != "done":
        for name in RESULTS:
            (place / name).unlink(missing_ok=True)
        shutil.rmtree(job.directory)
        return {}
    columns = document_columns(json.loads((job.directory / "result.json").read_text("utf-8")))
    place.mkdir(parents=True, exist_ok=True)
    for name in RESULTS:
        with (job.directory / name).open("rb") as file:
            os.fsync(file.fileno())  # the record must not outlive them
        (job.directory / name).replace(place / name)
    shutil.rmtree(job.directory)
    return columns
