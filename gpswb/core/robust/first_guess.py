# SPDX-License-Identifier: LGPL-2.1-or-later
"""First guesses of surfaces through many patches at once, from normals and from second order."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import FloatArray
from gpswb.core.robust.surfaces import Kind, distance

AXIS_ANGLES = np.radians([-75.0, -60.0, -45.0, -30.0, -15.0, 0.0, 15.0, 30.0, 45.0, 60.0, 75.0])
"""Angles between a torus's axis and the plane of its patch that are compared as first guesses."""


def cylinder_guess(
    points: FloatArray, weights: FloatArray, centres: FloatArray, normals: FloatArray
) -> FloatArray:
    """(b, 8) cylinders from normals, or about the longest extent where that is nearer.

    The normals of a narrow strip along a fillet hardly turn, but the strip itself shows the axis.
    """
    of_normals = guess("cylinder", points, weights, centres, normals)
    total = np.maximum(weights.sum(axis=1), 1e-12)
    mean = (weights[:, None] @ points)[:, 0] / total[:, None]
    x = (points - mean[:, None]) * np.sqrt(weights)[..., None]
    e1, e2, axis = np.moveaxis(np.linalg.eigh(np.swapaxes(x, 1, 2) @ x)[1], 2, 0)
    x = points - mean[:, None]
    p, q = (np.einsum("bnk,bk->bn", x, e) for e in (e1, e2))
    p0, q0, radius = _algebraic_circle(p, q, weights)
    along = np.zeros_like(of_normals)
    along[:, :3] = mean + p0[:, None] * e1 + q0[:, None] * e2
    along[:, 3:6], along[:, 6] = axis, radius
    error = [
        np.sum(weights * np.abs(distance("cylinder", trial, points)[0]), axis=1)
        for trial in (of_normals, along)
    ]
    nearer = np.nan_to_num(error[1], nan=np.inf) < np.nan_to_num(error[0], nan=np.inf)
    return np.where(nearer[:, None], along, of_normals)


def torus_starts(
    points: FloatArray, weights: FloatArray, centres: FloatArray, normals: FloatArray
) -> list[FloatArray]:
    """Tori that agree with each patch's curvatures, and one from its slippage.

    Second order fixes the tube's radius and leaves one angle of the axis free: that whose torus
    is nearest to the patch is taken, for either principal direction as the meridian.
    """
    axis, through = _rotation_axis(centres, normals)
    starts = [_torus_about(axis, through, points, weights)]
    n = normals.sum(axis=1)
    n /= np.maximum(np.linalg.norm(n, axis=1), 1e-12)[:, None]
    e1 = np.cross(n, np.where(np.abs(n[:, :1]) < 0.7, [[1.0, 0, 0]], [[0, 1.0, 0]]))
    e1 /= np.linalg.norm(e1, axis=1)[:, None]
    e2 = np.cross(n, e1)
    total = np.maximum(weights.sum(axis=1), 1e-12)
    mean = np.einsum("bn,bnk->bk", weights, points) / total[:, None]
    x = points - mean[:, None]
    p, q, h = (np.einsum("bnk,bk->bn", x, e) for e in (e1, e2, n))
    rows = np.stack([p * p / 2, p * q, q * q / 2, p, q, np.ones_like(p)], axis=2)
    weighted = np.swapaxes(rows * weights[..., None], 1, 2)
    a = weighted @ rows
    a[:, range(6), range(6)] += 1e-10 * np.trace(a, axis1=1, axis2=2)[:, None]
    c = np.linalg.solve(a, weighted @ h[..., None])[..., 0]
    value, vector = np.linalg.eigh(np.stack([c[:, [0, 1]], c[:, [1, 2]]], axis=1))
    value = np.where(np.abs(value) < 1e-3, np.where(value < 0, -1e-3, 1e-3), value)
    # The mean lies inside the bend: what agrees to second order is the patch below it.
    foot = mean + c[:, 5, None] * n
    n = n - c[:, 3, None] * e1 - c[:, 4, None] * e2
    n /= np.linalg.norm(n, axis=1)[:, None]
    number = np.arange(len(points))
    for which in (0, 1):
        along = vector[:, 0, which, None] * e1 + vector[:, 1, which, None] * e2
        tube_centre = foot + n / value[:, which, None]
        # The axis passes the normal line at the centre of the parallel's normal curvature.
        offset = n * (1.0 / value[:, 1 - which] - 1.0 / value[:, which])[:, None]
        tried = np.zeros((len(AXIS_ANGLES), len(points), 8))
        error = np.zeros(tried.shape[:2])
        for i, angle in enumerate(AXIS_ANGLES):
            u = np.cos(angle) * along + np.sin(angle) * n
            radial = offset - np.einsum("bk,bk->b", offset, u)[:, None] * u
            tried[i, :, :3] = tube_centre + radial
            tried[i, :, 3:6] = u
            tried[i, :, 6] = np.linalg.norm(radial, axis=1)
            tried[i, :, 7] = 1.0 / np.abs(value[:, which])
            d, _ = distance("torus", tried[i], points)
            error[i] = np.sum(weights * np.abs(d), axis=1)
        best = np.argmin(np.nan_to_num(error, nan=np.inf), axis=0)
        starts.append(tried[best, number])
    return starts


