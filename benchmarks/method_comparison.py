# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every method on the same meshes: figures, picture, and the section of docs/validation.md."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from measured_parts import part_solid
from measured_pictures import by_class, occurring, panels, render
from measured_runs import run
from parts import PARTS
from segments import Call, freecad_partition

from gpswb.batch.one_part import add_noise
from gpswb.cad.density import Density
from gpswb.cad.read import read_solid
from gpswb.cad.solid import Solid
from gpswb.core.pipeline import Method, Mode
from gpswb.errors import GpswbError
from gpswb.validation.face_result import facet_classes
from gpswb.validation.validate import validate

PICTURE = Path(__file__).resolve().parents[1] / "docs" / "images" / "validation_methods.png"

NOISE = 0.001
"""Of the diagonal, in the third mesh."""

MESHES = {
    "low density": (3500, 0.0),
    f"low density, noise {100 * NOISE:g} %": (3500, NOISE),
    "high density": (12500, 0.0),
}
"""Vertices and noise: those of the paper's Fig. 18."""

OWN: dict[str, tuple[Mode, Method]] = {
    "robust": ("robust", "hybrid"),
    "corrected": ("corrected", "hybrid"),
    "paper": ("paper", "hybrid"),
    "curvature": ("robust", "curvature"),
    "slippage": ("robust", "slippage"),
}
CALLS: dict[str, Call] = {
    "getPlanarSegments": "planar",
    "getSegmentsOfType": "type",
    "getSegmentsByCurvature": "curvature",
}
LEAST = (100, 12)
"""Facets of a segment: FreeCAD's dialogs say 100, which many faces of these meshes don't have."""

DISTANCE = 0.01
"""mm, what FreeCAD's dialog of best-fit segments says."""

METHODS = [*OWN, *(f"FreeCAD {name}, {least}" for name in CALLS for least in LEAST)]
ROUNDING = 5e-4

SHOWN = "bracket"
"""The part in the picture."""

HEAD = f"""\
Made by `python benchmarks/compare_methods.py PART...`, where a PART is an example's name or a file.
Every method gets the same facets. `robust`, `corrected` and `paper` are gpswb's modes, `curvature`
and `slippage` its methods after the paper's rivals. FreeCAD's three calls, in version 0.20.2:

- The class of a segment is what was asked for: plane, cylinder or sphere. FreeCAD asks for no other
  surface, so all other faces are lost to it. A facet in no segment is not recognised; one in
  several goes to the largest.
- Parameters are those of FreeCAD's dialogs: {DISTANCE} mm (planes and types), 0.1 /mm (curvature;
  half the curvature of the widest radius if that is less), at least {LEAST[0]} facets.
  Many faces of these meshes have fewer, so each call was made with {LEAST[1]}, too.
- `getSegmentsByCurvature` has to be told curvatures: it was told the radii of all cylinders and
  spheres of the CAD model. With noise the other two were told three times its deviation as their
  tolerance. gpswb is told neither.
""".splitlines()
"""What the figures mean, before the tables."""

TOWARD = (-0.6, 0.9, -0.6)


@dataclass(frozen=True, eq=False)
class Figures:
    """What one method made of one mesh; ``end`` is empty where it was done."""

    end: str
    area: float = 0.0
    face: float = 0.0
    f1: float = 0.0
    seconds: float = 0.0
    label: np.ndarray | None = None


def figures(solid: Solid, method: str, noise: float, limit: float) -> Figures:
    """Run one method on one mesh."""
    assert solid.facemap is not None
    try:
        if method in OWN:
            mode, kind = OWN[method]
            own = run(solid, kind, limit, mode)
            if own is None:
                return Figures("not done")
            said = own.facts
            return Figures("", said["area"], said["face"], said["f1"], said["seconds"], own.label)
        name, _, least = method.removeprefix("FreeCAD ").partition(", ")
        # Three times the noise, or no plane would be found on a noisy mesh.
        distance = max(DISTANCE, 3.0 * noise * solid.mesh.diagonal)
        found = freecad_partition(solid, CALLS[name], distance, int(least), limit)
    except ChildProcessError as error:
        print(f"  {method}: {error}", flush=True)
        return Figures("failed")
    if found is None:
        return Figures("not done")
    judged = validate(found[0], solid.facemap)
    return Figures(
        "", judged.area_accuracy or 0.0, judged.face_accuracy or 0.0, judged.region_f1, found[1],
        facet_classes(found[0]),
    )  # fmt: skip


