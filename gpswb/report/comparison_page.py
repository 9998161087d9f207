# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.html of a scan against its nominal part."""

from __future__ import annotations

from html import escape
from typing import Any

import numpy as np

from gpswb.core.invariance import CLASSES
from gpswb.core.mesh import FloatArray
from gpswb.core.partition import Partition
from gpswb.io.colours import NONE, WHEEL
from gpswb.report.corpus_tables import Table
from gpswb.report.picture import BACKGROUND, DIRECTIONS, Image
from gpswb.report.png import png_bytes
from gpswb.report.raster import camera, visible_triangles
from gpswb.report.static_page import Figure, figures_html, legend_html, static_page, table_html
from gpswb.validation.comparison import Comparison
from gpswb.validation.face_result import facet_classes

SIZE = (560, 460)
VIEWS = (3, 4)
"""Two opposite ones of the eight directions: what one hides the other shows."""

RANGE = 0.98
"""The colours span this share of the points; beyond it they saturate."""

HEAD = (
    "faces", "class", "in the scan", "points", "form", "least squares", "minimax",
    "roundness", "profile", "mean", "sizes (nominal)",
)  # fmt: skip


SHORT = {"radius": "R", "major_radius": "R", "minor_radius": "r", "half_angle_deg": "half angle"}
"""Sizes as the table calls them."""

MEANING = (
    "Form deviations are the widths of the zone about the associated ideal feature, by total least "
    "squares and by minimax (Chebyshev). The profile is twice the largest distance to the nominal "
    "surface. Roundness is the largest over sections, by minimum zone."
)


def comparison_page(document: dict[str, Any], partition: Partition, comparison: Comparison) -> str:
    """The page: a table of the features, pictures of deviations and classes."""
    scan, part = document["scan"]["path"], document["nominal"]["path"]
    aligned = document["alignment"]
    said = (
        f"Aligned, {100 * aligned['paired']:.1f} % of the points paired."
        if aligned
        else "Not aligned."
    )
    span = _span(comparison)
    figures = [
        Figure(text, png_bytes(_picture(partition, colours, view)))
        for text, colours in (
            (f"distance to the nominal part, -{span:.3g} mm blue to {span:.3g} mm red",
             _by_distance(partition, comparison, span)),
            ("classes of the scan's regions", _by_class(partition)),
        )
        for view in VIEWS
    ]  # fmt: skip
    counts = (
        f"{document['far']} of {document['vertices']} points lie too far off, the others "
        f"{_length(document['rms'])} off in root mean square; "
        f"{document['extracted']} are extracted points of a feature. Lengths in mm."
    )
    body = [
        f"<p>{escape(scan)} against {escape(part)}. {said} {counts}</p>",
        table_html(features_table(document)),
        f"<p>{MEANING}</p>",
        figures_html(figures),
        legend_html(),
        *(f"<p>{escape(note)}</p>" for note in document["notes"]),
    ]
    return static_page("Scan against nominal part", body)


def features_table(document: dict[str, Any]) -> Table:
    """The features as text, also for the terminal."""
    rows = tuple(
        (
            " ".join(row["faces"]),
            row["nominal_class"] or "-",
            (row["scan_class"] or "-") + ("" if row["extraction"] == "region" else " ?"),
            str(row["points"]),
            row["form"] or "-",
            *(_length(row[key]) for key in (
                "least_squares", "minimax", "roundness_minimax", "profile", "mean")),
            _sizes(row["intrinsic"]),
        )
        for row in document["features"]
    )  # fmt: skip
    return Table("Features", HEAD, rows)


def _length(value: float | None) -> str:
    return "-" if value is None else f"{value:.4f}"


def _sizes(intrinsic: dict[str, float]) -> str:
    return ", ".join(
        f"{short} {intrinsic[name]:.4f} ({intrinsic['nominal_' + name]:.6g})"
        for name, short in SHORT.items()
        if name in intrinsic
    )


def _span(comparison: Comparison) -> float:
    near = np.abs(comparison.distance[comparison.face >= 0])
    return float(np.quantile(near, RANGE)) if len(near) else 0.0


def _by_distance(partition: Partition, comparison: Comparison, span: float) -> FloatArray:
    """(m, 3) blue inside, white on, red outside the nominal surface; grey off it."""
    corner = partition.mesh.triangles
    t = np.clip(comparison.distance[corner].mean(axis=1) / (span or 1.0), -1.0, 1.0)[:, None]
    red, blue, white = np.array([200.0, 30, 30]), np.array([30.0, 60, 200]), np.full(3, 240.0)
    colours = np.where(t > 0, white + t * (red - white), white - t * (blue - white))
    colours[(comparison.face[corner] < 0).any(axis=1)] = NONE
    return np.asarray(colours)


def _by_class(partition: Partition) -> FloatArray:
    palette = np.array([WHEEL[name] for name in CLASSES] + [NONE], dtype=np.float64)
    return np.asarray(palette[facet_classes(partition)])


def _picture(partition: Partition, colours: FloatArray, view: int) -> Image:
    frame = camera(DIRECTIONS[view])
    seen = visible_triangles(partition.mesh, frame, *SIZE)
    shade = 0.55 + 0.45 * np.abs(partition.mesh.facet_normals @ frame[2])
    image = np.where(seen[..., None] >= 0, (colours * shade[:, None])[seen], BACKGROUND)
    return np.asarray(image, dtype=np.uint8)