def guess(
    kind: Kind, points: FloatArray, weights: FloatArray, centres: FloatArray, normals: FloatArray
) -> FloatArray:
    """(b, 8) surfaces of one kind guessed from normals; arguments as in ``fit_patches``."""
    b = len(points)
    surface = np.zeros((b, 8))
    total = np.maximum(weights.sum(axis=1), 1e-12)
    mean = np.einsum("bn,bnk->bk", weights, points) / total[:, None]
    if kind == "plane":
        x = (points - mean[:, None]) * np.sqrt(weights)[..., None]
        surface[:, :3] = mean
        surface[:, 3:6] = np.linalg.eigh(np.einsum("bni,bnj->bij", x, x))[1][:, :, 0]
        return surface
    if kind == "sphere":
        surface[:, :3], surface[:, 6] = _algebraic_sphere(points, weights, mean)
        return surface
    facet_weight = np.einsum("bfk,bfk->bf", normals, normals)
    moment = np.einsum("bfi,bfj->bij", normals, normals)
    if kind == "cone":
        # The normals of a cone make one angle with its axis: remove their mean.
        s = np.einsum("bf,bfk->bk", np.sqrt(facet_weight), normals)
        w = np.maximum(facet_weight.sum(axis=1), 1e-12)
        moment = moment - np.einsum("bi,bj->bij", s, s) / w[:, None, None]
    axis = np.linalg.eigh(moment)[1][:, :, 0]
    through = _meeting_point(centres, normals, axis)
    surface[:, 3:6] = axis
    surface[:, :3] = through
    x = points - through[:, None]
    t = np.einsum("bnk,bk->bn", x, axis)
    rho = np.linalg.norm(x - t[..., None] * axis[:, None], axis=2)
    if kind == "cylinder":
        surface[:, 6] = np.einsum("bn,bn->b", weights, rho) / total
    else:
        slope, offset = _line(t, rho, weights)
        phi = np.arctan(slope)
        surface[:, 6], surface[:, 7] = offset * np.cos(phi), phi
    return surface


def _torus_about(
    axis: FloatArray, through: FloatArray, points: FloatArray, weights: FloatArray
) -> FloatArray:
    """(b, 8) tori about given axes: the circle nearest to the meridian half plane's points."""
    x = points - through[:, None]
    t = np.einsum("bnk,bk->bn", x, axis)
    rho = np.linalg.norm(x - t[..., None] * axis[:, None], axis=2)
    r0, z0, radius = _algebraic_circle(rho, t, weights)
    surface = np.zeros((len(points), 8))
    surface[:, :3] = through + z0[:, None] * axis
    surface[:, 3:6], surface[:, 6], surface[:, 7] = axis, r0, radius
    return surface


