# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces fitted to many small patches at once by least squared, or robust, distance."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import FloatArray
from gpswb.core.robust.cone_chart import ConeChart
from gpswb.core.robust.first_guess import cylinder_guess, guess, torus_starts
from gpswb.core.robust.surfaces import Kind, distance, distance_jacobian
from gpswb.core.robust.torus_chart import TorusChart
from gpswb.core.robust.turns import lengths

ITERATIONS = 30
"""Levenberg-Marquardt steps at most; exact data converge quadratically in fewer than ten."""

ROUGH = 12
"""Steps that tell which of several starts ends nearest."""

STALLED = 0.98
"""Share of the cost that a step must leave less than: exact data lose orders of magnitude a step,
and whether other data end a little nearer changes nothing."""

HOPELESS = 0.5
"""The same for data that are still far from what would be enough."""

FAR = 100.0
"""How many times what would be enough is far: fits that end nearer take their time."""

PATIENCE = 4
"""Such steps in a row that end a fit: a narrow valley may take some."""

SURE = 1e-4
"""Share of what would be enough that leaves nothing to gain: the surface is fitted anew to what it
grows to."""

FIRST = 10
"""Steps in which the scale of a robust fit falls, whatever they gain."""

CHARTS: dict[Kind, type[ConeChart | TorusChart]] = {"cone": ConeChart, "torus": TorusChart}
"""Coordinates in which the surfaces of a kind that has more than its size and place are fitted."""


