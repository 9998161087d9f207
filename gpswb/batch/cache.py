# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results by what they were made from: an unchanged part is not examined again.

An entry is one file, named by the hash of the input's bytes, the settings and whatever of gpswb and
its libraries decides. It appears whole (renamed into place), so that several runs may share a
cache, and begins with a checksum of the rest, so that a damaged one counts as absent. It is a zip
archive: nothing in it is run.
"""

from __future__ import annotations

import contextlib
import fcntl
import hashlib
import io
import json
import os
import tempfile
import threading
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from gpswb.batch.fingerprint import fingerprint

MOST = 2 * 10**9
"""Bytes that a cache may hold; then those entries go that were not used for the longest time."""

KEPT = 0.8
"""Share of `MOST` that is kept when entries go, so that they don't go one by one."""

SLACK = MOST // 16
"""Bytes that one process may add before it looks at the size of the cache again."""

CHECKSUM = 32
"""Bytes of the SHA-256 that an entry begins with."""


class Cache:
    """A directory of results.

    Args:
        directory: made when the first entry is put.
        most: bytes that it may hold.
    """

    def __init__(self, directory: Path, most: int = MOST) -> None:
        self.directory, self.most = directory, most
        self._unseen: float = SLACK  # look at the size when the first entry is put
        self._lock = threading.Lock()

    @classmethod
    def of_user(cls) -> Cache:
        """The user's: ``gpswb`` in ``$XDG_CACHE_HOME``, or in ``~/.cache``."""
        place = Path(os.environ.get("XDG_CACHE_HOME", ""))
        if not place.is_absolute():  # to be ignored, says the XDG specification
            place = Path.home() / ".cache"
        return cls(place / "gpswb")

    @staticmethod
    def key(path: Path, kernel: str, what: Mapping[str, Any]) -> str:
        """The name of an entry.

        Args:
            path: the input; its bytes count, not its name, but for the ending that says its format.
            kernel: whose version counts.
            what: everything else that the result depends on, as JSON can hold it.

        Raises:
            OSError: the input can't be read.
        """
        with path.open("rb") as file:
            content = hashlib.file_digest(file, "sha256").hexdigest()
        made_from = [content, path.suffix.lower(), fingerprint(kernel), what]
        return hashlib.sha256(json.dumps(made_from, sort_keys=True).encode()).hexdigest()

    def get(self, key: str) -> dict[str, bytes] | None:
        """The files of an entry by name; None where there is none, or a damaged one."""
        path = self._path(key)
        try:
            data = path.read_bytes()
            if hashlib.sha256(data[CHECKSUM:]).digest() != data[:CHECKSUM]:
                path.unlink(missing_ok=True)
                return None
            with zipfile.ZipFile(io.BytesIO(data[CHECKSUM:])) as archive:
                files = {name: archive.read(name) for name in archive.namelist()}
            os.utime(path)
        except (OSError, zipfile.BadZipFile):
            return None
        return files

    def put(self, key: str, files: Mapping[str, bytes]) -> None:
        """Keep the files. A cache that can't be written is no reason to fail: then it isn't."""
        packed = io.BytesIO()
        with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive:
            for name, content in files.items():
                archive.writestr(name, content)
        data = packed.getvalue()
        path = self._path(key)
        with contextlib.suppress(OSError):
            path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
            with tempfile.NamedTemporaryFile(dir=path.parent, delete=False) as file:
                file.write(hashlib.sha256(data).digest() + data)
            Path(file.name).replace(path)
            self._trim(len(data))

    def usage(self) -> tuple[int, int]:
        """How many entries, and how many bytes in all."""
        sizes = [state.st_size for _, state in self._entries()]
        return len(sizes), sum(sizes)

    def clear(self) -> tuple[int, int]:
        """Remove every entry; how many, and how many bytes, there were.

        Raises:
            OSError: an entry can't be removed.
        """
        entries = self._entries()
        for path, _ in entries:
            path.unlink(missing_ok=True)
        return len(entries), sum(state.st_size for _, state in entries)

    def _path(self, key: str) -> Path:
        return self.directory / key[:2] / key[2:]

    def _entries(self) -> list[tuple[Path, os.stat_result]]:
        """Every file of ours, those that a killed run left half-written too."""
        found = []
        for path in self.directory.glob("[0-9a-f][0-9a-f]/*"):
            with contextlib.suppress(FileNotFoundError):
                found.append((path, path.stat()))
        return found

    def _trim(self, added: int) -> None:
        with self._lock:
            self._unseen += added
            if self._unseen < SLACK:
                return
            self._unseen = 0
        with (self.directory / "lock").open("w") as lock:
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                return  # another run is at it
            entries = sorted(self._entries(), key=lambda entry: entry[1].st_mtime)
            size = sum(state.st_size for _, state in entries)
            if size <= self.most:
                return
            for path, state in entries:
                if size <= KEPT * self.most:
                    return
                path.unlink(missing_ok=True)
                size -= state.st_size
