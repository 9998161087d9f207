# SPDX-License-Identifier: LGPL-2.1-or-later
"""Strings of a Part 21 file (ISO 10303-21, 6.4.3)."""

from __future__ import annotations

import re

_DIRECTIVE = re.compile(
    r"''|\\\\"
    r"|\\X2\\((?:[0-9A-Fa-f]{4})*)\\X0\\"
    r"|\\X4\\((?:[0-9A-Fa-f]{8})*)\\X0\\"
    r"|\\X\\([0-9A-Fa-f]{2})"
    r"|\\S\\(.)"
    r"|\\P[A-I]\\"
)


def decode(literal: str) -> str:
    """Text of what stands between the apostrophes; a directive that is malformed stays as it is.

    Pages of ISO 8859 other than the first are read as the first.
    """
    return _DIRECTIVE.sub(_decoded, literal)


def _decoded(match: re.Match[str]) -> str:
    whole = match[0]
    if whole in ("''", "\\\\"):
        return whole[0]
    if match[1] is not None:
        pairs = bytes.fromhex(match[1])
        return pairs.decode("utf-16-be", "replace")
    if match[2] is not None:
        return bytes.fromhex(match[2]).decode("utf-32-be", "replace")
    if match[3] is not None:
        return chr(int(match[3], 16))
    if match[4] is not None:
        return chr((ord(match[4]) + 128) % 256)
    return ""


def encode(text: str) -> str:
    """A literal with its apostrophes, in printable ASCII only."""
    out = []
    for c in text:
        if c in "'\\":
            out.append(c * 2)
        elif " " <= c <= "~":
            out.append(c)
        elif ord(c) <= 0xFFFF:
            out.append(f"\\X2\\{ord(c):04X}\\X0\\")
        else:
            out.append(f"\\X4\\{ord(c):08X}\\X0\\")
    return "'" + "".join(out).replace("\\X0\\\\X2\\", "") + "'"