def _algebraic_sphere(
    points: FloatArray, weights: FloatArray, mean: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Sphere of |p|² = 2 c·p + k by linear least squares: (b, 3) centres and (b,) radii."""
    x = points - mean[:, None]
    rows = np.concatenate([2.0 * x, np.ones((*x.shape[:2], 1))], axis=2)
    q = np.einsum("bnk,bnk->bn", x, x)
    weighted = np.swapaxes(rows * weights[..., None], 1, 2)
    h = weighted @ rows
    h[:, range(4), range(4)] += 1e-12 * np.trace(h, axis1=1, axis2=2)[:, None]
    s = np.linalg.solve(h, weighted @ q[..., None])[..., 0]
    radius = np.sqrt(np.maximum(s[:, 3] + np.einsum("bk,bk->b", s[:, :3], s[:, :3]), 1e-12))
    return s[:, :3] + mean, radius


def _algebraic_circle(
    x: FloatArray, y: FloatArray, weights: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Circles through (b, n) points of a plane: centre x, centre y, radius."""
    points = np.stack([x, y, np.zeros_like(x)], axis=2)
    total = np.maximum(weights.sum(axis=1), 1e-12)
    mean = np.einsum("bn,bnk->bk", weights, points) / total[:, None]
    centre, radius = _algebraic_sphere(points, weights, mean)
    return centre[:, 0], centre[:, 1], radius


def _line(t: FloatArray, rho: FloatArray, weights: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Slope and offset of rho = slope·t + offset by weighted least squares, (b,) each."""
    total = np.maximum(weights.sum(axis=1), 1e-12)
    mt, mr = (weights * t).sum(axis=1) / total, (weights * rho).sum(axis=1) / total
    dt = t - mt[:, None]
    slope = (weights * dt * (rho - mr[:, None])).sum(axis=1) / np.maximum(
        (weights * dt**2).sum(axis=1), 1e-12
    )
    return slope, mr - slope * mt


def _meeting_point(centres: FloatArray, normals: FloatArray, axis: FloatArray) -> FloatArray:
    """(b, 3) points nearest to all normal lines, seen along the (b, 3) axis."""
    flat = normals - np.einsum("bfk,bk->bf", normals, axis)[..., None] * axis[:, None]
    q = np.einsum("bfk,bfk->bf", flat, flat)
    eye = np.eye(3)
    h = q.sum(axis=1)[:, None, None] * eye - np.einsum("bfi,bfj->bij", flat, flat)
    along = np.einsum("bi,bj->bij", axis, axis)
    # Seen along the axis the system has rank two; pin the third coordinate to the centre.
    h = h - along * np.einsum("bi,bij,bj->b", axis, h, axis)[:, None, None] + along
    h += 1e-9 * np.maximum(np.trace(h, axis1=1, axis2=2), 1e-12)[:, None, None] * eye
    weight = np.maximum(np.einsum("bfk,bfk->bf", normals, normals), 0.0)
    mean = np.einsum("bf,bfk->bk", weight, centres) / np.maximum(weight.sum(axis=1), 1e-12)[:, None]
    x = centres - mean[:, None]
    x = x - np.einsum("bfk,bk->bf", x, axis)[..., None] * axis[:, None]
    rhs = np.einsum("bf,bfk->bk", q, x) - np.einsum("bfi,bfj,bfj->bi", flat, flat, x)
    point: FloatArray = np.linalg.solve(h, rhs[..., None])[..., 0] + mean
    return point


def _rotation_axis(centres: FloatArray, normals: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Axis (b, 3) and a point on it (b, 3) of the rotation that best leaves each patch in place.

    Slippage with velocity measured: M x = mu V x, of which the twist of least mu with a rotation;
    its pitch is dropped (paper, eq. 1-3; design, section 5).
    """
    moment = np.cross(centres, normals)
    a = np.concatenate([moment, normals], axis=2)
    m = np.einsum("bfi,bfj->bij", a, a)
    weight = np.einsum("bfk,bfk->bf", normals, normals)
    v = velocity_moments(centres, weight)
    mean = np.einsum("bf,bfk->bk", weight, centres) / np.maximum(weight.sum(axis=1), 1e-12)[:, None]
    floor = 1e-9 * np.maximum(np.trace(v, axis1=1, axis2=2), 1e-12)
    lower = np.linalg.cholesky(v + floor[:, None, None] * np.eye(6))
    inverse = np.linalg.inv(lower)
    mu, y = np.linalg.eigh(inverse @ m @ np.swapaxes(inverse, 1, 2))
    x = np.swapaxes(inverse, 1, 2) @ y[:, :, :3]
    omega, t = x[:, :3], x[:, 3:]
    # Of the three least motions, the one that turns most and has little pitch.
    speed = np.linalg.norm(omega, axis=1)
    radius = np.linalg.norm(np.cross(omega, t, axis=1), axis=1) / np.maximum(speed**2, 1e-12)
    pitch = np.abs(np.einsum("bki,bki->bi", omega, t)) / np.maximum(speed**2, 1e-12)
    badness = mu[:, :3] + 1e-3 * (pitch / np.maximum(radius, 1e-6)) + 1e-3 / np.maximum(speed, 1e-6)
    best = np.argmin(badness, axis=1)
    rows = np.arange(len(best))
    w, s = omega[rows, :, best], t[rows, :, best]
    norm = np.maximum(np.linalg.norm(w, axis=1), 1e-12)[:, None]
    axis = w / norm
    point = np.cross(w, s) / norm**2
    point = point + np.einsum("bk,bk->b", mean - point, axis)[:, None] * axis
    return axis, np.clip(point, -1e3, 1e3)


def velocity_moments(points: FloatArray, weight: FloatArray) -> FloatArray:
    """(b, 6, 6) V = sum w JᵀJ with J = (-[p]×, I), for (b, f, 3) points (design, section 5)."""
    b, f = weight.shape
    j = np.zeros((b, f, 3, 6))
    j[..., 0, 1], j[..., 0, 2] = points[..., 2], -points[..., 1]
    j[..., 1, 0], j[..., 1, 2] = -points[..., 2], points[..., 0]
    j[..., 2, 0], j[..., 2, 1] = points[..., 1], -points[..., 0]
    j[..., [0, 1, 2], [3, 4, 5]] = 1.0
    v: FloatArray = np.einsum("bfki,bf,bfkj->bij", j, weight, j)
    return v
