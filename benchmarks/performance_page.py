# SPDX-License-Identifier: LGPL-2.1-or-later
"""The figures of docs/performance.md and their plot, from what `run.py` measured."""

from __future__ import annotations

import math
from statistics import median
from typing import Any

from docs_section import renew
from meshes import ROOT

PAGE = ROOT / "docs" / "performance.md"
PLOT = ROOT / "docs" / "images" / "performance.svg"

CASES = {
    "10k": "10k",
    "100k": "100k",
    "1M": "1M",
    "stl": "STL export",
    "noise": "100k, noise 0.03 h",
}

Case = dict[str, Any]


def renew_page(figures: dict[str, Any]) -> None:
    """Replace what stands between the two markers, and the plot."""
    lines = [*tables(figures), "", f"{figures['cpu']}, {figures['date']}."]
    renew(PAGE, "figures", lines)
    _plot(_cases(figures))


def tables(figures: dict[str, Any]) -> list[str]:
    """All figures as Markdown."""
    cases = _cases(figures)
    lines = [*_main_table(cases), *_exponent(cases), *_other_modes(cases)]
    lines += _likelihood(figures["density"])
    if missing := [CASES[name] for name in CASES if name not in cases]:
        lines += ["", f"Not measured in this run: {', '.join(missing)}."]
    if figures["help_s"]:
        lines += ["", f"`gpswb --help` takes {figures['help_s']:.2f} CPU s."]
    return lines


def _cases(figures: dict[str, Any]) -> dict[str, Case]:
    return {name: figures["cases"][name] for name in CASES if name in figures["cases"]}


def _run(case: Case, name: str) -> float:
    return median(run[name] for run in case["runs"])


def _freecad(case: Case) -> float | None:
    return median(case["freecad"]["seconds"]) if case["freecad"] else None


def _number(value: float | None) -> str:
    if value is None:
        return ""
    return f"{value:.0f}" if value >= 100 else f"{value:.3g}" if value >= 0.01 else f"{value:.3f}"


def _main_table(cases: dict[str, Case]) -> list[str]:
    stages = list(dict.fromkeys(stage for case in cases.values() for stage in case["stages"]))
    rows: list[tuple[str, list[str]]] = [
        ("vertices", [f"{case['vertices']:,}" for case in cases.values()]),
        ("triangles", [f"{case['triangles']:,}" for case in cases.values()]),
        (
            "tessellation, apart",
            [
                # The noisy mesh is that of another case.
                "" if name == "noise" else _number(case["tessellation_cpu_s"])
                for name, case in cases.items()
            ],
        ),
        ("**whole partition**", [f"**{_number(_run(c, 'whole'))}**" for c in cases.values()]),
    ]
    rows += [
        (f"– {stage}", [_number(case["stages"].get(stage)) for case in cases.values()])
        for stage in stages
        if any(case["stages"].get(stage, 0.0) >= 0.01 for case in cases.values())
    ]
    rows += [
        (
            "log-likelihoods, once they are read",
            [_number(_run(c, "likelihoods")) for c in cases.values()],
        ),
        ("libigl `principal_curvature`", [_number(_run(c, "libigl")) for c in cases.values()]),
        (
            "**whole / libigl**",
            [f"**{_number(_run(c, 'whole') / _run(c, 'libigl'))}**" for c in cases.values()],
        ),
        ("curvature alone", [_number(_run(c, "curvature alone")) for c in cases.values()]),
        ("FreeCAD `getCurvaturePerVertex`", [_number(_freecad(c)) for c in cases.values()]),
        (
            "**curvature / FreeCAD**",
            [
                f"**{_number(_run(c, 'curvature alone') / peer)}**" if (peer := _freecad(c)) else ""
                for c in cases.values()
            ],
        ),
        ("memory, bytes a vertex", [f"{c['memory_a_vertex']:,.0f}" for c in cases.values()]),
        ("faces found and typed", [f"{c['found']} of {c['faces']}" for c in cases.values()]),
        ("regions", [str(c["regions"]) for c in cases.values()]),
    ]
    heads = [CASES[name] for name in cases]
    table = [f"| CPU seconds | {' | '.join(heads)} |", "|---|" + "---:|" * len(heads)]
    return table + [f"| {name} | {' | '.join(cells)} |" for name, cells in rows]


