# SPDX-License-Identifier: LGPL-2.1-or-later
"""Section corpus: labelled meshes and clouds, and a look at unlabelled ones."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from measured_labels import abc_labels, fit4cad_labels
from measured_pictures import by_class, by_region, occurring, panels, render
from measured_runs import Run, run

from gpswb.cad.solid import Solid
from gpswb.core.invariance import CLASSES
from gpswb.core.mesh import Mesh
from gpswb.io.measured_file import read_measured

UNLABELLED = ("fandisk.off", "casting.off", "rocker-arm.off", "propeller.stl", "cycloidal.ply")
MAPPING = """\
ABC labels each triangle, Fit4CAD each point with the surface that it was made from. They map onto
the classes so: plane – planar; cylinder – cylindrical; sphere – spherical; cone, torus, surface of
revolution – revolute; linear extrusion – prismatic. A B-spline may be of any class and is left out
(these files hold none). Ambiguous: Fit4CAD's points near the border of two primitives belong to
both, and either class counts as right; a label says nothing of a higher symmetry that a surface of
revolution or an extrusion may have (these files hold neither). The goals are 0.97 of the area on
ABC's meshes and 0.9 of the points on Fit4CAD's clouds.
"""

TOWARD = (-0.6, 0.9, -0.6)


def corpus_section(corpus: Path, images: Path) -> Iterator[str]:
    """Markdown of the whole section."""
    lines = ["## Labelled meshes and clouds", "", "Made by `./gps measured corpus`.", "", MAPPING]
    lines += ["| file | of | labelled | right | vertices | regions | CPU s |"]
    lines += ["|---|---|---:|---:|---:|---:|---:|"]
    wrong: list[str] = []
    for path in sorted((corpus / "mesh").glob("abc_*.obj")):
        print(path.name, flush=True)
        solid = read_measured(path, "mm")
        right = abc_labels(path, solid.mesh)
        found = run(solid)
        row, _, _ = _row(path.name, "area", found, solid, right, solid.mesh.areas, wrong)
        lines.append(row)
        yield _labelled(lines, wrong)
    good = labelled = 0
    for path in sorted((corpus / "cloud").glob("PC*.txt")):
        if "_" in path.stem:
            continue
        print(path.name, flush=True)
        solid = read_measured(path, "mm")
        assert solid.pointmap is not None
        right = fit4cad_labels(path, len(solid.pointmap.points))
        found = run(solid)
        ones = np.ones(len(right))
        row, *counts = _row(path.name, "points", found, solid, right, ones, wrong)
        good, labelled = good + int(counts[0]), labelled + int(counts[1])
        pooled = f"| all clouds | points | | {good / labelled:.4f} | {labelled:,} | | |"
        lines.append(row)
        yield _labelled([*lines, pooled], wrong)
    for part in _unlabelled(corpus, images):
        yield f"{_labelled([*lines, pooled], wrong)}\n{part}"


def _labelled(lines: list[str], wrong: list[str]) -> str:
    what = "What was taken for what, share of the labelled area or points:"
    return "\n".join([*lines, "", what, "", *wrong, ""])


def _row(
    name: str, of: str, found: Run | None, solid: Solid, right: np.ndarray,
    weight: np.ndarray, wrong: list[str],
) -> tuple[str, float, float]:  # fmt: skip
    """The row of a file; the weight that has the right class, and that with a label."""
    labelled = right.any(axis=1)
    share = weight[labelled].sum() / weight.sum()
    vertices = len(solid.mesh.vertices)
    if found is None:
        row = f"| {name} | {of} | {share:.4f} | not done in time | {vertices:,} | | |"
        return row, 0.0, float(weight[labelled].sum())
    label = found.label
    if solid.pointmap is not None:
        vertex = solid.pointmap.vertex_of_point
        label = np.where(vertex >= 0, found.vertex_label[vertex], -1)
    good = labelled & (label >= 0) & right[np.arange(len(label)), label]
    right_weight, all_weight = float(weight[good].sum()), float(weight[labelled].sum())
    pairs: dict[tuple[str, str], float] = {}
    for i in np.flatnonzero(labelled & ~good):
        true = " or ".join(CLASSES[k] for k in np.flatnonzero(right[i]))
        taken = CLASSES[label[i]] if label[i] >= 0 else "none"
        pairs[true, taken] = pairs.get((true, taken), 0.0) + weight[i] / all_weight
    worst = sorted(pairs.items(), key=lambda item: -item[1])[:4]
    said = ", ".join(f"{true} as {taken} {100 * part:.2f} %" for (true, taken), part in worst)
    wrong.append(f"- {name}: {said or 'nothing'}")
    facts = found.facts
    row = (
        f"| {name} | {of} | {share:.4f} | {right_weight / all_weight:.4f} | {vertices:,} | "
        f"{facts['regions']} | {facts['seconds']:.0f} |"
    )
    return row, right_weight, all_weight


def _unlabelled(corpus: Path, images: Path) -> Iterator[str]:
    lines = [
        "### Without labels",
        "",
        "Share of the area by class; ![regions and classes](images/measured_corpus.png)",
        "",
    ]
    lines += ["| file | triangles | noise σ / diagonal | initial | regions | classes | CPU s |"]
    lines += ["|---|---:|---:|---:|---:|---|---:|"]
    shown, labels = [], []
    for name in UNLABELLED:
        path = corpus / "mesh" / name
        print(path.name, flush=True)
        solid = read_measured(path, "mm")
        found = run(solid)
        n = len(solid.mesh.triangles)
        if found is None:
            lines.append(f"| {name} | {n:,} | | | not done in time | | |")
            yield "\n".join([*lines, ""])
            continue
        area = np.bincount(found.label + 1, solid.mesh.areas, minlength=8) / solid.mesh.areas.sum()
        order = [k for k in np.argsort(-area) if area[k] >= 0.005]
        said = ", ".join(f"{(['none', *CLASSES])[k]} {100 * area[k]:.1f} %" for k in order)
        facts = found.facts
        lines.append(
            f"| {name} | {n:,} | {facts['sigma']:.1e} | {facts['initial']} | {facts['regions']} | "
            f"{said} | {facts['seconds']:.0f} |"
        )
        shown.append(
            [
                (
                    f"{name}: {facts['regions']} regions",
                    _picture(solid.mesh, by_region(found.region)),
                ),
                ("classes", _picture(solid.mesh, by_class(found.label))),
            ]
        )
        labels.append(found.label)
        panels(images / "measured_corpus.png", shown, occurring(*labels))
        yield "\n".join([*lines, ""])


def _picture(mesh: Mesh, colours: np.ndarray) -> np.ndarray:
    return render(mesh, colours, TOWARD)
