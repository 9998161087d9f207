# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ground truth of a face: the invariance class of its unbounded support surface (design, 6)."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from gpswb.cad.elementary import Elementary
from gpswb.cad.invariance_residuals import FITTED, Fit, fit_classes
from gpswb.cad.kernel import BrepFace
from gpswb.cad.solid import FaceTruth
from gpswb.cad.surface import outward_normals
from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray

EXACT = 1e-10
"""Residual (mean squared sine) of a surface that is exactly of a class. Analytic surfaces and exact
NURBS give 1e-15 and less, threads swept by a kernel 1e-11; another class's least seen is 5e-4."""
_RESIDUAL = 2e-3
"""No surface within tolerance of a class has a larger residual (a SolidWorks coil has 2e-3)."""
_RELATIVE, _ABSOLUTE, _RESOLUTION = 1e-4, 5e-4, 1e-5
"""Within tolerance: a deviation of at most the first fraction of the face's size, but no more than
the second in mm unless it is below the third fraction (what approximating CAD systems achieve)."""
_GAP, _TIGHT_RESIDUAL, _TIGHT_DEVIATION = 1e3, 1e-6, 3e-5
"""A class whose residual is this many times that of a less symmetric one needs the tighter limits:
a narrow ring of a cone lies on a sphere within any tolerance, but the cone fits far better."""
_COIL_GAP, _COIL_DEVIATION, _COIL_TURNS = 100.0, 3e-3, 0.5
"""A coarsely approximated helix still shows as one motion far below the next one (and far below a
turn without pitch), on a face that winds about its axis; its deviation is put down to the system
that wrote it."""
_NEARLY = 1e-5, 1e-3
"""Residual and deviation below which a complex surface is called ambiguous."""

_DIRECT: dict[str, InvarianceClass] = {
    "Plane": "planar",
    "Cylinder": "cylindrical",
    "Cone": "revolute",
    "Sphere": "spherical",
    "Torus": "revolute",
}


def face_truth(face: BrepFace) -> FaceTruth | None:
    """Truth of a face; None where it has no surface."""
    kind = face.kind
    if kind is None:
        return None
    points, normals, areas = sample(face)
    usable = len(points) > 20 and bool(np.isfinite(points).all()) and float(areas.sum()) > 0
    if face.elementary is not None:
        exact = _DIRECT[kind]
        nominal = _flattened(exact, points, normals, areas) if usable else exact
        parameters = _elementary_parameters(face.elementary)
        return FaceTruth(kind, exact, nominal, parameters, exact != nominal)
    if not usable:
        return FaceTruth(kind, "complex", "complex", {}, ambiguous=True)
    fits = fit_classes(points, normals, areas)
    size = float(np.linalg.norm(points.std(axis=0)))
    exact = next((c for c in FITTED if fits[c].residual <= EXACT), "complex")
    least = min(fit.residual for fit in fits.values())
    nominal = next((c for c in FITTED if c == exact or _within(fits[c], size, least)), "complex")
    if nominal in ("helical", "complex") and exact != "helical":
        nominal = "helical" if _stands_out(fits, nominal == "complex") else "complex"
    unsure = exact != nominal or (
        nominal == "complex"
        and any(f.residual < _NEARLY[0] and f.deviation < _NEARLY[1] for f in fits.values())
    )
    parameters = {} if nominal == "complex" else _fit_parameters(nominal, fits[nominal])
    return FaceTruth(kind, exact, nominal, parameters, unsure)


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


def _within(fit: Fit, size: float, least: float) -> bool:
    """Whether a fit lies within CAD tolerance, given the least residual of all classes."""
    allowed = max(_RESOLUTION, min(_RELATIVE, _ABSOLUTE / max(size, 1e-300)))
    residual = _RESIDUAL
    if fit.residual > _GAP * max(least, EXACT / _GAP):
        allowed, residual = min(allowed, _TIGHT_DEVIATION), _TIGHT_RESIDUAL
    return fit.residual <= residual and fit.deviation <= allowed


def _stands_out(fits: Mapping[InvarianceClass, Fit], coarse: bool) -> bool:
    """Whether one screw motion lies far below all others, so that an inexact helix is one.

    ``coarse``: it isn't even within tolerance, and must wind about its axis.
    """
    fit = fits["helical"]
    rival = min(fit.next_residual, fits["revolute"].residual, fits["prismatic"].residual)
    found = fit.residual <= _RESIDUAL and rival >= _COIL_GAP * fit.residual
    return found and (not coarse or (fit.deviation <= _COIL_DEVIATION and fit.turns >= _COIL_TURNS))


def _flattened(
    exact: InvarianceClass, points: FloatArray, normals: FloatArray, areas: FloatArray
) -> InvarianceClass:
    """Class within tolerance of an elementary surface: a sliver of a large cylinder is a plane, a
    cone of next to no angle a cylinder."""
    size = float(np.linalg.norm(points.std(axis=0)))
    simpler: tuple[InvarianceClass, ...] = ("planar",)
    if exact == "planar":
        return exact
    if exact == "revolute":
        simpler = ("planar", "cylindrical")
    fits = fit_classes(points, normals, areas, simpler)
    return next((c for c in simpler if _within(fits[c], size, 1.0)), exact)


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
