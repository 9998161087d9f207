# SPDX-License-Identifier: LGPL-2.1-or-later
"""summary.csv and summary.parquet: the record as a table, a row a part."""

from __future__ import annotations

import itertools
import tempfile
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from gpswb.batch.columns import COLUMNS
from gpswb.io.csv_table import CsvTable

CHUNK = 10_000
"""Rows that are in memory at once: there may be millions."""


def write_summary(directory: Path, rows: Iterable[Mapping[str, Any]]) -> list[str]:
    """Write the table, each file whole or not at all; the names of the files.

    Parquet needs pyarrow; without it there is the CSV alone.

    Raises:
        OSError: a file can't be written.
    """
    with tempfile.TemporaryDirectory(prefix=".summary.", dir=directory) as scratch:
        draft = Path(scratch)
        with (draft / "summary.csv").open("w", newline="", encoding="utf-8") as file:
            parquet = _parquet(draft / "summary.parquet")
            table = CsvTable(file, COLUMNS)
            waiting = iter(rows)
            while chunk := list(itertools.islice(waiting, CHUNK)):
                for row in chunk:
                    table.write(row.get(key) for key in COLUMNS)
                if parquet:
                    parquet.write_batch(_batch(chunk, parquet.schema))
            if parquet:
                parquet.close()
        names = ["summary.parquet", "summary.csv"] if parquet else ["summary.csv"]
        for name in names:
            (draft / name).replace(directory / name)
    return names


def _parquet(path: Path) -> Any:
    """A writer of the table, None without pyarrow."""
    try:
        import pyarrow as pa
        import pyarrow.parquet as pq
    except ImportError:
        return None
    kinds = {str: pa.string(), float: pa.float64(), int: pa.int64(), bool: pa.bool_()}
    return pq.ParquetWriter(path, pa.schema([(name, kinds[k]) for name, k in COLUMNS.items()]))


def _batch(rows: list[Mapping[str, Any]], schema: Any) -> Any:
    import pyarrow as pa

    return pa.RecordBatch.from_pylist(rows, schema)
