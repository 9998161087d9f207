# SPDX-License-Identifier: LGPL-2.1-or-later
"""What parts cost by size, and what a million of the same mix would: the tables of docs/scale.md.

``gpswb batch DIR --out OUT --jobs 1 --no-cache``, then ``python benchmarks/scale.py OUT``.
"""

from __future__ import annotations

import sys
from pathlib import Path

import pandas as pd

MILLION = 1_000_000
SIZES = (0, 2_000, 10_000, 30_000, 100_000, 10_000_000)
"""Bounds of the classes of parts, triangles."""


def stored(out: Path, part: str) -> int:
    """Bytes that a part's results take."""
    return sum(path.stat().st_size for path in (out / "parts" / part).glob("*.*") if path.is_file())


def table(out: Path) -> tuple[pd.DataFrame, pd.DataFrame]:
    """All parts, and a row a class of size with the medians of those that are done."""
    parts = pd.read_parquet(out / "summary.parquet")
    done = parts[parts["status"] == "done"].copy()
    done["kB"] = [stored(out, part) / 1e3 for part in done["part"]]
    done["class"] = pd.cut(done["triangles"], SIZES, right=False)
    of_class = done.groupby("class", observed=True)
    rows = of_class[["triangles", "faces", "cpu_s", "memory_mb", "kB"]].median()
    rows.insert(0, "parts", of_class.size())
    rows["cpu_s, most"] = of_class["cpu_s"].max()
    return parts, rows


def main() -> None:
    """Print the tables as Markdown."""
    out = Path(sys.argv[1])
    parts, rows = table(out)
    ends = ", ".join(f"{n} {status}" for status, n in parts["status"].value_counts().items())
    print(f"{len(parts)} parts: {ends}.\n")
    print("| triangles | " + " | ".join(rows.columns) + " |")
    print("|---" * (len(rows.columns) + 1) + "|")
    for bounds, row in rows.iterrows():
        cells = [f"{value:,.0f}" if value >= 20 else f"{value:.2g}" for value in row]
        print(f"| {bounds.left:,} to {bounds.right:,} | " + " | ".join(cells) + " |")
    # A part that met a limit has cost it: wall time stands in for the time that nobody saw.
    cost = parts["cpu_s"].fillna(parts["seconds"])
    done = parts[parts["status"] == "done"]
    kilobytes = sum(stored(out, part) for part in done["part"]) / len(parts) / 1e3
    print(
        f"\nMean {cost.mean():.1f} CPU s and {kilobytes:.0f} kB a part: for a million of the same "
        f"mix {cost.mean() * MILLION / 3600:,.0f} core hours and "
        f"{kilobytes * MILLION / 1e9:,.2f} TB."
    )


if __name__ == "__main__":
    main()
