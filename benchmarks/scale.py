# SPDX-License-Identifier: LGPL-2.1-or-later
"""What parts cost by size, and what a million of the same mix would: the tables of docs/scale.md.

``gpswb batch DIR --out OUT --jobs 1 --no-cache``, then ``python benchmarks/scale.py OUT``.
"""

from __future__ import annotations

import sys
from pathlib import Path

import pandas as pd
from docs_section import renew
from meshes import ROOT

PAGE = ROOT / "docs" / "scale.md"
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
    """Renew the section of docs/scale.md."""
    out = Path(sys.argv[1])
    parts, rows = table(out)
    ends = ", ".join(f"{n} {status}" for status, n in parts["status"].value_counts().items())
    lines = [f"{len(parts)} parts: {ends}. Medians of those done, by triangles:", ""]
    lines.append("| triangles | " + " | ".join(rows.columns) + " |")
    lines.append("|---|" + "---:|" * len(rows.columns))
    for bounds, row in rows.iterrows():
        cells = [f"{value:,.0f}" if value >= 20 else f"{value:.2g}" for value in row]
        lines.append(f"| {bounds.left:,} to {bounds.right:,} | " + " | ".join(cells) + " |")
    # A part that met a limit has cost it: wall time stands in for the time that nobody saw.
    cost = parts["cpu_s"].fillna(parts["seconds"]).mean()
    done = parts.loc[parts["status"] == "done", "part"]
    kilobytes = sum(stored(out, part) for part in done) / len(parts) / 1e3
    lines += [
        "",
        f"In the mean {cost:.1f} CPU s and {kilobytes:.0f} kB a part. A million of the same mix:",
        f"**{cost * MILLION / 3600:,.0f} core hours, {kilobytes * MILLION / 1e9:,.2f} TB**.",
    ]
    renew(PAGE, "figures", lines)
    print("\n".join(lines))


if __name__ == "__main__":
    main()
