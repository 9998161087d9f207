# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many parts into one directory, by one run or by several that go on where others were ended.

``record.jsonl`` says which parts are done, ``parts/NAME`` holds what they gave. A part's results
are moved into place before the record names it: a run that is killed at any moment loses no part
that is in the record, and the next one does no such part again.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import gpswb
from gpswb.batch.columns import document_columns
from gpswb.batch.job import RESULTS, End, Job
from gpswb.batch.record import Entry, Record, decode, read_record
from gpswb.batch.settings import Settings
from gpswb.batch.source import Part
from gpswb.batch.summary import write_summary
from gpswb.errors import OutputError

SCHEMA = "gpswb-record/1"

RETRIED = ("crashed", "timeout", "memory")
"""Ends that another try, with other limits or on another machine, may turn into a result."""

NAMED = 20
"""Parts without a result that a summary names; its table has all of them."""

Execute = Callable[[Iterable[Job]], Iterator[tuple[Job, End]]]
"""Examines jobs: yields each with its end, its results in its directory."""

Counted = Callable[[int, int], AbstractContextManager[Callable[[str], None]]]


@dataclass(frozen=True)
class Shard:
    """The parts of one of ``count`` runs that share the work, ``number`` from 1 to ``count``."""

    number: int = 1
    count: int = 1

    def __contains__(self, part: Part) -> bool:
        # By name, so that a part keeps its shard whatever else is added.
        digest = hashlib.sha256(part.name.encode("utf-8", "surrogateescape")).digest()
        return int.from_bytes(digest[:8]) % self.count == self.number - 1

    @property
    def record(self) -> str:
        """File name of its record."""
        if self.count == 1:
            return "record.jsonl"
        return f"record-{self.number}-of-{self.count}.jsonl"


@dataclass(frozen=True)
class Summary:
    """What a run leaves.

    Args:
        ends: how many parts ended how.
        lacking: the first entries of parts without a result.
        files: names of the table's files.
        damaged: lines of records that were found damaged.
    """

    ends: Counter[str]
    lacking: list[Entry]
    files: list[str]
    damaged: int


class _Known(NamedTuple):
    """What is kept in memory of a part's last entry: there may be millions."""

    record: Path
    offset: int
    status: str
    size: int
    stamp: str


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
            known, _ = _read_all(out, shard, header)
            mine = [part for part in parts if part in shard]
            waiting = [p for p in mine if not _done(p, known.get(p.name), out, retry)]
            del known
            with counted(len(mine), len(mine) - len(waiting)) as ended:
                _examine(waiting, out, shard, record, execute, ended)
            return _summarise(parts, out, *_read_all(out, shard, header))
    except OSError as error:
        raise OutputError(f"can't write {out}: {error.strerror or error}") from error


def _read_all(out: Path, shard: Shard, header: Entry) -> tuple[dict[str, _Known], int]:
    """The last entry of each part in any record, this shard's last; and damaged lines."""
    known: dict[str, _Known] = {}
    damaged = 0
    paths = sorted(out.glob("record*.jsonl"), key=lambda path: (path.name == shard.record, path))
    for path in paths:
        for offset, entry in read_record(path, header):
            if entry is None:
                damaged += 1
            else:
                said = (entry["status"], entry["bytes"], entry["stamp"])
                known[entry["part"]] = _Known(path, offset, *said)
    return known, damaged


def _done(part: Part, known: _Known | None, out: Path, retry: bool) -> bool:
    if known is None or (known.size, known.stamp) != (part.size, part.stamp):
        return False
    if known.status == "done":
        return (out / "parts" / part.name / "result.json").exists()
    return not (retry and known.status in RETRIED)


def _summarise(
    parts: Sequence[Part], out: Path, known: Mapping[str, _Known], damaged: int
) -> Summary:
    ends: Counter[str] = Counter()
    lacking: list[Entry] = []

    def rows() -> Iterator[Entry]:
        with ExitStack() as stack:
            paths = {one.record for one in known.values()}
            files = {path: stack.enter_context(path.open("rb")) for path in paths}
            for part in parts:
                if not (one := known.get(part.name)):
                    continue
                files[one.record].seek(one.offset)
                entry = decode(files[one.record].readline())
                assert entry is not None
                ends[one.status] += 1
                if one.status != "done" and len(lacking) < NAMED:
                    lacking.append(entry)
                yield entry

    return Summary(ends, lacking, write_summary(out, rows()), damaged)


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
        for job, end in execute(jobs):
            part = part_of[job.name]
            columns = _publish(job, end, out / "parts" / part.name)
            record.append(
                {
                    "part": part.name,
                    "stamp": part.stamp,
                    "status": end.status,
                    "message": end.message or None,
                    "seconds": round(end.seconds, 3),
                    "cpu_s": end.cpu_s,
                    "memory_mb": end.memory_mb,
                    "cached": end.cached,
                    "bytes": part.size,
                    **columns,
                }
            )
            ended(part.name)
    finally:
        shutil.rmtree(work, ignore_errors=True)


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
