# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which nodes of a face's triangulation lie on which B-rep edge.

FreeCAD doesn't hand out OCCT's polygons on triangulations; the nodes' parameters lie on the edges'
curves in parameter space to rounding, which tells the same.
"""

from __future__ import annotations

import math
from typing import Any, Protocol

import FreeCAD
import numpy as np
import Part
from scipy.optimize import minimize_scalar

from gpswb.cad.kernel import Rim
from gpswb.core.mesh import FloatArray, IntArray

_SAMPLES = 65
_ON = 1e-6
"""Distance from the curve, as a fraction of the face's parameter box, of a node that lies on it."""


class _Face(Protocol):
    @property
    def bounds(self) -> tuple[float, float, float, float]: ...
    @property
    def curves(self) -> dict[tuple[int, int], tuple[Any, float, float]]: ...
    def degenerate(self, edge: int) -> bool: ...
    def derivatives(self, uv: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]: ...


def find_rims(face: _Face, uv: FloatArray, triangles: IntArray) -> tuple[Rim, ...]:
    """Rims of a face whose nodes have the parameters ``uv`` (k, 2)."""
    border_sides = _border_sides(triangles)
    border = np.unique(border_sides)
    joined = {tuple(side) for side in border_sides.tolist()}
    points = face.derivatives(uv)[0]
    u0, u1, v0, v1 = face.bounds
    extent = np.array([u1 - u0, v1 - v0])
    # The parameters are exact to rounding of the larger: a sliver's own width is no measure.
    extent = np.maximum(extent, max(1e-3 * float(extent.max()), 1e-12))
    rims = []
    for (edge, side), (curve, first, last) in face.curves.items():
        degenerate = face.degenerate(edge)
        # At a pole triangles lose their side: look at all nodes there.
        candidates = np.arange(len(uv)) if degenerate else border
        near = candidates[_near(curve, first, last, uv[candidates], extent)]
        nodes, parameters = _on_curve(curve, first, last, uv, near, extent)
        if not degenerate:
            ends = [(t, face.derivatives(_uv(curve, t))[0][0]) for t in (first, last)]
            nodes, parameters = _with_ends(nodes, parameters, ends, points, border, joined)
        if len(nodes) >= 2:
            rims.append(Rim(edge, side, nodes, parameters, degenerate))
    return tuple(rims)


def _border_sides(triangles: IntArray) -> IntArray:
    """(b, 2) sides of one triangle only, lower node first."""
    ends = np.sort(np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2))
    pairs, count = np.unique(ends, axis=0, return_counts=True)
    single: IntArray = pairs[count == 1]
    return single


def _uv(curve: Any, t: float) -> FloatArray:
    p = curve.value(t)
    return np.array([(p.x, p.y)])


def _with_ends(
    nodes: IntArray,
    parameters: FloatArray,
    ends: list[tuple[float, FloatArray]],
    points: FloatArray,
    border: IntArray,
    joined: set[tuple[int, int]],
) -> tuple[IntArray, FloatArray]:
    """Add the nodes of the edge's vertices where they are missing.

    BRepMesh gives a vertex one node; within the vertex's tolerance it may lie off the curve. It is
    the border node nearest to the curve's end that a border side joins to the rest of the rim.
    """
    chain, values = nodes.tolist(), parameters.tolist()
    slack = 1e-9 * (1 + abs(ends[1][0] - ends[0][0]))
    for i, (t, end) in enumerate(ends):
        if values and abs(values[-i] - t) <= slack:
            continue
        candidate = int(border[np.linalg.norm(points[border] - end, axis=1).argmin()])
        if not chain or tuple(sorted((candidate, chain[-i]))) in joined:
            chain.insert(len(chain) * i, candidate)
            values.insert(len(values) * i, t)
    if len(chain) == 2 and tuple(sorted(chain)) not in joined:
        chain, values = [], []
    return np.array(chain, dtype=np.int64), np.array(values, dtype=np.float64)


def _near(curve: Any, first: float, last: float, uv: FloatArray, extent: FloatArray) -> np.ndarray:
    """Nodes within reach of the sampled curve: projecting all of them exactly would be slow."""
    points = [curve.value(t) for t in np.linspace(first, last, _SAMPLES).tolist()]
    line = np.array([(p.x, p.y) for p in points]) / extent
    q = uv / extent
    step = np.diff(line, axis=0)
    length = np.maximum((step**2).sum(axis=1), 1e-300)
    t = np.clip(((q[:, None] - line[None, :-1]) * step).sum(axis=2) / length, 0, 1)
    gap = np.linalg.norm(q[:, None] - (line[None, :-1] + t[..., None] * step), axis=2).min(axis=1)
    reach = 0.25 * np.sqrt(length).max() + 1e-9
    return np.asarray(gap <= reach)


def _on_curve(
    curve: Any, first: float, last: float, uv: FloatArray, nodes: IntArray, extent: FloatArray
) -> tuple[IntArray, FloatArray]:
    """The nodes that lie on the curve, in order of their parameter."""
    found, parameters = [], []
    slack = 1e-7 * (last - first)
    ends = [(t, curve.value(t)) for t in (first, last)]
    for node in nodes.tolist():
        x, y = uv[node].tolist()
        # A closed curve starts and ends in one node: it counts twice.
        hits = [t for t, p in ends if _gap(p, x, y, extent) < 1e-9]
        if not hits:
            for search in (_projected, _searched):
                t = search(curve, first, last, x, y)
                inside = t is not None and first - slack <= t <= last + slack
                if t is not None and inside and _gap(curve.value(t), x, y, extent) < _ON:
                    hits = [t]
                    break
        found += [node] * len(hits)
        parameters += hits
    order = np.argsort(parameters, kind="stable")
    return np.array(found, dtype=np.int64)[order], np.array(parameters, dtype=np.float64)[order]


def _gap(p: Any, x: float, y: float, extent: FloatArray) -> float:
    return float(max(abs(p.x - x) / float(extent[0]), abs(p.y - y) / float(extent[1])))


def _projected(curve: Any, first: float, last: float, x: float, y: float) -> float | None:
    """The kernel's projection; None where it finds no foot."""
    try:
        t = float(curve.parameter(FreeCAD.Base.Vector2d(x, y)))
    except (Part.OCCError, RuntimeError):
        return None
    # A periodic curve gives the parameter of its first turn.
    period = 2 * math.pi
    if t < first - 1e-9 and t + period <= last + 1e-9:
        t += period
    elif t > last + 1e-9 and t - period >= first - 1e-9:
        t -= period
    return t


def _searched(curve: Any, first: float, last: float, x: float, y: float) -> float:
    """Least distance near the nearest sample: the kernel may give a far foot instead."""

    def distance(t: float) -> float:
        p = curve.value(t)
        return float((p.x - x) ** 2 + (p.y - y) ** 2)

    samples = np.linspace(first, last, _SAMPLES)
    i = int(np.argmin([distance(t) for t in samples.tolist()]))
    low, high = samples[max(i - 1, 0)], samples[min(i + 1, _SAMPLES - 1)]
    best = minimize_scalar(distance, bounds=(low, high), method="bounded", options={"xatol": 1e-14})
    return float(best.x)
