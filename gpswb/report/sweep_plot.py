# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plot of a sweep: accuracy against the number of triangles, a panel for each noise."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from gpswb.errors import OutputError

CURVES = (
    ("area_accuracy", "area accuracy", "#0072B2", "o"),
    ("face_accuracy", "face accuracy", "#D55E00", "s"),
    ("region_f1", "region F1", "#009E73", "^"),
)


def write_sweep_plot(path: Path, rows: Sequence[Mapping[str, Any]], name: str) -> None:
    """Write the plot as SVG.

    Args:
        path: the file.
        rows: ``density``, ``noise``, ``triangles`` and the three figures of every run.
        name: of the part.

    Raises:
        OutputError: matplotlib isn't installed.
        OSError: the file can't be written.
    """
    try:
        from matplotlib.backends.backend_svg import FigureCanvasSVG
        from matplotlib.figure import Figure
    except ImportError as error:
        raise OutputError("a plot needs the Python package matplotlib") from error
    noises = sorted({row["noise"] for row in rows})
    figure = Figure(figsize=(1.0 + 4.6 * len(noises), 4.2), layout="constrained")
    FigureCanvasSVG(figure)
    panels = figure.subplots(1, len(noises), sharey=True, squeeze=False)[0]
    for panel, noise in zip(panels, noises, strict=True):
        points = sorted(
            (row for row in rows if row["noise"] == noise), key=lambda row: row["triangles"]
        )
        x = [row["triangles"] for row in points]
        for key, label, colour, marker in CURVES:
            y = [row[key] for row in points]
            panel.plot(x, y, marker, ls="-", color=colour, label=label, alpha=0.8)
        panel.set_xscale("log")
        panel.minorticks_off()
        panel.set_xticks(x, [f"{row['density']}\n{row['triangles']:,}" for row in points])
        panel.tick_params("x", labelsize=7, labelrotation=30)
        panel.set_ylim(-0.02, 1.02)
        panel.set_xlabel("density, triangles")
        panel.grid(visible=True, alpha=0.3)
        noise_text = f"noise {100 * noise:g} % of the diagonal" if noise else "no noise"
        panel.set_title(noise_text, fontsize=10)
    panels[0].set_ylabel("share")
    panels[0].legend(loc="center left", fontsize=8)
    # A dollar would start mathematics; the name is a file's.
    figure.suptitle(name.replace("$", r"\$"))
    figure.savefig(path, format="svg", metadata={"Date": None})
