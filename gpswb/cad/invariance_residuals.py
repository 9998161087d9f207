# SPDX-License-Identifier: LGPL-2.1-or-later
"""Residual of a smooth surface against each invariance class, from exact points and normals.

Design, sections 5 and 6: the mean squared sine between normal and velocity, in the best frame of
the class, 0 for a surface that the class's motions leave in place. Independent of pose and unit.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.linalg import eigh
from scipy.optimize import minimize_scalar
from scipy.spatial import cKDTree

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray


@dataclass(frozen=True, eq=False)
class Fit:
    """Best motion group of one class: its residual, axis and thickness.

    ``deviation`` is the distance, as a fraction of the surface's size, of the points from
    one surface of the class: what is left after the group's motions are divided out.
    ``next_residual`` (helical only) is that of the second best motion, ``turns`` how far the points
    wind about the axis.
    """

    residual: float
    deviation: float
    point: FloatArray
    direction: FloatArray
    lead: float = 0.0
    radius: float = 0.0
    next_residual: float = 0.0
    turns: float = 0.0


FITTED: tuple[InvarianceClass, ...] = (
    "planar", "spherical", "cylindrical", "prismatic", "revolute", "helical",
)  # fmt: skip
"""Most symmetric first: planar and cylindrical surfaces are prismatic, revolute and helical too."""


def fit_classes(
    points: FloatArray,
    normals: FloatArray,
    weights: FloatArray,
    classes: Sequence[InvarianceClass] = FITTED,
) -> dict[InvarianceClass, Fit]:
    """Fit the classes asked for (any but complex).

    Args:
        points: (k, 3) mm, exact points.
        normals: (k, 3) exact unit normals.
        weights: (k,) area of each point, positive.
        classes: which.
    """
    w = weights / weights.sum()
    centre = w @ points
    size = float(np.sqrt(w @ ((points - centre) ** 2).sum(axis=1)))
    p = (points - centre) / size
    fits = {name: _FITTERS[name](p, normals, w) for name in classes}
    return {
        name: replace(f, point=centre + size * f.point, lead=size * f.lead, radius=size * f.radius)
        for name, f in fits.items()
    }


def _planar(p: FloatArray, n: FloatArray, w: FloatArray) -> Fit:
    d = np.linalg.eigh((n * w[:, None]).T @ n)[1][:, 2]
    # From the vectors themselves: 1 - eigenvalue would end at rounding, 1e-16.
    residual = 0.5 * float(w @ (np.cross(n, d) ** 2).sum(axis=1))
    height = p @ d
    return Fit(residual, float(np.ptp(height)), (w @ height) * d, d)


def _spherical(p: FloatArray, n: FloatArray, w: FloatArray) -> Fit:
    project = np.eye(3) - n[:, :, None] * n[:, None, :]
    matrix = np.einsum("i,ijk->jk", w, project)
    right = np.einsum("i,ijk,ik->j", w, project, p)
    centre = np.linalg.lstsq(matrix, right, rcond=1e-12)[0]
    arm = p - centre
    radius = np.linalg.norm(arm, axis=1)
    sine = np.linalg.norm(np.cross(n, arm), axis=1) / np.maximum(radius, 1e-300)
    mean = float(w @ radius)
    deviation = float(np.abs(radius - mean).max())
    return Fit(0.5 * float(w @ sine**2), deviation, centre, np.array([0.0, 0.0, 1.0]), 0.0, mean)


def _cylindrical(p: FloatArray, n: FloatArray, w: FloatArray) -> Fit:
    d = np.linalg.eigh((n * w[:, None]).T @ n)[1][:, 0]
    x, y = _across(d)
    n2, p2 = np.column_stack([n @ x, n @ y]), np.column_stack([p @ x, p @ y])
    # Every normal passes through the axis: cross(n, p - q) = 0, linear in q.
    rows = np.column_stack([n2[:, 1], -n2[:, 0]])
    right = (rows * p2).sum(axis=1)
    root = np.sqrt(w)
    q = np.linalg.lstsq(rows * root[:, None], right * root, rcond=1e-12)[0]
    arm = p2 - q
    radius = np.linalg.norm(arm, axis=1)
    sine = (n2[:, 0] * arm[:, 1] - n2[:, 1] * arm[:, 0]) / np.maximum(radius, 1e-300)
    residual = 0.5 * float(w @ (sine**2 + (n @ d) ** 2))
    mean = float(w @ radius)
    deviation = float(np.abs(radius - mean).max())
    return Fit(residual, deviation, q[0] * x + q[1] * y, d, 0.0, mean)


def _prismatic(p: FloatArray, n: FloatArray, w: FloatArray) -> Fit:
    d = np.linalg.eigh((n * w[:, None]).T @ n)[1][:, 0]
    x, y = _across(d)
    section = np.column_stack([p @ x, p @ y])
    normal = np.column_stack([n @ x, n @ y])
    return Fit(float(w @ (n @ d) ** 2), _thickness(section, normal), np.zeros(3), d)


def _motion_matrices(p: FloatArray, n: FloatArray, w: FloatArray) -> tuple[FloatArray, FloatArray]:
    """M and V of ``M x = mu V x`` for screws x = (omega, t): mean squared sine of the velocity."""
    a = np.hstack([np.cross(p, n), n])
    m = (a * w[:, None]).T @ a
    v = np.zeros((6, 6))
    square = (p * w[:, None]).T @ p
    v[:3, :3] = np.trace(square) * np.eye(3) - square
    mean = w @ p
    skew = np.array([[0, -mean[2], mean[1]], [mean[2], 0, -mean[0]], [-mean[1], mean[0], 0]])
    v[:3, 3:], v[3:, :3] = skew, skew.T
    v[3:, 3:] = np.eye(3) * w.sum()
    return m, v


def _helical(p: FloatArray, n: FloatArray, w: FloatArray) -> Fit:
    m, v = _motion_matrices(p, n, w)
    values, vectors = eigh(m, v)
    # Of the null motions a turn is wanted: a mixture of two translations is no helix.
    screw = vectors[:, 0]
    if np.linalg.norm(screw[:3]) < 1e-6 * np.linalg.norm(screw):
        screw = vectors[:, 1]
    return replace(_screw_fit(p, n, w, screw), next_residual=float(values[1]))


def _revolute(p: FloatArray, n: FloatArray, w: FloatArray) -> Fit:
    """Least residual over screws without pitch (omega . t = 0).

    The Lagrange condition of the constraint is the same eigenproblem with M replaced by M + s K,
    K the pitch form; s is found by a bounded search over both signs.
    """
    m, v = _motion_matrices(p, n, w)
    k = np.zeros((6, 6))
    k[:3, 3:] = k[3:, :3] = 0.5 * np.eye(3)

    # Dual function: max over s of the smallest eigenvalue of (M + s K, V), concave in s.
    def dual(s: float) -> float:
        return -float(eigh(m + s * k, v, eigvals_only=True, subset_by_index=[0, 0])[0])

    best = minimize_scalar(dual, bounds=(-4.0, 4.0), method="bounded", options={"xatol": 1e-13})
    _, vectors = eigh(m + best.x * k, v)
    fits = [_screw_fit(p, n, w, _without_pitch(x)) for x in vectors.T[:3]]
    return min(fits, key=lambda f: f.residual)


def _without_pitch(screw: FloatArray) -> FloatArray:
    omega, t = screw[:3], screw[3:]
    square = float(omega @ omega)
    if square < 1e-12:
        return screw
    return np.concatenate([omega, t - (omega @ t) / square * omega])


def _screw_fit(p: FloatArray, n: FloatArray, w: FloatArray, screw: FloatArray) -> Fit:
    omega, t = screw[:3], screw[3:]
    turn = float(np.linalg.norm(omega))
    if turn < 1e-9 * float(np.linalg.norm(screw)):
        return Fit(np.inf, np.inf, np.zeros(3), np.array([0.0, 0.0, 1.0]))
    velocity = np.cross(omega, p) + t
    speed = w @ (velocity**2).sum(axis=1)
    residual = float(w @ (velocity * n).sum(axis=1) ** 2 / speed)
    d = omega / turn
    point: FloatArray = (np.cross(omega, t) / turn**2).astype(np.float64)
    pitch = float(omega @ t) / turn**2
    x, y = _across(d)
    arm = p - point
    u, s, z = arm @ x, arm @ y, arm @ d
    rho, phi = np.hypot(u, s), np.arctan2(s, u)
    normal = np.column_stack([(n @ x * u + n @ y * s) / np.maximum(rho, 1e-12), n @ d])
    height, turns = z, 0.0
    if abs(pitch) > 1e-12:
        # Divide the turn out by carrying every point back along its helix to the half plane.
        lead = 2 * np.pi * pitch
        height = z - pitch * phi
        height = height - lead * np.floor(height / lead)
        turns = float(np.ptp(z)) / abs(lead)
    section = np.column_stack([rho, height])
    return Fit(residual, _thickness(section, normal), point, d, 2 * np.pi * pitch, turns=turns)


def _thickness(section: FloatArray, normal: FloatArray) -> float:
    """Distance of the points of a plane section from their neighbours' common curve: the largest
    but for one in twenty, which the section's ends and corners may spoil.

    Each pair of close points gives the distance that one has from the osculating parabola of the
    other, (n_i + n_j)/2 . (p_j - p_i): exact to third order on a smooth curve.
    """
    size = np.linalg.norm(normal, axis=1)
    unit = normal / np.maximum(size, 1e-12)[:, None]
    near = cKDTree(section).query(section, k=min(6, len(section)))[1][:, 1:]
    step = section[near] - section[:, None]
    pair = unit[near] + unit[:, None]
    same = (unit[near] * unit[:, None]).sum(axis=2) > 0.5
    length = np.linalg.norm(pair, axis=2)
    gap = np.abs((step * pair).sum(axis=2)) / np.maximum(length, 1e-12)
    return float(np.quantile(np.where(same, gap, 0.0).max(axis=1), 0.95))


_FITTERS: dict[InvarianceClass, Callable[[FloatArray, FloatArray, FloatArray], Fit]] = {
    "planar": _planar,
    "spherical": _spherical,
    "cylindrical": _cylindrical,
    "prismatic": _prismatic,
    "revolute": _revolute,
    "helical": _helical,
}


def _across(d: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Two unit vectors that make a right-handed frame with d."""
    helper = np.eye(3)[int(np.abs(d).argmin())]
    x = np.cross(d, helper)
    unit: FloatArray = x / np.linalg.norm(x)
    other: FloatArray = np.cross(d, unit).astype(np.float64)
    return unit, other
