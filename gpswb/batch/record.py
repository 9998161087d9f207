# SPDX-License-Identifier: LGPL-2.1-or-later
"""What has been done, a line a part, in a file that only grows.

A line is a checksum, a space and JSON: ``<16 hex digits of the JSON's SHA-256> {...}``. A line that
a crash tore, or a disk damaged, doesn't match its checksum and counts as not written: its part is
done again. A line is on disk before the next part's is begun.
"""

from __future__ import annotations

import fcntl
import hashlib
import json
import os
from collections.abc import Iterator
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from gpswb.errors import InputError, OutputError

Entry = dict[str, Any]

DIGITS = 16
"""Hex digits of the checksum: 64 bits."""


def encode(entry: Entry) -> bytes:
    """One entry as a line."""
    payload = json.dumps(entry, allow_nan=False, separators=(",", ":")).encode()
    return _checksum(payload) + b" " + payload + b"\n"


def decode(line: bytes) -> Entry | None:
    """The entry of a line; None where it is damaged or torn."""
    checksum, _, payload = line.rstrip(b"\n").partition(b" ")
    if not line.endswith(b"\n") or checksum != _checksum(payload):
        return None
    entry = json.loads(payload)
    return entry if isinstance(entry, dict) else None


def read_record(path: Path, header: Entry) -> Iterator[tuple[int, Entry | None]]:
    """Yield the offset of each line, and its entry, or None where it is damaged.

    A last line without its end is none yet: another run may be writing it.

    Raises:
        InputError: the record belongs to a run of other settings.
        OSError: it can't be read.
    """
    offset = 0
    with path.open("rb") as file:
        for line in file:
            if not line.endswith(b"\n"):
                return
            entry = decode(line)
            if entry is None or "schema" not in entry:
                yield offset, entry
            elif entry != header:
                raise InputError(
                    f"{path} belongs to a run of other settings or of another version; "
                    "choose another directory, or the same settings"
                )
            offset += len(line)


class Record:
    """A record open for appending; one run at a time has it.

    Args:
        path: the file; made if it is missing.
        header: what must be the same in every run that goes on with it; its first line.

    Raises:
        InputError: another run has it open.
        OutputError: it can't be written.
    """

    def __init__(self, path: Path, header: Entry) -> None:
        try:
            self._file = os.open(path, os.O_RDWR | os.O_CREAT | os.O_APPEND, 0o666)
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            os.close(self._file)
            raise InputError(f"{path}: another run is writing it") from None
        except OSError as error:
            raise OutputError(f"can't write {path}: {error.strerror or error}") from error
        try:
            self._drop_torn_tail(path)
            with path.open("rb") as file:
                first = decode(file.readline())
            if first is None or "schema" not in first:
                self._write(header)
        except BaseException:
            os.close(self._file)
            raise

    def append(self, entry: Entry) -> None:
        """Add an entry, on disk when this returns.

        Raises:
            OSError: it can't be written.
        """
        self._write(entry)

    def _write(self, entry: Entry) -> None:
        line = encode(entry)
        written = os.write(self._file, line)
        if written != len(line):  # a full disk: the torn line is dropped by the next run
            raise OSError(28, "No space left on device")
        os.fsync(self._file)

    def _drop_torn_tail(self, path: Path) -> None:
        """Cut a last line without its end: what is appended to it would be lost as well."""
        end = 0
        with path.open("rb") as file:
            for line in file:
                end += len(line) if line.endswith(b"\n") else 0
        os.ftruncate(self._file, end)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        os.close(self._file)


def _checksum(payload: bytes) -> bytes:
    return hashlib.sha256(payload).hexdigest()[:DIGITS].encode()
