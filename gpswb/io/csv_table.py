# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables as CSV, in which no text is a formula to the spreadsheet that opens it."""

from __future__ import annotations

import csv
from collections.abc import Iterable
from pathlib import Path
from typing import TextIO

_FORMULA = ("=", "+", "-", "@", "\t", "\r")
"""What a cell begins with that a spreadsheet evaluates."""


class CsvTable:
    """Writes rows into a file that was opened with ``newline=""``."""

    def __init__(self, file: TextIO, header: Iterable[str]) -> None:
        self._table = csv.writer(file, lineterminator="\n")
        self._table.writerow(header)

    def write(self, row: Iterable[object]) -> None:
        """Add a row; None is an empty cell."""
        self._table.writerow([_cell(value) for value in row])


def write_csv(path: Path, header: Iterable[str], rows: Iterable[Iterable[object]]) -> None:
    """Write a table.

    Raises:
        OSError: the file can't be written.
    """
    with path.open("w", newline="", encoding="utf-8") as file:
        table = CsvTable(file, header)
        for row in rows:
            table.write(row)


def _cell(value: object) -> object:
    """The value, with an apostrophe before text that would be a formula; a number is none."""
    if value is None:
        return ""
    if isinstance(value, str) and value.startswith(_FORMULA) and not _is_number(value):
        return f"'{value}"
    return value


def _is_number(text: str) -> bool:
    """Whether a cell is a number, or several as of a point."""
    try:
        for word in text.split():
            float(word)
    except ValueError:
        return False
    return True
