# SPDX-License-Identifier: LGPL-2.1-or-later
"""Leave-one-out Gaussian kernel density, with the bandwidth that maximises its likelihood."""

from __future__ import annotations

import numpy as np
from scipy.ndimage import correlate1d
from scipy.spatial import cKDTree

from gpswb.core.mesh import FloatArray, IntArray

_STEP = 0.5
"""Grid step in bandwidths. Quadratic B-splines carry points to nodes and nodes to points; each
widens the kernel by a variance of step^2 / 4 wherever the point lies: it is narrowed by as much."""

_REACH = 5.0
"""Where kernels are cut, in bandwidths: exp(-12.5) = 4e-6."""

_FACTORS = 1.06 * 0.5 ** np.arange(8)
"""Bandwidths tried, as multiples of sigma n^(-1/(d+4)), from Silverman's down."""


def leave_one_out_log_density(points: FloatArray, floor: float) -> FloatArray:
    """log p_-j(x_j) = log((n p(x_j) - K_h(0)) / (n - 1)) at every point.

    The bandwidth of each coordinate is a common multiple of its own scatter, chosen by the
    leave-one-out likelihood itself, and never below the floor: exact data would send the likelihood
    of a class they belong to to infinity.

    Args:
        points: (n, d) with d = 1..3, n >= 2.
        floor: least bandwidth, in the unit of the points, > 0.

    Returns:
        (n,) float64 natural logarithms, per unit^d.

    Raises:
        ValueError: fewer than two points or a floor that is not positive.
    """
    if len(points) < 2 or not floor > 0.0:
        raise ValueError(f"2 points and a floor above 0 are needed, not {len(points)}, {floor}")
    n, d = points.shape
    scatter = points.std(axis=0) * n ** (-1.0 / (d + 4))
    best: FloatArray | None = None
    worse = 0
    previous = np.zeros(d)
    for factor in _FACTORS:
        bandwidth = np.maximum(factor * scatter, floor)
        if np.array_equal(bandwidth, previous):
            break
        previous = bandwidth
        trial = leave_one_out_at(points, bandwidth)
        if best is None or trial.sum() > best.sum():
            best, worse = trial, 0
        else:
            worse += 1
            if worse == 2:
                break
    assert best is not None
    return best


def leave_one_out_at(points: FloatArray, bandwidth: FloatArray) -> FloatArray:
    """The same for a given bandwidth (d,): on a grid where points are dense, else pair by pair.

    Densities below exp(-60) of a kernel's peak are raised to that, so that one stray point can't
    make the likelihood vanish.
    """
    n, d = points.shape
    unit = (points - points.min(axis=0)) / bandwidth
    # One node more than the range at either end, for the neighbours of the outermost points.
    shape = tuple(np.round(unit.max(axis=0) / _STEP).astype(np.int64) + 3)
    cells = float(np.prod(np.asarray(shape, dtype=np.float64)))
    others = _binned(unit, shape) if cells <= max(1 << 14, 64 * n) else _pairwise(unit)
    floor = np.exp(-60.0)
    density = np.maximum(others, floor) / (n - 1)
    log: FloatArray = np.log(density) - np.log(bandwidth).sum() - 0.5 * d * np.log(2.0 * np.pi)
    return log


def _binned(unit: FloatArray, shape: tuple[int, ...]) -> FloatArray:
    """Sum over the other points of exp(-r^2 / 2), on a grid; (n,)."""
    n, d = unit.shape
    variance = 1.0 - _STEP**2 / 2.0
    offset = np.arange(-int(_REACH / _STEP), int(_REACH / _STEP) + 1) * _STEP
    kernel = np.exp(-0.5 * offset**2 / variance) / np.sqrt(variance)
    position = unit / _STEP
    node = np.round(position).astype(np.int64) + 1
    share = position - (node - 1)
    # (3, n, d) weights of the node below, at and above each point.
    weights = np.stack([0.5 * (0.5 - share) ** 2, 0.75 - share**2, 0.5 * (0.5 + share) ** 2])
    stride = np.ones(d, dtype=np.int64)
    for axis in range(d - 2, -1, -1):
        stride[axis] = stride[axis + 1] * shape[axis + 1]
    around: list[tuple[IntArray, FloatArray]] = []
    for corner in np.ndindex(*(3,) * d):
        weight = np.ones(n)
        for axis, k in enumerate(corner):
            weight = weight * weights[k, :, axis]
        around.append(((node + np.array(corner) - 1) @ stride, weight))
    size = int(np.prod(np.asarray(shape)))
    grid = np.zeros(size)
    for index, weight in around:
        grid += np.bincount(index, weights=weight, minlength=size)
    smooth = grid.reshape(shape)
    for axis in range(d):
        smooth = correlate1d(smooth, kernel, axis=axis, mode="constant")
    flat = smooth.ravel()
    total = np.zeros(n)
    for index, weight in around:
        total += weight * flat[index]
    # What each point found of itself, exactly: its own three weights meet at 0, 1 and 2 steps.
    low, middle, high = weights
    peak, one, two = kernel[len(kernel) // 2 :][:3]
    own = np.prod(
        (low**2 + middle**2 + high**2) * peak
        + 2.0 * middle * (low + high) * one
        + 2.0 * low * high * two,
        axis=1,
    )
    others: FloatArray = total - own
    return others


def _pairwise(unit: FloatArray) -> FloatArray:
    """Sum over the other points of exp(-r^2 / 2) for points that are sparse; (n,).

    Points that coincide to a fiftieth of a bandwidth are taken together, or the regular rings of a
    structured mesh would give n^2 pairs.
    """
    _, first, inverse, count = np.unique(
        np.round(unit * 50.0).astype(np.int64),
        axis=0,
        return_index=True,
        return_inverse=True,
        return_counts=True,
    )
    tree = cKDTree(unit[first])
    pairs = tree.query_pairs(_REACH, output_type="ndarray")
    square = ((unit[first[pairs[:, 0]]] - unit[first[pairs[:, 1]]]) ** 2).sum(axis=1)
    value = np.exp(-0.5 * square)
    total: FloatArray = count.astype(np.float64) - 1.0
    for a, b in ((0, 1), (1, 0)):
        weight = value * count[pairs[:, b]]
        total = total + np.bincount(pairs[:, a], weights=weight, minlength=len(count))
    others: FloatArray = total[inverse.ravel()]
    return others
