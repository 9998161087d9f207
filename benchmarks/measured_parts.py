# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections blade, methods and noise: the paper's Figs. 17 and 18 on parts whose truth is known."""

from __future__ import annotations

import tempfile
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure
from measured_pictures import (
    by_class,
    by_region,
    by_shape,
    occurring,
    panels,
    render,
    render_points,
)
from measured_runs import METHODS, run
from parts import PARTS
from parts.simulated_scan import Scanner, simulate
from parts.step_units import write_step

from gpswb.batch.one_part import add_noise
from gpswb.cad.density import Density
from gpswb.cad.fcstd_measured import Measurement
from gpswb.cad.read import read_solid
from gpswb.cad.solid import Solid
from gpswb.core.invariance import CLASSES
from gpswb.io.measured_file import solid_of_parts

PART = "revolution_part"
"""The part of figure 18 and of the table; like the paper's Fig. 15 a turned part."""

NO_FACETS = np.zeros((0, 3), dtype=np.int64)
NOISES = (0.0, 0.0005, 0.001, 0.002, 0.005)
DENSITIES = (3500, 12500, 35000, 100000)
TOWARD = (-0.6, 0.9, -0.6)
COLOURS = {"hybrid": "#0072B2", "curvature": "#D55E00", "slippage": "#009E73"}


def part_solid(name: str, density: str) -> Solid:
    """An example part, tessellated."""
    with tempfile.TemporaryDirectory() as scratch:
        path = Path(scratch) / f"{name}.step"
        write_step(PARTS[name]().shape, path)
        return read_solid(path, Density.parse(density))


def blade_section(images: Path) -> Iterator[str]:
    """Fig. 17: a scan of a blade in six panels, and how it compares with the truth."""
    scanner = Scanner(points=20_000, noise=0.02, gap_radius=3.0)
    scan = simulate(part_solid("blade", "deflection=0.0025"), scanner)
    cloud = solid_of_parts([Measurement(scan.points, NO_FACETS)], "blade", "mm", ())
    assert cloud.pointmap is not None
    vertex = cloud.pointmap.vertex_of_point
    found = run(cloud)
    lines = ["## A scanned blade (the paper's Fig. 17)", "", "Made by `./gps measured blade`.", ""]
    lines += [
        (f"The blade is `examples/parts/blade.py`, the scan `examples/parts/simulated_scan.py`: "
        f"{len(scan.points):,} points, {int((scan.label < 0).sum())} of them outliers, noise "
        f"{scanner.noise} mm along the normal ({scanner.noise / cloud.mesh.diagonal:.1e} of the "
        f"diagonal), {scanner.unevenness:g} times as dense on one side as on the other, "
        f"{scanner.gaps} gaps of {2 * scanner.gap_radius:g} mm."), "",
        *(f"- {note}" for note in cloud.notes), "",
    ]  # fmt: skip
    if found is None:
        yield "\n".join([*lines, "**Not done in time.**", ""])
        return
    facts, mesh = found.facts, cloud.mesh
    titles = [
        ("a) points", render_points(scan.points, TOWARD)),
        ("b) shape types", render(mesh, by_shape(found.unvoted), TOWARD)),
        ("c) after voting", render(mesh, by_shape(found.shape), TOWARD)),
        (f"d) {facts['initial']} initial regions", render(mesh, by_region(found.initial), TOWARD)),
        (f"e) {facts['regions']} regions", render(mesh, by_region(found.region), TOWARD)),
        ("f) classes", render(mesh, by_class(found.label), TOWARD)),
    ]
    panels(images / "measured_blade.png", [titles[:3], titles[3:]], occurring(found.label))
    area = np.bincount(found.region[found.region >= 0], mesh.areas[found.region >= 0])
    label = np.where(vertex >= 0, found.vertex_label[vertex], -1)
    real = scan.label >= 0
    strays = vertex < 0
    right = (label == scan.label)[real].mean()
    large = int((area >= 0.005 * area.sum()).sum())
    lines += [
        "![six panels](images/measured_blade.png)", "",
        "| | this scan | the paper's blade |", "|---|---:|---:|",
        f"| initial regions | {facts['initial']} | 1102 |",
        f"| refined regions | {facts['regions']} | 48 |",
        f"| of which at least 0.5 % of the area | {large} | – |",
        "| faces of the part | 22 | – |",
        f"| points of the part with the right class | {right:.4f} | – |",
        f"| outliers set aside | {int((strays & ~real).sum())} of {int((~real).sum())} | – |",
        f"| points of the part set aside | {int((strays & real).sum())} of {int(real.sum())} | – |",
        f"| noise estimated, mm | {facts['sigma'] * mesh.diagonal:.4f} | – |",
        f"| CPU s | {facts['seconds']:.0f} | – |", "",
    ]  # fmt: skip
    lines += ["Points taken for another class, share of all the part's points: "]
    wrong = Counter(
        (CLASSES[a], CLASSES[b] if b >= 0 else "none")
        for a, b in zip(scan.label[real].tolist(), label[real].tolist(), strict=True)
        if a != b
    )
    said = (f"{a} as {b} {100 * n / real.sum():.1f} %" for (a, b), n in wrong.most_common(4))
    lines += [", ".join(said) + ".", ""]
    yield "\n".join(lines)


