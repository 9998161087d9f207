# SPDX-License-Identifier: LGPL-2.1-or-later
"""A reference moved until the projected points are thinnest (design, section 5).

Normals place an axis only as well as the tessellation knows them; nominal vertices lie on the
surface to rounding, which this uses. Levenberg-Marquardt on how far the projected points stand off
their own profile: first a quadratic through each point's neighbours, for any profile; then, where
one polynomial follows the whole profile, that polynomial, which a short strip with scattered points
determines far better.
"""

from __future__ import annotations

import numpy as np

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray
from gpswb.core.motion_chart import MotionChart
from gpswb.core.quotient import quotient_coordinates
from gpswb.core.reference import Reference, spread
from gpswb.core.thickness import (
    CONSISTENT,
    near_profile,
    profile_offsets,
    quotient_jacobian,
    thickness,
)

_LEAST = 12  # points below which nothing is refined
_LOCAL = 6  # steps on local profiles: they stall at their own interpolation error
_GLOBAL = 20  # steps on a polynomial: a valley takes a dozen, then exact data converge at once
_SAMPLES = 1000  # points of a polynomial profile
_DEGREE = 6  # of the polynomial: strips of threads and blades need five or six
_GRAPH = 10.0  # how many times its thickness a profile may stand off a polynomial that follows it
_STALLED = 0.9  # share of the cost that a step must leave less than, or it is the last but three
_PATIENCE = 3
_HOPELESS = 0.5  # the same share where even the best linear step ends far above what is allowed
_ABOVE = 10.0  # how many times what is allowed is far above
_FAR = 1e6  # region sizes: an axis, or a lead, beyond that is none


def refine_reference(
    points: FloatArray,
    invariance_class: InvarianceClass,
    reference: Reference,
    allowed: float = 0.0,
) -> tuple[Reference, float]:
    """The reference of a class moved so that the projected points get thinner, and `thickness`.

    Args:
        points: (n, 3) mm.
        invariance_class: only prismatic, revolute and helical are refined: the other references
            are fitted by position already.
        reference: where to start; it is given back where it can't be improved.
        allowed: mm, the stand-off that counts as on the surface: where it can't be reached, the
            search ends early.
    """
    if (
        invariance_class not in ("prismatic", "revolute", "helical")
        or len(points) < _LEAST
        or not np.isfinite(reference.lead)
        or (invariance_class == "helical" and reference.lead == 0)
    ):
        return reference, thickness(points, invariance_class, reference)
    best, cost = _descend(points, invariance_class, reference, _LOCAL, allowed, local=True)
    if np.isfinite(cost):
        thin = float(np.sqrt(cost)) / CONSISTENT
    else:
        thin = thickness(points, invariance_class, best)
    few = points[spread(len(points), _SAMPLES)]
    off, _ = _polynomial_offsets(quotient_coordinates(few, invariance_class, best), None)
    if float(np.sqrt(np.mean(off**2))) <= _GRAPH * thin:
        trial, _ = _descend(few, invariance_class, best, _GLOBAL, allowed, local=False)
        thinner = thickness(points, invariance_class, trial)
        if thinner < thin:
            return trial, thinner
    return best, thin


def _descend(
    points: FloatArray,
    invariance_class: InvarianceClass,
    reference: Reference,
    iterations: int,
    allowed: float,
    local: bool,
) -> tuple[Reference, float]:
    """The reference that is reached, and its cost, mm²; infinite where there was nothing to try."""
    centre = points.mean(axis=0)
    size = max(float(np.sqrt(((points - centre) ** 2).sum(axis=1).mean())), 1e-300)
    if not _has_orbits(reference, invariance_class, centre, size):
        return reference, np.inf
    damping, idle = 1e-3, 0
    offset, change = _offsets(points, invariance_class, reference, local)
    cost = _cost(offset)
    for _ in range(iterations):
        chart = MotionChart(invariance_class, reference, centre, size)
        slope = change @ chart.derivative()
        if not np.isfinite(slope).all():
            break
        h, g = slope.T @ slope, slope.T @ offset
        scale = max(float(np.trace(h)), 1e-300)
        for _ in range(4):
            h_damped = h + (damping / len(h) + 1e-14) * scale * np.eye(len(h))
            step = np.asarray(np.linalg.solve(h_damped, -g), dtype=np.float64)
            trial = chart.moved(step)
            usable = _has_orbits(trial, invariance_class, centre, size)
            if usable:
                offset_new, change_new = _offsets(points, invariance_class, trial, local)
                usable = _cost(offset_new) < cost
            if usable:
                break
            damping *= 20.0
        if not usable:
            break
        gained = _cost(offset_new) / max(cost, 1e-300)
        # What the derivatives say is the least that could be reached.
        least = cost - float(g @ np.linalg.lstsq(h, g, rcond=1e-12)[0]) / len(offset)
        if gained > _HOPELESS and least > (_ABOVE * allowed) ** 2 > 0.0:
            return trial, _cost(offset_new)
        idle = idle + 1 if gained > _STALLED else 0
        reference, offset, change, cost = trial, offset_new, change_new, _cost(offset_new)
        damping *= 0.05
        if idle == _PATIENCE:
            break
    return reference, cost


def _has_orbits(
    reference: Reference, invariance_class: InvarianceClass, centre: FloatArray, size: float
) -> bool:
    """Whether a motion is one of its class still: a long step may end at a translation, or at a
    screw without lead."""
    numbers = np.concatenate([reference.point - centre, reference.direction, [reference.lead]])
    if not (np.isfinite(numbers).all() and np.abs(numbers).max() < _FAR * size):
        return False
    return invariance_class != "helical" or abs(reference.lead) > size / _FAR


def _cost(offset: FloatArray) -> float:
    return float(np.mean(offset**2)) if len(offset) else np.inf


def _offsets(
    points: FloatArray, invariance_class: InvarianceClass, reference: Reference, local: bool
) -> tuple[FloatArray, FloatArray]:
    """(s,) mm stand-offs and (s, p) their change with tilt, shift and lead of the axis."""
    quotient = quotient_coordinates(points, invariance_class, reference)
    jacobian = quotient_jacobian(points, invariance_class, reference)
    if not local:
        offset, change = _polynomial_offsets(quotient, jacobian)
    else:
        offset, change = profile_offsets(quotient, jacobian)
        near = near_profile(offset)
        offset, change = offset[near], change[near]
    return offset, change


def _polynomial_offsets(
    quotient: FloatArray, jacobian: FloatArray | None
) -> tuple[FloatArray, FloatArray]:
    """(n,) distances from the polynomial through the profile along its longest extent, and with the
    Jacobian (n, 2, p) of the quotient coordinates their change (n, p) once it has been fitted anew.
    """
    x = quotient - quotient.mean(axis=0)
    along, across = np.linalg.eigh(x.T @ x)[1].T[::-1]
    t = x @ along
    reach = max(float(np.abs(t).max()), 1e-300)
    basis, triangle = np.linalg.qr(np.polynomial.legendre.legvander(t / reach, _DEGREE))
    height = basis.T @ (x @ across)
    offset: FloatArray = x @ across - basis @ height
    if jacobian is None:
        return offset, np.zeros((len(offset), 0))
    coefficients = np.linalg.lstsq(triangle, height, rcond=None)[0]
    derivative = np.polynomial.legendre.legder(coefficients)
    slope = np.polynomial.legendre.legval(t / reach, derivative) / reach
    change = np.einsum("nap,a->np", jacobian, across)
    change = change - slope[:, None] * np.einsum("nap,a->np", jacobian, along)
    change = change - basis @ (basis.T @ change)
    return offset, change
