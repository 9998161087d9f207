# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.html of one part: one self-contained offline page with 3-D views."""

from __future__ import annotations

import json
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np

import gpswb
from gpswb.cad.solid import FaceMap
from gpswb.core.initial import unvoted_types
from gpswb.core.invariance import CLASSES
from gpswb.core.mesh import IntArray, Mesh
from gpswb.core.partition import Partition
from gpswb.io.colours import NONE, SAFE, SHAPE_TYPES, SHARP_EDGE, WHEEL
from gpswb.report.pack import pack

CREASE_DEG = 30.0
"""Facets that meet at more than this are drawn with a sharp edge between them."""

SCRIPTS = ("part_view.js", "part_table.js", "part_gps.js", "part_page.js")

GRID = 65535
"""Coordinates are drawn on a grid of 16 bits an axis."""


def write_report(
    path: Path,
    document: dict[str, Any],
    partition: Partition,
    facemap: FaceMap | None,
    features: dict[str, Any] | None = None,
) -> None:
    """Write the page.

    Args:
        path: the file.
        document: the result, from `result_document`.
        partition: the partition it speaks of.
        facemap: provenance of the triangles; None for a mesh input.
        features: GPS features, datum systems and specifications, from `features_document`.

    Raises:
        OSError: the file can't be written.
    """
    path.write_text(report_page(document, partition, facemap, features), encoding="utf-8")


def report_page(
    document: dict[str, Any],
    partition: Partition,
    facemap: FaceMap | None,
    features: dict[str, Any] | None = None,
) -> str:
    """The page as text; the arguments are those of `write_report`."""
    area = partition.mesh.areas
    by_type = np.bincount(np.clip(partition.shape_type + 4, 0, 10), area, minlength=11)
    data = {
        "program": f"gpswb {gpswb.__version__}",
        "result": document,
        "features": features,
        "classes": CLASSES,
        "palettes": {"wheel": WHEEL, "safe": SAFE},
        "none": NONE,
        "sharp_edge": SHARP_EDGE,
        "shape_types": [
            {"name": name, "colour": colour, "share": float(share / (area.sum() or 1.0))}
            for (name, colour), share in zip(SHAPE_TYPES, by_type, strict=True)
        ],
        "measured": facemap is None,
        "mesh": _mesh(partition, facemap),
    }
    page = _asset("part_page.html")
    for mark, text in (
        ("/*STYLE*/", _asset("part_page.css")),
        ("/*SCRIPT*/", "".join(map(_asset, SCRIPTS))),
        ("/*DATA*/", script_json(data)),  # last: what is in the data is never looked through
    ):
        head, tail = page.split(mark)
        page = head + text + tail
    return page


def script_json(value: Any) -> str:
    """JSON that can stand in a script element whatever its strings hold."""
    text = json.dumps(value, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    for special in "<>&\u2028\u2029":
        text = text.replace(special, f"\\u{ord(special):04x}")
    return text


def _mesh(partition: Partition, facemap: FaceMap | None) -> dict[str, Any]:
    """The mesh on a 16-bit grid, labels a facet, borders to draw."""
    mesh = partition.mesh
    low = mesh.vertices.min(axis=0, initial=np.inf) if len(mesh.vertices) else np.zeros(3)
    span = np.ptp(mesh.vertices, axis=0) if len(mesh.vertices) else np.zeros(3)
    grid = np.rint((mesh.vertices - low) / np.where(span > 0, span, 1.0) * GRID)
    ids = np.array([region.id for region in partition.regions] + [-1], dtype=np.int64)
    face = facemap.face_of_triangle if facemap else np.full(len(mesh.triangles), -1)
    measured = {} if facemap else {"unvoted": pack(unvoted_types(mesh, partition.sigma))}
    return {
        **measured,
        "size": list(span / (mesh.diagonal or 1.0)),
        "vertices": pack(grid.T),
        "triangles": pack(mesh.triangles),
        "region": pack(ids[partition.region]),
        "initial": pack(partition.initial_region),
        "shape": pack(partition.shape_type),
        "face": pack(face),
        "edges": {
            "initial": pack(_borders(mesh, partition.initial_region)),
            "region": pack(_borders(mesh, partition.region)),
            "sharp": pack(_creases(mesh)),
        },
    }


def _borders(mesh: Mesh, label: IntArray) -> IntArray:
    """(e, 2) edges at which the facets' label changes."""
    a, b = mesh.facet_pairs.T
    edges: IntArray = mesh.pair_edges[label[a] != label[b]]
    return edges


def _creases(mesh: Mesh) -> IntArray:
    """(e, 2) edges at which the facets meet at more than ``CREASE_DEG``."""
    n = mesh.facet_normals
    a, b = mesh.facet_pairs.T
    cosine = np.einsum("ij,ij->i", n[a], n[b])
    edges: IntArray = mesh.pair_edges[cosine < np.cos(np.radians(CREASE_DEG))]
    return edges


def _asset(name: str) -> str:
    return resources.files("gpswb.report").joinpath(name).read_text("utf-8")