def _exponent(cases: dict[str, Case]) -> list[str]:
    sizes = [name for name in ("10k", "100k", "1M") if name in cases]
    if len(sizes) < 2:
        return []
    first, last = cases[sizes[0]], cases[sizes[-1]]
    growth = math.log(last["vertices"] / first["vertices"])

    def exponent(name: str) -> str:
        return f"{math.log(_run(last, name) / _run(first, name)) / growth:.2f}"

    sentence = (
        f"From {sizes[0]} to {sizes[-1]} time grows with the vertices to the power of "
        f"{exponent('whole')}, that of libigl {exponent('libigl')}."
    )
    return ["", sentence]


def _other_modes(cases: dict[str, Case]) -> list[str]:
    timed = {name: case for name, case in cases.items() if case.get("other")}
    if not timed:
        return []
    heads = [CASES[name] for name in timed]
    lines = ["", f"| modes of the paper | {' | '.join(heads)} |", "|---|" + "---:|" * len(heads)]
    for mode in ("paper", "corrected"):
        cells = [_number(case["other"][mode]) for case in timed.values()]
        lines.append(f"| `{mode}`, CPU s | {' | '.join(cells)} |")
    others = [case["other"] for case in timed.values()]
    lines.append(f"| pairs scored | {' | '.join(format(o['pairs'], ',') for o in others)} |")
    pair = [_number(1e6 * o["seconds"] / o["pairs"]) if o["pairs"] else "" for o in others]
    lines.append(f"| merging, µs a pair | {' | '.join(pair)} |")
    return lines


def _likelihood(density: dict[str, dict[str, float]] | None) -> list[str]:
    if not density:
        return []
    lines = ["", "| leave-one-out likelihood of 100,000 points | 1-D | 2-D | 3-D |"]
    lines.append("|---|---:|---:|---:|")
    of = [density[d] for d in ("1", "2", "3")]
    lines.append("| gpswb, CPU s | " + " | ".join(_number(d["own"]) for d in of) + " |")
    lines.append("| scikit-learn, CPU s | " + " | ".join(_number(d["sklearn"]) for d in of) + " |")
    ratio = " | ".join(f"1/{d['sklearn'] / d['own']:.0f}" for d in of)
    lines.append(f"| ratio | {ratio} |")
    nats = " | ".join(f"{d['difference']:.1e}" for d in of)
    return [*lines, f"| difference of the mean, nats | {nats} |"]


def _plot(cases: dict[str, Case]) -> None:
    import matplotlib as mpl

    mpl.use("Agg")
    mpl.rcParams["svg.hashsalt"] = "gpswb"  # the same bytes from the same figures
    import matplotlib.pyplot as plt

    sizes = [case for name, case in cases.items() if name in ("10k", "100k", "1M")]
    n = [case["vertices"] for case in sizes]
    figure, axes = plt.subplots(figsize=(9, 4.5), layout="constrained")
    axes.plot(n, [_run(c, "whole") for c in sizes], "o-", color="black", lw=2.5, label="whole")
    for stage in sizes[0]["stages"]:
        seconds = [case["stages"].get(stage, 0.0) for case in sizes]
        if seconds[-1] >= 0.02:
            axes.plot(n, seconds, "o-", lw=1.2, label=stage)
    axes.plot(n, [_run(c, "libigl") for c in sizes], "s--", label="libigl principal_curvature")
    if all(_freecad(case) for case in sizes):
        axes.plot(n, [_freecad(c) for c in sizes], "^--", label="FreeCAD getCurvaturePerVertex")
    axes.set(xscale="log", yscale="log", xlabel="vertices", ylabel="CPU seconds, one thread")
    axes.grid(which="both", color="0.9")
    figure.legend(loc="outside right upper", fontsize=8)
    figure.savefig(PLOT, metadata={"Date": None})
