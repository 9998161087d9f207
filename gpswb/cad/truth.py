# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ground truth of a face: the invariance class of its unbounded support surface (design, 6)."""

from __future__ import annotations

import math

import numpy as np

from gpswb.cad.elementary import Elementary
from gpswb.cad.invariance_residuals import Fit, fit_classes
from gpswb.cad.kernel import BrepFace
from gpswb.cad.solid import FaceTruth
from gpswb.cad.surface import outward_normals
from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray

EXACT = 1e-10
"""Residual (mean squared sine) of a surface that is exactly of a class. Analytic surfaces and exact
NURBS give 1e-15 and less, threads swept by a kernel 1e-11; the smallest of another class is 5e-4."""
_RESIDUAL = 2e-3
_DEVIATION = 1e-4, 5e-3, 1e-5
"""Within tolerance: at most the first fraction of the face's size, but no more than the second in
mm unless it is below the third fraction (the resolution of approximating CAD systems)."""
_HELICAL_GAP = 100.0, 3e-3
"""A coarsely approximated helix still shows as one motion far below the next one: the ratio of their
residuals, and the deviation (fraction of the size) that is put down to the approximation."""

_DIRECT: dict[str, InvarianceClass] = {
    "Plane": "planar",
    "Cylinder": "cylindrical",
    "Cone": "revolute",
    "Sphere": "spherical",
    "Torus": "revolute",
}
_ORDER: tuple[InvarianceClass, ...] = (
    "planar", "spherical", "cylindrical", "prismatic", "revolute", "helical",
)  # fmt: skip
"""Most symmetric first: planar and cylindrical surfaces are prismatic, revolute and helical too."""


def face_truth(face: BrepFace) -> FaceTruth | None:
    """Truth of a face; None where it has no surface."""
    kind = face.kind
    if kind is None:
        return None
    if face.elementary is not None:
        name = _DIRECT[kind]
        return FaceTruth(kind, name, name, _elementary_parameters(face.elementary))
    points, normals, areas = sample(face)
    if not np.isfinite(points).all() or not areas.sum() > 0:
        return FaceTruth(kind, "complex", "complex", {}, ambiguous=True)
    fits = fit_classes(points, normals, areas)
    size = float(np.linalg.norm(points.std(axis=0)))
    exact = next((c for c in _ORDER if fits[c].residual <= EXACT), "complex")
    nominal = next((c for c in _ORDER if _within(fits[c], size)), "complex")
    if nominal == "complex" and _coarse_helix(fits["helical"]):
        nominal = "helical"
    parameters = {} if nominal == "complex" else _fit_parameters(nominal, fits[nominal])
    return FaceTruth(kind, exact, nominal, parameters, ambiguous=exact != nominal)


def sample(face: BrepFace, order: int = 24) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Gauss points of the trimmed face's parameter box: points (k, 3) mm, outward normals (k, 3),
    areas (k,) mm²; points without a normal are left out."""
    u0, u1, v0, v1 = face.bounds
    node, weight = np.polynomial.legendre.leggauss(order)
    node, weight = (node + 1) / 2, weight / 2
    u, v = np.meshgrid(u0 + (u1 - u0) * node, v0 + (v1 - v0) * node, indexing="ij")
    uv = np.column_stack([u.ravel(), v.ravel()])
    points, du, dv = face.derivatives(uv)
    area = np.linalg.norm(np.cross(du, dv), axis=1) * np.outer(weight, weight).ravel()
    area *= (u1 - u0) * (v1 - v0)
    normals = outward_normals(face, uv)
    good = (area > 0) & (np.abs(np.linalg.norm(normals, axis=1) - 1) < 1e-6)
    return points[good], normals[good], area[good]


def _within(fit: Fit, size: float) -> bool:
    relative, absolute, resolution = _DEVIATION
    allowed = max(resolution, min(relative, absolute / max(size, 1e-300)))
    return fit.residual <= _RESIDUAL and fit.deviation <= allowed


def _coarse_helix(fit: Fit) -> bool:
    gap, deviation = _HELICAL_GAP
    return (
        fit.residual <= _RESIDUAL
        and fit.deviation <= deviation
        and fit.next_residual >= gap * fit.residual
        and math.isfinite(fit.lead)
    )


def _elementary_parameters(surface: Elementary) -> dict[str, tuple[float, ...]]:
    out = {"point": _tuple(surface.origin)}
    if surface.kind != "Sphere":
        out["direction"] = _tuple(surface.frame[2])
    if surface.kind in ("Cylinder", "Sphere"):
        out["radius"] = (surface.radius,)
    elif surface.kind == "Cone":
        out["radius"] = (surface.radius,)
        out["half_angle_deg"] = (math.degrees(surface.extra),)
    elif surface.kind == "Torus":
        out["major_radius"] = (surface.radius,)
        out["minor_radius"] = (surface.extra,)
    return out


def _fit_parameters(name: InvarianceClass, fit: Fit) -> dict[str, tuple[float, ...]]:
    out: dict[str, tuple[float, ...]] = {}
    if name != "prismatic":
        out["point"] = _tuple(fit.point)
    if name != "spherical":
        out["direction"] = _tuple(fit.direction)
    if name in ("cylindrical", "spherical"):
        out["radius"] = (fit.radius,)
    if name == "helical":
        out["lead"] = (fit.lead,)
    return out


def _tuple(vector: FloatArray) -> tuple[float, ...]:
    return tuple(float(x) for x in vector)
