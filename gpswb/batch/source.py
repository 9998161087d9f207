# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where parts lie: local directories, and through fsspec whatever has a URL.

A URL is as fsspec reads it: ``s3://bucket/parts``, ``memory://parts``, ``zip://::parts.zip``.
"""

from __future__ import annotations

import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any

from gpswb.errors import InputError

CAD = (".step", ".stp", ".p21", ".brep", ".brp", ".rle", ".fcstd")
"""Endings, in lower case, of the CAD files that are taken from a directory."""

STAMPS = ("ETag", "etag", "md5Hash", "content_md5", "CRC", "mtime", "LastModified", "last_modified")
"""What the file systems of fsspec call the things that change when a file does."""

CHUNK = 2**20
"""Bytes that are fetched at once."""


@dataclass(frozen=True, slots=True)
class Part:
    """A file to examine.

    Args:
        name: relative to where it was looked for, with ``/``; no two are alike, and none leads out
            of a directory.
        url: local path or URL.
        size: bytes.
        stamp: changes when the file does, as far as its file system tells.
    """

    name: str
    url: str
    size: int
    stamp: str


def find_parts(where: str, suffixes: Sequence[str]) -> list[Part]:
    """The files with one of the endings in a directory or at a URL, sorted by name; maybe none.

    Raises:
        InputError: there is no such place, or it can't be read.
    """
    found = _find_at_url(where, suffixes) if is_url(where) else _find_local(where, suffixes)
    taken: set[str] = set()
    parts = []
    for name, url, size, stamp in sorted(found):
        unique = unique_name(_inside(name), taken)
        parts.append(Part(unique, url, size, stamp))
    return parts


def unique_name(name: str, taken: set[str]) -> str:
    """``name``, with a number where it is ``taken`` (case aside: some file systems ignore it)."""
    stem, n = name, 2
    while name.lower() in taken:
        name, n = f"{stem} ({n})", n + 1
    taken.add(name.lower())
    return name


def is_url(where: str) -> bool:
    """Whether fsspec is asked; a file or directory that is there is a path, whatever its name."""
    return ("://" in where or "::" in where) and not Path(where).exists()


def printable(name: str) -> str:
    """A file name that isn't UTF-8 as one that is: its odd bytes are written out."""
    return name.encode("utf-8", "surrogateescape").decode("utf-8", "backslashreplace")


@contextmanager
def local_file(url: str, most: int) -> Iterator[Path]:
    """Yield the path of a local file, or of a copy of at most ``most`` bytes of a remote one.

    Raises:
        InputError: it can't be fetched, or is larger.
    """
    if not is_url(url):
        yield Path(url)
        return
    with tempfile.TemporaryDirectory(prefix="gpswb-") as scratch:
        path = Path(scratch) / f"part{PurePosixPath(url.partition('::')[0]).suffix}"
        try:
            _fetch(url, path, most)
        except InputError:
            raise
        except Exception as error:  # each driver raises what it likes
            raise InputError(f"can't fetch it: {type(error).__name__}: {error}") from error
        yield path


def _fetch(url: str, path: Path, most: int) -> None:
    from fsspec.core import url_to_fs

    files, inside = url_to_fs(url)
    left = most
    with files.open(inside, "rb") as source, path.open("wb") as copy:
        while chunk := source.read(CHUNK):
            left -= len(chunk)
            if left < 0:
                raise InputError(f"larger than the memory that it may take, {most / 1e9:g} GB")
            copy.write(chunk)


Found = tuple[str, str, int, str]
"""Name, URL, size and stamp."""


def _find_local(where: str, suffixes: Sequence[str]) -> list[Found]:
    root = Path(where)
    if not root.exists():
        raise InputError(f"{where}: no such file or directory")
    try:
        paths = root.rglob("*") if root.is_dir() else [root]
        found = []
        for path in paths:
            if path.suffix.lower() in suffixes and path.is_file():
                state = path.stat()
                name = path.relative_to(root).as_posix() if path != root else path.name
                found.append((name, str(path), state.st_size, f"mtime={state.st_mtime}"))
        return found
    except OSError as error:
        raise InputError(f"can't read {where}: {error.strerror or error}") from error


def _find_at_url(where: str, suffixes: Sequence[str]) -> list[Found]:
    try:
        from fsspec.core import url_to_fs
    except ImportError:
        raise InputError(f"{where}: no such path, and URLs need the package fsspec") from None
    first, chained, rest = where.partition("::")
    protocol = first.partition("://")[0]
    try:
        files, root = url_to_fs(where)
        found: Mapping[str, Mapping[str, Any]] = files.find(root, detail=True)
    except Exception as error:  # each driver raises what it likes
        raise InputError(f"can't read {where}: {type(error).__name__}: {error}") from error
    start = root.strip("/")
    return [
        (
            path.strip("/").removeprefix(start).strip("/") or PurePosixPath(path).name,
            f"{protocol}://{path.lstrip('/')}{chained}{rest}" if chained
            else files.unstrip_protocol(path),
            int(info.get("size") or 0),
            " ".join(f"{key}={info[key]}" for key in STAMPS if info.get(key) is not None),
        )
        for path, info in found.items()
        if PurePosixPath(path).suffix.lower() in suffixes
    ]  # fmt: skip


def _inside(name: str) -> str:
    """A name whose pieces lead nowhere else: ``..`` and ``.`` of a hostile archive are escaped."""
    pieces = (piece.replace("\0", "%00") for piece in printable(name).split("/") if piece)
    return "/".join(p.replace(".", "%2E") if p in (".", "..") else p for p in pieces)