def methods_section(images: Path) -> Iterator[str]:
    """Fig. 18: three meshes of one part, three methods."""
    low, high = (part_solid(PART, f"vertices={n}") for n in (3500, 12500))
    meshes = {
        "low density": low,
        "high density": high,
        "low density, noise 0.1 %": add_noise(low, 0.001),
    }
    lines = ["## Three methods (the paper's Fig. 18)", "", "Made by `./gps measured methods`.", ""]
    lines += ["| mesh | vertices | method | area | faces | F1 | regions | CPU s |"]
    lines += ["|---|---:|---|---:|---:|---:|---:|---:|"]
    rows, labels = [], []
    for name, solid in meshes.items():
        row = []
        for method in METHODS:
            found = run(solid, method)
            lines.append(_figures(name, len(solid.mesh.vertices), method, found and found.facts))
            if found is not None:
                said = f"{name}\n{method}: {found.facts['area']:.3f} of the area"
                row.append((said, render(solid.mesh, by_class(found.label), TOWARD)))
                labels.append(found.label)
        rows.append(row)
    panels(images / "measured_methods.png", rows, occurring(*labels))
    yield "\n".join([*lines, "", "![three methods](images/measured_methods.png)", ""])


def _figures(name: str, vertices: int, method: str, facts: dict[str, Any] | None) -> str:
    if facts is None:
        return f"| {name} | {vertices:,} | {method} | not done in time | | | | |"
    return (
        f"| {name} | {vertices:,} | {method} | {facts['area']:.4f} | {facts['face']:.4f} | "
        f"{facts['f1']:.4f} | {facts['regions']} | {facts['seconds']:.0f} |"
    )


def noise_section(images: Path) -> Iterator[str]:
    """Accuracy of the three methods over density and noise: table and plot."""
    lines = ["## Density and noise", "", "Made by `./gps measured noise`.", ""]
    lines += [
        "Share of the area with the right class (faces right); noise in % of the diagonal.",
        "",
    ]
    lines += ["| vertices | method |" + "".join(f" {100 * f:g} % |" for f in NOISES)]
    lines += ["|---:|---|" + "---:|" * len(NOISES)]
    table: dict[tuple[int, str], list[float | None]] = {}
    behind: list[str] = []
    for density in DENSITIES:
        solid = part_solid(PART, f"vertices={density}")
        n = len(solid.mesh.vertices)
        noisy = [add_noise(solid, f) if f else solid for f in NOISES]
        for method in METHODS:
            done = [run(s, method) for s in noisy]
            table[n, method] = [r.facts["area"] if r else None for r in done]
            cells = [
                f"{r.facts['area']:.3f} ({r.facts['face']:.2f})" if r else "too slow" for r in done
            ]
            lines.append(f"| {n:,} | {method} | " + " | ".join(cells) + " |")
        for i, fraction in enumerate(NOISES):
            own = table[n, "hybrid"][i]
            best = max(table[n, m][i] or 0.0 for m in METHODS)
            if own is None or own < best:
                behind.append(f"{n:,} vertices at {100 * fraction:g} %")
        said = f"Hybrid is behind a rival, or too slow, at: {', '.join(behind)}."
        said = said if behind else "Hybrid is ahead of both rivals everywhere."
        _plot(images / "measured_noise.svg", table)
        picture = "![accuracy over noise](images/measured_noise.svg)"
        yield "\n".join([*lines, "", said, "", picture, ""])


def _plot(path: Path, table: dict[tuple[int, str], list[float | None]]) -> None:
    sizes = sorted({n for n, _ in table})
    figure = Figure(figsize=(3.2 * len(sizes), 3.2), layout="constrained")
    FigureCanvasSVG(figure)
    axes = figure.subplots(1, len(sizes), sharey=True, squeeze=False)[0]
    x = 100 * np.array(NOISES)
    for axis, n in zip(axes, sizes, strict=True):
        for method in METHODS:
            y = np.array([np.nan if v is None else v for v in table[n, method]])
            axis.plot(x, y, "o-", color=COLOURS[method], label=method)
        axis.set_title(f"{n:,} vertices", fontsize=10)
        axis.set_xlabel("noise, % of the diagonal")
        axis.set_ylim(-0.02, 1.02)
        axis.grid(visible=True, alpha=0.3)
    axes[0].set_ylabel("share of the area right")
    axes[0].legend(fontsize=8)
    figure.savefig(path, format="svg", metadata={"Date": None})
