# SPDX-License-Identifier: LGPL-2.1-or-later
"""A first look at an input file, before a kernel (native code) touches it."""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import Literal

from gpswb.errors import InputError
from gpswb.sentence import Sentence

Format = Literal["step", "brep", "fcstd"]

_SUFFIXES: dict[str, Format] = {
    ".step": "step", ".stp": "step", ".p21": "step",
    ".brep": "brep", ".brp": "brep", ".rle": "brep",
    ".fcstd": "fcstd",
}  # fmt: skip


def sniff(path: Path) -> tuple[Format, str]:
    """The format of a CAD file, by suffix and content, and the SHA-256 of its bytes.

    Raises:
        InputError: the file is missing, unreadable, empty, truncated or of another format.
    """
    if not path.exists():
        raise InputError(Sentence("{path}: no such file", path=path))
    if path.is_dir():
        raise InputError(Sentence("{path}: is a directory, not a file", path=path))
    try:
        data = path.read_bytes()
    except OSError as error:
        raise InputError(
            Sentence("{path}: can't be read ({reason})", path=path, reason=error.strerror)
        ) from None
    if not data.strip():
        raise InputError(Sentence("{path}: the file is empty", path=path))
    return _format(path, data), hashlib.sha256(data).hexdigest()


def _format(path: Path, data: bytes) -> Format:
    expected = _SUFFIXES.get(path.suffix.lower())
    if expected is None:
        raise InputError(
            Sentence(
                "{path}: unknown format {suffix!r}; expected {known}",
                path=path,
                suffix=path.suffix,
                known=", ".join(sorted(_SUFFIXES)),
            )
        )
    head = data[:65536].upper()
    if b"ISO-10303-21" in head:
        # The last lines are looked at only: a truncated file is read in part without an error.
        if b"END-ISO-10303-21" not in data[-4096:].upper():
            raise InputError(
                Sentence(
                    "{path}: the STEP file is truncated (END-ISO-10303-21 is missing)", path=path
                )
            )
        return "step"
    if expected == "step":
        raise InputError(Sentence("{path}: not a STEP file (ISO-10303-21 is missing)", path=path))
    if expected == "fcstd":
        if data[:2] != b"PK":
            raise InputError(Sentence("{path}: not an FCStd document (no zip archive)", path=path))
        return "fcstd"
    if b"CASCADE TOPOLOGY" not in head and not head.startswith(b"OPEN CASCADE"):
        raise InputError(Sentence("{path}: not an OCCT BREP file", path=path))
    return "brep"
