# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user's table of tolerance values: JSON or CSV."""

from __future__ import annotations

import csv
import io
import json
import math
import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from gpswb.errors import InputError
from gpswb.gps.specified import SpecificationRow
from gpswb.io.csv_table import write_csv
from gpswb.sentence import Sentence

COLUMNS = ("feature", "characteristic", "value", "datums", "modifiers", "upper", "lower", "fit")
_NUMBERS = ("value", "upper", "lower")
_MODIFIERS = {"M": "Ⓜ", "L": "Ⓛ", "R": "Ⓡ", "Ⓜ": "Ⓜ", "Ⓛ": "Ⓛ", "Ⓡ": "Ⓡ"}
_FIT = re.compile(r"(?:[A-HJ-NPR-VX-Z]|CD|EF|FG|JS|Z[ABC])(?:01|1[0-8]|[0-9])", re.IGNORECASE)
_MOST_BYTES = 4_000_000


def read_specifications(path: Path) -> tuple[SpecificationRow, ...]:
    """Rows of a table: by suffix ``.json`` (a list of objects) or anything else as CSV.

    Columns or keys are `COLUMNS`, of which only the first two are needed; lengths in mm.

    Raises:
        InputError: the file can't be read, or says something that isn't in the table's form.
    """
    try:
        with path.open("rb") as file:
            data = file.read(_MOST_BYTES + 1)
    except OSError as error:
        raise InputError(f"{path}: can't be read ({error.strerror})") from None
    if len(data) > _MOST_BYTES:
        raise InputError(f"{path}: a table of specifications has at most {_MOST_BYTES} bytes")
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise InputError(f"{path}: not UTF-8") from None
    rows = _json(path, text) if path.suffix.lower() == ".json" else _csv(path, text)
    if not rows:
        raise InputError(f"{path}: there is no specification in it")
    return tuple(
        specification_row(f"{path}, specification {number}", row)
        for number, row in enumerate(rows, start=1)
    )


def write_specifications(path: Path, rows: Iterable[SpecificationRow]) -> None:
    """Write rows as a CSV table that `read_specifications` reads.

    Raises:
        OSError: the file can't be written.
    """
    write_csv(path, COLUMNS, map(_cells, rows))


def _cells(row: SpecificationRow) -> list[object]:
    words = {**vars(row), "modifiers": "".join(row.modifiers)}
    if row.value is None and row.characteristic != "size":
        words["value"] = "?"
    return [words[key] for key in COLUMNS]


def _json(path: Path, text: str) -> list[Mapping[str, Any]]:
    try:
        rows = json.loads(text)
    except (ValueError, RecursionError):
        raise InputError(f"{path}: not JSON") from None
    if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
        raise InputError(f"{path}: a list of objects is expected, one a specification")
    return rows


def _csv(path: Path, text: str) -> list[dict[str, Any]]:
    """Separated as the first line is; with semicolons a comma is a decimal comma."""
    head = text.partition("\n")[0]
    separator = max(",;\t", key=head.count)
    try:
        rows = list(csv.DictReader(io.StringIO(text), delimiter=separator, strict=True))
    except csv.Error as error:
        raise InputError(f"{path}: not CSV ({error})") from None
    for number, row in enumerate(rows, start=1):
        if None in row:
            raise InputError(f"{path}, specification {number}: more cells than the first line has")
        if separator == ";":
            row.update({key: row[key].replace(",", ".") for key in _NUMBERS if row.get(key)})
    return rows


def specification_row(where: str, row: Mapping[str, Any]) -> SpecificationRow:
    """One row, by the names of `COLUMNS`.

    Args:
        where: what an error says before the reason.

    Raises:
        InputError: it says something that isn't in the table's form.
    """
    unknown = [str(key) for key in row if key not in COLUMNS]
    if unknown:
        raise InputError(
            Sentence(
                "{where}: {word!r} is none of {known}",
                where=where,
                word=unknown[0],
                known=", ".join(COLUMNS),
            )
        )
    words = {key: _word(where, key, row.get(key)) for key in COLUMNS}
    if not words["feature"] or not words["characteristic"]:
        raise InputError(Sentence("{where}: feature and characteristic are needed", where=where))
    modifiers = [c for c in words["modifiers"].upper() if not c.isspace() and c not in ",()"]
    wrong = [c for c in modifiers if c not in _MODIFIERS]
    if wrong:
        raise InputError(
            Sentence("{where}: modifier {word!r} is none of M, L, R", where=where, word=wrong[0])
        )
    if words["fit"] and not _FIT.fullmatch(words["fit"]):
        raise InputError(
            Sentence(
                "{where}: {word!r} is no tolerance class as H7 or g6",
                where=where,
                word=words["fit"],
            )
        )
    return SpecificationRow(
        feature=words["feature"],
        characteristic=words["characteristic"].lower(),
        value=_number(where, "value", words["value"]),
        datums=words["datums"],
        modifiers=tuple(_MODIFIERS[c] for c in modifiers),
        upper=_number(where, "upper", words["upper"]),
        lower=_number(where, "lower", words["lower"]),
        fit=words["fit"],
    )


def _word(where: str, key: str, value: Any) -> str:
    if value is None:
        return ""
    if isinstance(value, bool) or not isinstance(value, str | int | float):
        raise InputError(
            Sentence("{where}: {key} is neither text nor a number", where=where, key=Sentence(key))
        )
    return str(value).strip()


def _number(where: str, key: str, text: str) -> float | None:
    """A finite number, None for nothing and for ``?``: what isn't known isn't invented."""
    if text in ("", "?"):
        return None
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise InputError(
            Sentence(
                "{where}: {key} {text!r} is not a number", where=where, key=Sentence(key), text=text
            )
        )
    return number