def sections(names: Sequence[str], limit: float) -> Iterator[str]:
    """The section, after each mesh of each part: a name is that of an example, or of a file."""
    rows: dict[str, dict[str, dict[str, Figures]]] = {mesh: {} for mesh in MESHES}
    sizes: dict[str, list[int]] = {mesh: [] for mesh in MESHES}
    for name in names:
        for mesh, (vertices, noise) in MESHES.items():
            solid = _solid(name, vertices)
            if solid is None:
                break
            solid = add_noise(solid, noise) if noise else solid
            print(f"{mesh}, {name}: {len(solid.mesh.vertices)} vertices", flush=True)
            found = {method: figures(solid, method, noise, limit) for method in METHODS}
            rows[mesh][Path(name).name] = found
            sizes[mesh].append(len(solid.mesh.vertices))
            if name == SHOWN and mesh == next(iter(MESHES)):
                _picture(solid, found)
            yield "\n".join(_lines(rows, sizes, limit))


def _solid(name: str, vertices: int) -> Solid | None:
    density = f"vertices={vertices}"
    try:
        if name in PARTS:
            return part_solid(name, density)
        return read_solid(name, Density.parse(density))
    except GpswbError as error:
        print(error, flush=True)
        return None


def _picture(solid: Solid, found: dict[str, Figures]) -> None:
    shown = [m for m in METHODS if found[m].label is not None and not m.endswith(f", {LEAST[0]}")]
    labels = {method: found[method].label for method in shown}
    images = [
        (f"{method}\n{found[method].area:.3f} of the area",
         render(solid.mesh, by_class(label), TOWARD))
        for method, label in labels.items() if label is not None
    ]  # fmt: skip
    half = (len(images) + 1) // 2
    panels(
        PICTURE, [images[:half], images[half:]],
        occurring(*(label for label in labels.values() if label is not None)),
    )  # fmt: skip


def _lines(
    rows: dict[str, dict[str, dict[str, Figures]]], sizes: dict[str, list[int]], limit: float
) -> list[str]:
    lines = ["## Against other methods (the paper's Fig. 18, with numbers)", "", *HEAD, ""]
    lines += [f"A run had {limit:g} CPU seconds. What was not done then, or failed, counts as 0 in"]
    lines += ["the means; seconds are the median of those that were done.", ""]
    for mesh, parts in rows.items():
        if not parts:
            continue
        lines += [f"### {mesh[0].upper()}{mesh[1:]}", ""]
        median = int(np.median(sizes[mesh]))
        lines += [f"Parts: {len(parts)}; vertices: {median:,} (median).", ""]
        lines += ["| method | area | faces | region F1 | not done | failed | best in | CPU s |"]
        lines += ["|---|---:|---:|---:|---:|---:|---:|---:|"]
        lines += [_row(method, parts) for method in METHODS]
        lines += ["", *_ahead(parts), ""]
    lines += ["### Per part: share of the area right", ""]
    lines += ["| mesh | part |" + "".join(f" {_short(m)} |" for m in METHODS)]
    lines += ["|---|---|" + "---:|" * len(METHODS)]
    for mesh, parts in rows.items():
        for name, found in parts.items():
            cells = (f" {found[m].end or f'{found[m].area:.3f}'} |" for m in METHODS)
            lines.append(f"| {mesh} | {name} |" + "".join(cells))
    if PICTURE.exists():
        lines += ["", f"The part `{SHOWN}` at low density; grey is what was not recognised:", ""]
        lines += [f"![{SHOWN} by each method](images/{PICTURE.name})"]
    return [*lines, ""]


def _row(method: str, parts: dict[str, dict[str, Figures]]) -> str:
    own = [found[method] for found in parts.values()]
    best = sum(
        not found[method].end and found[method].area >= max(f.area for f in found.values())
        for found in parts.values()
    )
    done = [f.seconds for f in own if not f.end]
    means = (np.mean([getattr(f, what) for f in own]) for what in ("area", "face", "f1"))
    counts = (sum(f.end == end for f in own) for end in ("not done", "failed"))
    cells = [f"{mean:.4f}" for mean in means] + [str(count) for count in counts]
    cells += [str(best), f"{np.median(done):.2f}" if done else "–"]
    return f"| {_short(method)} | " + " | ".join(cells) + " |"


def _short(method: str) -> str:
    return method.replace(", ", ", ≥ ")


def _ahead(parts: dict[str, dict[str, Figures]]) -> list[str]:
    """Where another method is ahead of `robust` by more than the rounding of the table."""
    ahead = []
    for name, found in parts.items():
        own = found["robust"]
        for what, kind in ("area", "area"), ("face", "faces"), ("f1", "region F1"):
            method = max(METHODS, key=lambda m: getattr(found[m], what))
            best, mine = getattr(found[method], what), getattr(own, what)
            if best > mine + ROUNDING:
                said = own.end or f"{mine:.3f}"
                ahead.append(f"- {name}, {kind}: {_short(method)} {best:.3f}, robust {said}")
    if not ahead:
        return ["No method is ahead of `robust` on any part, by area, faces or region F1."]
    return ["Ahead of `robust`, the best one of each part:", "", *ahead]
