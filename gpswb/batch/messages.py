# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors as one clear line."""

from __future__ import annotations

import traceback
from pathlib import Path

import gpswb

PACKAGE = Path(gpswb.__file__).parent


def one_line(text: str) -> str:
    """Text from files and file names on one line, without what a terminal would obey."""
    return " ".join("".join(c if c.isprintable() else " " for c in text).split())


def internal_error(error: Exception) -> str:
    """An error that is ours and not the input's: what it was and where."""
    frames = traceback.extract_tb(error.__traceback__)
    ours = [frame for frame in frames if Path(frame.filename).is_relative_to(PACKAGE)]
    at = (ours or frames)[-1]
    where = f"{Path(at.filename).name}:{at.lineno}"
    return one_line(f"internal error at {where}: {type(error).__name__}: {error}")
