# SPDX-License-Identifier: LGPL-2.1-or-later
"""summary.csv and summary.parquet: the record as a table, a row a part."""

from __future__ import annotations

import csv
import tempfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from gpswb.batch.columns import COLUMNS


def write_summary(directory: Path, rows: Sequence[Mapping[str, Any]]) -> list[str]:
    """Write the table, each file whole or not at all; the names of the files.

    Parquet needs pyarrow; without it there is the CSV alone.

    Raises:
        OSError: a file can't be written.
    """
    _replace(directory / "summary.csv", lambda draft: _write_csv(draft, rows))
    try:
        import pyarrow as pa
        import pyarrow.parquet as pq
    except ImportError:
        return ["summary.csv"]
    kinds = {str: pa.string(), float: pa.float64(), int: pa.int64(), bool: pa.bool_()}
    schema = pa.schema([(name, kinds[kind]) for name, kind in COLUMNS.items()])
    table = pa.Table.from_pylist(list(rows), schema)
    _replace(directory / "summary.parquet", lambda draft: pq.write_table(table, draft))
    return ["summary.parquet", "summary.csv"]


def _replace(path: Path, write: Callable[[Path], None]) -> None:
    with tempfile.TemporaryDirectory(prefix=f".{path.name}.", dir=path.parent) as scratch:
        draft = Path(scratch) / path.name
        write(draft)
        draft.replace(path)


def _write_csv(path: Path, rows: Sequence[Mapping[str, Any]]) -> None:
    with path.open("w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(COLUMNS)
        for row in rows:
            table.writerow("" if (value := row.get(key)) is None else value for key in COLUMNS)
