# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces fitted to many small patches at once by least squared, or robust, distance."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import FloatArray
from gpswb.core.robust.first_guess import cylinder_guess, guess, torus_starts
from gpswb.core.robust.surfaces import Kind, distance_jacobian
from gpswb.core.robust.torus_chart import TorusChart

ITERATIONS = 30
"""Levenberg-Marquardt steps at most; exact data converge quadratically in fewer than ten."""

STALLED = 0.98
"""Share of the cost that a step must leave less than: exact data lose orders of magnitude a step,
and whether other data end a little nearer changes nothing."""

PATIENCE = 4
"""Such steps in a row that end a fit: a narrow valley may take some."""


def fit_patches(
    kind: Kind,
    points: FloatArray,
    weights: FloatArray,
    centres: FloatArray,
    normals: FloatArray,
    robust_floor: float | None = None,
) -> FloatArray:
    """The surface of one kind nearest to each patch, from several starts where one won't do.

    Args:
        kind: the kind of surface.
        points: (b, n, 3) vertices of each patch, centred and scaled to about 1.
        weights: (b, n), 0 for padding.
        centres: (b, f, 3) facet centroids in the same scale.
        normals: (b, f, 3) facet normals times the square root of their weight (0 for padding).
        robust_floor: see ``fit``.

    Returns:
        (b, 8) surfaces, see ``surfaces``.
    """
    if robust_floor is not None:
        # Two large facets of a plane beside a fillet would decide by their area alone.
        length = np.linalg.norm(normals, axis=2, keepdims=True)
        normals = normals / np.where(length > 0.0, length, 1.0)
    if kind == "torus":
        starts = torus_starts(points, weights, centres, normals)
    elif kind == "cone":
        # A cone's normals hardly turn on a small patch; its nearest cylinder is the safer start.
        start = cylinder_guess(points, weights, centres, normals)
        start = fit("cylinder", start, points, weights, robust_floor, iterations=10)
        starts = [start, guess("cone", points, weights, centres, normals)]
    elif kind == "cylinder":
        starts = [cylinder_guess(points, weights, centres, normals)]
    else:
        starts = [guess(kind, points, weights, centres, normals)]
    if len(starts) > 1:
        rough = [fit(kind, s, points, weights, robust_floor, iterations=12) for s in starts]
        error = [
            np.sum(weights * np.abs(distance_jacobian(kind, r, points)[0]), axis=1) for r in rough
        ]
        best = np.argmin(np.nan_to_num(np.array(error), nan=np.inf), axis=0)
        start = np.stack(rough)[best, np.arange(len(points))]
    else:
        start = starts[0]
    return fit(kind, start, points, weights, robust_floor)


def fit(
    kind: Kind,
    surface: FloatArray,
    points: FloatArray,
    weights: FloatArray,
    robust_floor: float | None = None,
    iterations: int = ITERATIONS,
) -> FloatArray:
    """Surfaces of least squared distance (Levenberg-Marquardt, analytic Jacobian).

    Args:
        kind: the kind of surface.
        surface: (b, 8) first guesses.
        points: (b, n, 3) with ``weights`` (b, n).
        robust_floor: None for plain least squares; otherwise points that don't belong are
            weighted down (Geman-McClure), with a scale that falls to this one, in the points' unit.

    Returns:
        (b, 8) surfaces; the direction is a unit vector.
    """
    surface = surface.copy()
    b = len(surface)
    damping = np.full(b, 1e-5)
    idle = np.zeros(b, dtype=np.int64)
    scale = np.full(b, np.inf)
    d, jac = distance_jacobian(kind, surface, points)
    middle = (weights[:, None] @ points)[:, 0] / np.maximum(weights.sum(axis=1), 1e-12)[:, None]
    live = np.arange(b)
    for step in range(iterations):
        if robust_floor is not None:
            median = _weighted_median(np.abs(d), weights[live])
            scale[live] = np.maximum(np.minimum(2.0 * median, scale[live] * 0.7), robust_floor)
        w = weights[live] * _influence(d, scale[live])
        cost = _cost(d, weights[live], scale[live])
        chart = TorusChart.at(surface[live], middle[live]) if kind == "torus" else None
        slope = jac if chart is None else jac @ chart.derivative()
        weighted = np.swapaxes(slope * w[..., None], 1, 2)
        h = weighted @ slope
        g = (weighted @ d[..., None])[..., 0]
        # The gauge freedoms (a point may slide along its axis) make h singular: damping fixes them.
        size = np.maximum(np.trace(h, axis1=1, axis2=2), 1e-30)
        each = range(h.shape[1])
        h[:, each, each] += damping[live, None] * size[:, None] / 8 + 1e-14 * size[:, None]
        move = -np.asarray(np.linalg.solve(h, g[..., None])[..., 0], dtype=np.float64)
        trial: FloatArray
        if chart is None:
            trial = surface[live] + move
            trial[:, 3:6] /= np.maximum(np.linalg.norm(trial[:, 3:6], axis=1), 1e-12)[:, None]
        else:
            trial = chart.moved(move).surface
        d_new, jac_new = distance_jacobian(kind, trial, points[live])
        cost_new = _cost(d_new, weights[live], scale[live])
        better = (cost_new <= cost) & np.isfinite(trial).all(axis=1)
        surface[live[better]] = trial[better]
        damping[live] = np.where(better, damping[live] * 0.03, damping[live] * 10.0)
        d = np.where(better[:, None], d_new, d)
        jac = np.where(better[:, None, None], jac_new, jac)
        moving = (np.abs(move).max(axis=1) > 1e-13) & (damping[live] < 1e8)
        idle[live] = np.where(better & (cost_new >= STALLED * cost), idle[live] + 1, 0)
        moving &= idle[live] < PATIENCE
        if robust_floor is not None and step < 10:
            moving[:] = True
        if not moving.any():
            break
        live, d, jac = live[moving], d[moving], jac[moving]
    return surface


def _influence(d: FloatArray, scale: FloatArray) -> FloatArray:
    return (1.0 / (1.0 + (d / scale[:, None]) ** 2)) ** 2


def _cost(d: FloatArray, weights: FloatArray, scale: FloatArray) -> FloatArray:
    s2 = np.minimum(scale, 1e30)[:, None] ** 2
    cost: FloatArray = np.sum(weights * d**2 / (1.0 + d**2 / s2), axis=1)
    return cost


def _weighted_median(x: FloatArray, weights: FloatArray) -> FloatArray:
    """Median of the entries of each row whose weight isn't zero; 0 for a row without any."""
    present = weights > 0
    ordered = np.sort(np.where(present, x, np.inf), axis=1)
    middle = np.maximum(present.sum(axis=1) - 1, 0) // 2
    median: FloatArray = ordered[np.arange(len(x)), middle]
    return np.where(np.isfinite(median), median, 0.0)
