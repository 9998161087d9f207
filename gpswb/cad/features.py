# SPDX-License-Identifier: LGPL-2.1-or-later
"""Unite adjacent faces on the same surface to maximal integral features (design, section 6)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from gpswb.cad.kernel import BrepFace, Shape
from gpswb.cad.solid import FaceTruth
from gpswb.cad.truth import sample
from gpswb.core.mesh import FloatArray, IntArray

_DISTANCE = 1e-5
"""Two faces lie on one surface when one's points are within this fraction of the part's diagonal
(but at most 5e-3 mm, at least 1e-6 mm) of the other's surface."""
_SINE = 1e-3
"""... and its normals within this angle, rad."""
_OVERLAP = 0.8
"""Share of a section's points that must have a partner on the other face's section."""


def maximal_features(shape: Shape, truths: Sequence[FaceTruth | None]) -> IntArray:
    """(f,) feature of each face: faces with the same number share an edge and a surface.

    Planes, cylinders and spheres are compared as surfaces; cones and tori of equal kind by their
    parameters; other revolute, prismatic and helical faces unite when both the motion and the
    section that it sweeps are the same (a shape of revolution cut along its meridians).
    """
    count = len(shape.faces)
    pairs = [
        (i, j)
        for i, j in _adjacent(shape.faces)
        if _same_surface(shape, i, j, truths[i], truths[j])
    ]
    rows = np.array(pairs, dtype=np.int64).reshape(-1, 2)
    graph = coo_matrix((np.ones(len(rows)), (rows[:, 0], rows[:, 1])), shape=(count, count))
    labels: IntArray = connected_components(graph, directed=False)[1].astype(np.int64)
    return labels


def _adjacent(faces: Sequence[BrepFace]) -> list[tuple[int, int]]:
    of_edge: dict[int, list[int]] = {}
    for i, face in enumerate(faces):
        for edge in face.edges:
            of_edge.setdefault(edge, []).append(i)
    pairs = {
        (i, j) for group in of_edge.values() for a, i in enumerate(group) for j in group[a + 1 :]
    }
    return sorted(pairs)


def _same_surface(
    shape: Shape, i: int, j: int, first: FaceTruth | None, second: FaceTruth | None
) -> bool:
    if first is None or second is None or first.nominal != second.nominal:
        return False
    if first.nominal == "complex":
        return False
    tolerance = float(np.clip(_DISTANCE * shape.diagonal, 1e-6, 5e-3))
    a, b = shape.faces[i], shape.faces[j]
    if a.elementary is not None and a.kind == b.kind:
        return _on_elementary(a, b, tolerance) and _on_elementary(b, a, tolerance)
    p, n, _ = sample(b, order=5)
    if first.nominal in ("planar", "cylindrical", "spherical"):
        return _on_fit(first, p, n, tolerance)
    q, _, _ = sample(a, order=16)
    return _same_sweep(first, q, p, tolerance)


def _on_elementary(face: BrepFace, other: BrepFace, tolerance: float) -> bool:
    """Whether sample points of the other face, and their normals, lie on the face's surface."""
    surface = face.elementary
    assert surface is not None
    p, n, _ = sample(other, order=5)
    local = (p - surface.origin) @ surface.frame.T
    turned = n @ surface.frame.T
    rho = np.hypot(local[:, 0], local[:, 1])
    radial = np.column_stack([local[:, :2] / np.maximum(rho, 1e-300)[:, None], 0 * rho])
    axial = np.broadcast_to([0.0, 0.0, 1.0], local.shape)
    if surface.kind == "Plane":
        gap, expected = local[:, 2], axial
    elif surface.kind == "Cylinder":
        gap, expected = rho - surface.radius, radial
    elif surface.kind == "Sphere":
        arm = np.linalg.norm(local, axis=1)
        gap, expected = arm - surface.radius, local / np.maximum(arm, 1e-300)[:, None]
    elif surface.kind == "Cone":
        c, s = np.cos(surface.extra), np.sin(surface.extra)
        nappe = np.sign(surface.radius + local[:, 2] * s / c)
        gap = (rho * nappe - surface.radius) * c - local[:, 2] * s
        expected = radial * (c * nappe)[:, None] - axial * s
    else:
        # A tube wider than its ring passes the axis: there it is the tube of the other side.
        sides = [
            np.column_stack([rho - side, local[:, 2]]) for side in (surface.radius, -surface.radius)
        ]
        gaps = [np.linalg.norm(side, axis=1) - surface.extra for side in sides]
        near = np.abs(gaps[0]) <= np.abs(gaps[1])
        arm = np.where(near[:, None], sides[0], sides[1])
        length = np.linalg.norm(arm, axis=1)
        gap = length - surface.extra
        unit = arm / np.maximum(length, 1e-300)[:, None]
        expected = radial * unit[:, :1] + axial * unit[:, 1:]
    sine = np.linalg.norm(np.cross(turned, expected), axis=1)
    return bool(np.abs(gap).max() <= tolerance and sine.max() <= _SINE)


