# SPDX-License-Identifier: LGPL-2.1-or-later
"""The records of an output directory together: one a shard, and the table of them all."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from gpswb.batch.record import Entry, decode, read_record
from gpswb.batch.source import Part
from gpswb.batch.summary import write_summary

NAMED = 20
"""Parts without a result that a summary names; its table has all of them."""


class Known(NamedTuple):
    """What is kept in memory of a part's last entry: there may be millions."""

    record: Path
    offset: int
    status: str
    size: int
    stamp: str


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


def read_records(out: Path, last: str, header: Entry) -> tuple[dict[str, Known], int]:
    """The last entry of each part by name, and how many lines are damaged.

    Args:
        out: the directory.
        last: file name of the record that is read last, so that it prevails.
        header: what every record must begin with.

    Raises:
        InputError: a record belongs to a run of other settings.
        OSError: one can't be read.
    """
    known: dict[str, Known] = {}
    damaged = 0
    paths = sorted(out.glob("record*.jsonl"), key=lambda path: (path.name == last, path))
    for path in paths:
        for offset, entry in read_record(path, header):
            if entry is None:
                damaged += 1
            else:
                said = (entry["status"], entry["bytes"], entry["stamp"])
                known[entry["part"]] = Known(path, offset, *said)
    return known, damaged


def summarise(
    parts: Sequence[Part], out: Path, known: Mapping[str, Known], damaged: int
) -> Summary:
    """Write the table of the parts that are known, in their order, and count their ends.

    Raises:
        OSError: it can't be written.
    """
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
