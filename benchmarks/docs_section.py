# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures in a document, between two markers."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path


def renew(path: Path, name: str, lines: Sequence[str]) -> None:
    """Replace what stands between ``<!-- NAME: start -->`` and ``<!-- NAME: end -->``."""
    start, end = f"<!-- {name}: start -->", f"<!-- {name}: end -->"
    before, found, rest = path.read_text(encoding="utf-8").partition(start)
    if not found or end not in rest:
        raise SystemExit(f"{path} has no section {name}")
    text = "\n".join([start, "", *lines, "", end])
    path.write_text(before + text + rest.partition(end)[2], encoding="utf-8")
