# SPDX-License-Identifier: LGPL-2.1-or-later
"""The record survives torn and damaged lines, and belongs to one run at a time."""

from pathlib import Path

import pytest

from gpswb.batch.record import Record, decode, encode, read_record
from gpswb.errors import InputError

HEADER = {"schema": "test/1", "settings": {"a": 1}}
ENTRIES = [{"part": f"p{i} ü\n", "x": i / 3} for i in range(5)]


def entries(path: Path, header: dict = HEADER) -> list[dict | None]:
    return [entry for _, entry in read_record(path, header)]


@pytest.fixture
def path(tmp_path: Path) -> Path:
    path = tmp_path / "record.jsonl"
    with Record(path, HEADER) as record:
        for entry in ENTRIES:
            record.append(entry)
    return path


def test_what_was_appended_is_read_again(path: Path) -> None:
    assert entries(path) == ENTRIES
    with path.open("rb") as file:
        for offset, entry in read_record(path, HEADER):
            file.seek(offset)
            assert decode(file.readline()) == entry


def test_a_line_torn_anywhere_is_dropped_and_what_follows_is_kept(path: Path) -> None:
    whole = path.read_bytes()
    last = len(whole) - len(encode(ENTRIES[-1]))
    for cut in range(last, len(whole)):
        path.write_bytes(whole[:cut])
        with Record(path, HEADER) as record:
            assert entries(path) == ENTRIES[:-1]
            record.append(ENTRIES[-1])
        assert path.read_bytes() == whole


def test_every_damaged_byte_is_noticed() -> None:
    line = encode(ENTRIES[1])
    assert decode(line) == ENTRIES[1]
    for i in range(len(line)):
        damaged = bytearray(line)
        damaged[i] ^= 1
        assert decode(bytes(damaged)) is None


def test_a_damaged_line_costs_its_part_only(path: Path) -> None:
    lines = path.read_bytes().splitlines(keepends=True)
    lines[2] = lines[2].replace(b"p1", b"p7")
    path.write_bytes(b"".join(lines))
    assert entries(path) == [ENTRIES[0], None, *ENTRIES[2:]]


def test_a_lost_header_is_written_again(path: Path) -> None:
    path.write_bytes(path.read_bytes()[3:])
    with Record(path, HEADER):
        pass
    with pytest.raises(InputError, match="other settings"):
        entries(path, {**HEADER, "settings": {"a": 2}})


def test_two_runs_do_not_share_a_record(path: Path) -> None:
    with Record(path, HEADER), pytest.raises(InputError, match="another run"):
        Record(path, HEADER)
    with Record(path, HEADER):
        assert entries(path) == ENTRIES