def fit_patches(
    kind: Kind,
    points: FloatArray,
    weights: FloatArray,
    centres: FloatArray,
    normals: FloatArray,
    robust_floor: FloatArray | float | None = None,
    enough: FloatArray | None = None,
    cylinders: FloatArray | None = None,
) -> FloatArray:
    """The surface of one kind nearest to each patch, from several starts where one won't do.

    Args:
        kind: the kind of surface.
        points: (b, n, 3) vertices of each patch, centred and scaled to about 1.
        weights: (b, n), 0 for padding.
        centres: (b, f, 3) facet centroids in the same scale.
        normals: (b, f, 3) facet normals times the square root of their weight (0 for padding).
        robust_floor, enough: see ``fit``.
        cylinders: (b, 8) the cylinders that are nearest, where they are known already.

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
        if cylinders is None:
            start = cylinder_guess(points, weights, centres, normals)
            cylinders = fit("cylinder", start, points, weights, robust_floor, iterations=FIRST)
        cones = cylinders.copy()
        cones[:, 7] = 0.0
        starts = [cones, guess("cone", points, weights, centres, normals)]
    elif kind == "cylinder":
        starts = [cylinder_guess(points, weights, centres, normals)]
    else:
        starts = [guess(kind, points, weights, centres, normals)]
    start = starts[0]
    if len(starts) > 1:
        k, b = len(starts), len(points)
        again = np.tile(np.arange(b), k)
        rough = fit(
            kind,
            np.concatenate(starts),
            points[again],
            weights[again],
            None if robust_floor is None else np.broadcast_to(robust_floor, b)[again],
            None if enough is None else enough[again],
            ROUGH,
        )
        off = np.abs(distance(kind, rough, points[again])[0])
        error = np.nan_to_num(np.einsum("bn,bn->b", weights[again], off), nan=np.inf)
        best = np.argmin(error.reshape(k, b), axis=0)
        start = rough.reshape(k, b, 8)[best, np.arange(b)]
    return fit(kind, start, points, weights, robust_floor, enough)


def fit(
    kind: Kind,
    surface: FloatArray,
    points: FloatArray,
    weights: FloatArray,
    robust_floor: FloatArray | float | None = None,
    enough: FloatArray | float | None = None,
    iterations: int = ITERATIONS,
) -> FloatArray:
    """Surfaces of least squared distance (Levenberg-Marquardt, analytic Jacobian).

    Args:
        kind: the kind of surface.
        surface: (b, 8) first guesses.
        points: (b, n, 3) with ``weights`` (b, n).
        robust_floor: None for plain least squares; otherwise points that don't belong are
            weighted down (Geman-McClure), with a scale that falls to this one, in the points' unit.
        enough: distance that counts as none, in the points' unit: fits that are far nearer, or
            won't come near, end early. 0 where only the best will do.
        iterations: steps at most.

    Returns:
        (b, 8) surfaces; the direction is a unit vector.
    """
    out = surface.copy()
    b = len(surface)
    # In memory axis by axis, as distances are computed.
    axes = np.ascontiguousarray(np.swapaxes(points, 1, 2))
    total = np.maximum(weights.sum(axis=1), 1e-12)
    middle = (axes @ weights[..., None])[..., 0] / total[:, None]
    near = np.zeros(b) if enough is None else np.broadcast_to(np.square(enough), b) * total
    robust = robust_floor is not None
    floor = np.broadcast_to(0.0 if robust_floor is None else robust_floor, b)
    hopeless = HOPELESS if enough is not None and not robust else STALLED
    damping, scale = np.full(b, 1e-5), np.full(b, np.inf)
    idle, live = np.zeros(b, dtype=np.int64), np.arange(b)
    d, rows = _distance_rows(kind, surface, axes)
    for step in range(iterations):
        w = weights
        if robust:
            median = _weighted_median(np.abs(d), weights)
            scale = np.maximum(np.minimum(2.0 * median, scale * 0.7), floor)
            w = weights * _influence(d, scale)
        cost = _cost(d, weights, scale if robust else None)
        chart = CHARTS[kind].at(surface, middle) if kind in CHARTS else None
        slope = rows if chart is None else np.swapaxes(chart.derivative(), 1, 2) @ rows
        weighted = slope * w[:, None]
        h = weighted @ np.swapaxes(slope, 1, 2)
        g = weighted @ d[..., None]
        # The gauge freedoms (a point may slide along its axis) make h singular: damping fixes them.
        diagonal = h.reshape(len(h), -1)[:, :: h.shape[1] + 1]
        size = np.maximum(diagonal.sum(axis=1), 1e-30)
        diagonal += ((damping / 8 + 1e-14) * size)[:, None]
        move = -np.asarray(np.linalg.solve(h, g)[..., 0], dtype=np.float64)
        trial: FloatArray
        if chart is None:
            trial = surface + move
            trial[:, 3:6] /= np.maximum(lengths(trial[:, 3:6]), 1e-12)[:, None]
        else:
            trial = chart.moved(move).surface
        d_new, rows_new = _distance_rows(kind, trial, axes)
        cost_new = _cost(d_new, weights, scale if robust else None)
        better = (cost_new <= cost) & np.isfinite(trial).all(axis=1)
        damping = np.where(better, damping * 0.03, damping * 10.0)
        worse = np.flatnonzero(~better)
        if len(worse):
            trial[worse], d_new[worse], rows_new[worse] = surface[worse], d[worse], rows[worse]
        surface, d, rows = trial, d_new, rows_new
        moving = (np.abs(move).max(axis=1) > 1e-13) & (damping < 1e8)
        moving &= ~better | (cost_new > SURE**2 * near)
        least = np.where(cost_new > FAR**2 * near, hopeless, STALLED)
        idle = np.where(better & (cost_new < least * cost), 0, idle + better)
        moving &= idle < PATIENCE
        if (robust and step < FIRST) or moving.all():
            continue
        out[live[~moving]] = surface[~moving]
        if not moving.any():
            return out
        live, surface, axes, weights = live[moving], surface[moving], axes[moving], weights[moving]
        middle, near, floor = middle[moving], near[moving], floor[moving]
        damping, scale, idle = damping[moving], scale[moving], idle[moving]
        d, rows = d[moving], rows[moving]
    out[live] = surface
    return out


def _distance_rows(
    kind: Kind, surface: FloatArray, axes: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """(b, n) distances of points, (b, 3, n) axis by axis, and (b, 8, n) their derivatives."""
    d, jacobian = distance_jacobian(kind, surface, np.swapaxes(axes, 1, 2))
    return d, np.swapaxes(jacobian, 1, 2)


def _influence(d: FloatArray, scale: FloatArray) -> FloatArray:
    return (1.0 / (1.0 + (d / scale[:, None]) ** 2)) ** 2


def _cost(d: FloatArray, weights: FloatArray, scale: FloatArray | None) -> FloatArray:
    square = d * d
    if scale is not None:
        square /= 1.0 + square / scale[:, None] ** 2
    cost: FloatArray = np.einsum("bn,bn->b", weights, square)
    return cost


def _weighted_median(x: FloatArray, weights: FloatArray) -> FloatArray:
    """Median of the entries of each row whose weight isn't zero; 0 for a row without any."""
    present = weights > 0
    ordered = np.sort(np.where(present, x, np.inf), axis=1)
    middle = np.maximum(present.sum(axis=1) - 1, 0) // 2
    median: FloatArray = ordered[np.arange(len(x)), middle]
    return np.where(np.isfinite(median), median, 0.0)
