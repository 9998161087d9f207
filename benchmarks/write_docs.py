# SPDX-License-Identifier: LGPL-2.1-or-later
"""Renew docs/performance.md from the newest run of ``./gps bench``: ``python
benchmarks/write_docs.py``."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs" / "performance.md"
START, END = "<!-- figures: start -->", "<!-- figures: end -->"
PART_OF = {"likelihood": "recognition"}
"""Rows that are a part of another row, and so don't count in the sum."""


def newest() -> dict[str, Any]:
    """The last run that was saved.

    Raises:
        SystemExit: there is none.
    """
    saved = sorted((ROOT / "build" / "benchmarks").rglob("*_stages.json"))
    if not saved:
        raise SystemExit("write_docs: no run in build/benchmarks; run ./gps bench first")
    found: dict[str, Any] = json.loads(saved[-1].read_text(encoding="utf-8"))
    return found


def tables(run: dict[str, Any]) -> list[str]:
    """Markdown: a row a stage and a row a mode, a column a density, CPU seconds."""
    columns: dict[int, dict[str, Any]] = {}
    for bench in run["benchmarks"]:
        info = bench["extra_info"]
        column = columns.setdefault(info["asked"], {"info": info, "stage": {}, "mode": {}})
        for kind in ("stage", "mode"):
            if kind in info:
                column[kind][info[kind]] = bench["stats"]["median"]
    order = [columns[n] for n in sorted(columns)]
    sizes = [column["info"] for column in order]
    heads = [f"{s['vertices']:,} vertices, {s['triangles']:,} triangles" for s in sizes]
    lines = []
    for kind in ("stage", "mode"):
        lines += ["", f"| {kind} | " + " | ".join(heads) + " |", "|---|" + "---:|" * len(order)]
        for name in order[0][kind]:
            label = f"of {PART_OF[name]}: {name}" if name in PART_OF else name
            lines.append(f"| {label} | " + " | ".join(f"{c[kind][name]:.2f}" for c in order) + " |")
        if kind == "stage":
            sums = (sum(s for k, s in c[kind].items() if k not in PART_OF) for c in order)
            lines.append("| **sum** | " + " | ".join(f"**{s:.1f}**" for s in sums) + " |")
    meshers = sorted({s["mesher"] for s in sizes})
    return [*lines[1:], "", f"Mesher: {', '.join(meshers)}."]


def machine(run: dict[str, Any]) -> str:
    """One sentence on what the figures were taken on."""
    info = run["machine_info"]
    cpu = info.get("cpu", {}).get("brand_raw") or info["machine"]
    return (
        f"{cpu}; {info['python_implementation']} {info['python_version']}; {run['datetime'][:10]}."
    )


def main() -> None:
    """Replace what stands between the two markers."""
    run = newest()
    before, _, rest = PAGE.read_text(encoding="utf-8").partition(START)
    after = rest.partition(END)[2]
    figures = "\n".join([START, "", *tables(run), "", machine(run), "", END])
    PAGE.write_text(before + figures + after, encoding="utf-8")


if __name__ == "__main__":
    main()
