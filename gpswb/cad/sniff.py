# SPDX-License-Identifier: LGPL-2.1-or-later
"""A first look at an input file, before a kernel (native code) touches it."""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import Literal

from gpswb.errors import InputError

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
        raise InputError(f"{path}: no such file")
    if path.is_dir():
        raise InputError(f"{path}: is a directory, not a file")
    try:
        data = path.read_bytes()
    except OSError as error:
        raise InputError(f"{path}: can't be read ({error.strerror})") from None
    if not data.strip():
        raise InputError(f"{path}: the file is empty")
    return _format(path, data), hashlib.sha256(data).hexdigest()


def _format(path: Path, data: bytes) -> Format:
    expected = _SUFFIXES.get(path.suffix.lower())
    if expected is None:
        raise InputError(
            f"{path}: unknown format {path.suffix!r}; expected {', '.join(sorted(_SUFFIXES))}"
        )
    head = data[:65536].upper()
    if b"ISO-10303-21" in head:
        # The last lines are looked at only: a truncated file is read in part without an error.
        if b"END-ISO-10303-21" not in data[-4096:].upper():
            raise InputError(f"{path}: the STEP file is truncated (END-ISO-10303-21 is missing)")
        return "step"
    if expected == "step":
        raise InputError(f"{path}: not a STEP file (ISO-10303-21 is missing)")
    if expected == "fcstd":
        if data[:2] != b"PK":
            raise InputError(f"{path}: not an FCStd document (no zip archive)")
        return "fcstd"
    if b"CASCADE TOPOLOGY" not in head and not head.startswith(b"OPEN CASCADE"):
        raise InputError(f"{path}: not an OCCT BREP file")
    return "brep"