def _on_fit(truth: FaceTruth, p: FloatArray, n: FloatArray, tolerance: float) -> bool:
    arm = p - np.array(truth.parameters["point"])
    if truth.nominal == "spherical":
        gap = np.linalg.norm(arm, axis=1) - truth.parameters["radius"][0]
        return bool(np.abs(gap).max() <= tolerance)
    d = np.array(truth.parameters["direction"])
    if truth.nominal == "planar":
        return bool(
            np.abs(arm @ d).max() <= tolerance
            and np.linalg.norm(np.cross(n, d), axis=1).max() <= _SINE
        )
    if "radius" not in truth.parameters or "half_angle_deg" in truth.parameters:
        return False
    gap = np.linalg.norm(np.cross(arm, d), axis=1) - truth.parameters["radius"][0]
    return bool(np.abs(gap).max() <= tolerance and np.abs(n @ d).max() <= _SINE)


def _same_sweep(truth: FaceTruth, q: FloatArray, p: FloatArray, tolerance: float) -> bool:
    """Whether the points p, carried back by the motion of q's face, fall on its section."""
    d = np.array(truth.parameters["direction"])
    origin = np.array(truth.parameters.get("point", (0.0, 0.0, 0.0)))
    lead = truth.parameters.get("lead", (0.0,))[0]
    first, second = (_section(x - origin, d, truth.nominal, lead) for x in (q, p))
    span = float(np.linalg.norm(np.ptp(first, axis=0)))
    # Points that the motion carries into each other fall together: one of them is enough.
    _, one = np.unique(np.round(first / (1e-3 * span)), axis=0, return_index=True)
    first = first[one]
    tree = cKDTree(first)
    distance, at = tree.query(second)
    # Close in the sense of the section's own sampling: it must not run on beyond the other's end.
    close = distance <= max(tolerance, span / 16)
    near = tree.query(first[at], k=3)[1]
    chord = first[near[:, 2]] - first[near[:, 1]]
    step = second - first[at]
    size = np.maximum(np.linalg.norm(chord, axis=1), 1e-300)
    off = np.abs(chord[:, 0] * step[:, 1] - chord[:, 1] * step[:, 0]) / size
    curvature_slack = (span / 16) ** 2 / max(span, 1e-300)
    return bool((close & (off <= tolerance + curvature_slack)).mean() >= _OVERLAP)


def _section(arm: FloatArray, d: FloatArray, name: str, lead: float) -> FloatArray:
    helper = np.eye(3)[int(np.abs(d).argmin())]
    x = np.cross(d, helper)
    x /= np.linalg.norm(x)
    y = np.cross(d, x)
    u, v, z = arm @ x, arm @ y, arm @ d
    if name == "prismatic":
        return np.column_stack([u, v])
    if name == "helical":
        height = z - lead * np.arctan2(v, u) / (2 * np.pi)
        z = height - lead * np.floor(height / lead)
    return np.column_stack([np.hypot(u, v), z])
