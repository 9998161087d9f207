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

_RUNS = re.compile(r"['\\]|(?:(?![ -~])[\u0000-\uFFFF])+|[\U00010000-\U0010FFFF]+")
"""What can't stand as it is: the two special characters, and runs outside printable ASCII."""


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
    return "'" + _RUNS.sub(_encoded, text) + "'"


def _encoded(match: re.Match[str]) -> str:
    run = match[0]
    if run in ("'", "\\"):
        return run * 2
    if ord(run[0]) <= 0xFFFF:
        return f"\\X2\\{run.encode('utf-16-be').hex().upper()}\\X0\\"
    return f"\\X4\\{run.encode('utf-32-be').hex().upper()}\\X0\\"
