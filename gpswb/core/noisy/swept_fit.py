# SPDX-License-Identifier: LGPL-2.1-or-later
"""The likeliest swept surface of a noisy region, by Gauss-Newton on motion and profile."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from scipy.interpolate import BSpline

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray, IntArray
from gpswb.core.motion_chart import MotionChart
from gpswb.core.noisy.least_cost import cheapest
from gpswb.core.noisy.noisy_mesh import NoisyMesh
from gpswb.core.noisy.profile_length import profile_length, quotient_gradient
from gpswb.core.noisy.swept import MOTIONS, OUTSIDE, Swept, profile_coordinates
from gpswb.core.recognition import slip_of
from gpswb.core.reference import Reference, estimate_references, spread
from gpswb.core.thickness import quotient_jacobian

INTERVALS = (1, 2, 4, 6, 9, 14, 22, 34)
"""Intervals of the spline that are tried. They are of one length: a profile with short rounds
between long straights takes many, and is cheaper as planes and cylinders."""

PATIENCE = 2
"""Refinements of the spline in a row that may be for nothing."""

FEW, HOPELESS = 5, 4.0
"""Intervals from which a mean squared distance of so many sigma² says that the motion is wrong."""

SAMPLE = 600
"""Vertices that a profile is fitted to: seventeen for each interval at the finest."""

STEPS = 4
"""Corrections of motion and length along the profile for each number of intervals, at most."""

SETTLED = 0.002
"""Share of chi-square that a correction saves at least, or it was the last."""

AGREEMENT = 0.9
"""Mean cosine between facets and surface, at least: a profile that runs to and fro through the
noise explains all positions, but no normals."""

LEAD = 30.0
"""Sigma that a lead is long at least: where it is shorter, points fill it, and any profile fits."""

NEWTON = 3
"""Steps to the nearest point of the profile."""


def shown_motions(
    noisy: NoisyMesh, facets: IntArray
) -> dict[InvarianceClass, tuple[Reference, float]]:
    """The motion of each class that denoised normals show, and the mean squared sine that they are
    off it.

    Args:
        noisy: the mesh and its noise.
        facets: (k,) connected facets.
    """
    mesh = noisy.mesh
    inner = _inner(noisy, facets)
    points, normals, areas = mesh.centroids[inner], noisy.normals[inner], mesh.areas[inner]
    shown = estimate_references(points, normals, areas, tuple(MOTIONS))
    return {
        name: (shown[name], slip_of(points, normals, areas, name, shown[name])) for name in MOTIONS
    }


def fit_swept(
    noisy: NoisyMesh,
    facets: IntArray,
    name: InvarianceClass,
    starts: Sequence[Reference],
    most: float = np.inf,
) -> Swept | None:
    """The likeliest surface of a motion through some facets.

    Args:
        noisy: the mesh and its noise.
        facets: (k,) connected facets.
        name: the class.
        starts: motions that may be near.
        most: cost above which a surface is of no interest.

    Returns:
        None where the facets have no such motion at all.
    """
    best: Swept | None = None
    for start in starts:
        if np.isfinite(start.lead) and (name != "helical" or start.lead != 0.0):
            found = _from(noisy, facets, name, start, most)
            if found is not None and (best is None or found.cost < best.cost):
                best = found
    if best is None:
        return None
    inner = _inner(noisy, facets)
    _, normal = best.distance(noisy.mesh.centroids[inner])
    cosine = np.einsum("nk,nk->n", normal, noisy.normals[inner])
    agreement = float(np.average(cosine, weights=noisy.mesh.areas[inner]))
    return None if abs(agreement) < AGREEMENT else replace(best, side=float(np.sign(agreement)))


def _inner(noisy: NoisyMesh, facets: IntArray) -> IntArray:
    """Facets whose neighbours are all of the region, if they are most of it: at its border denoised
    normals lean to the other side."""
    inside = np.zeros(len(noisy.mesh.triangles), dtype=bool)
    inside[facets] = True
    near = noisy.graph.neighbour[facets]
    inner = facets[(inside[np.maximum(near, 0)] & (near >= 0)).all(axis=1)]
    return inner if 2 * len(inner) > len(facets) else facets


def _from(
    noisy: NoisyMesh, facets: IntArray, name: InvarianceClass, reference: Reference, most: float
) -> Swept | None:
    """The likeliest surface of a motion that is near a given one."""
    return cheapest(_finer(noisy, facets, name, reference, most), PATIENCE)


def _finer(
    noisy: NoisyMesh, facets: IntArray, name: InvarianceClass, reference: Reference, most: float
) -> Iterator[Swept]:
    """Surfaces of a motion with ever more intervals of the profile, while they can be likelier."""
    vertices, length = profile_length(noisy, facets, name, reference)
    points = noisy.mesh.vertices[vertices]
    some = spread(len(vertices), SAMPLE)
    # Chi-square is that of the noise at least, but for four standard deviations.
    least = len(points) - 4.0 * float(np.sqrt(2.0 * len(points)))
    for intervals in INTERVALS:
        price = (MOTIONS[name] + intervals + 3) * float(np.log(len(points)))
        if 3 * (intervals + 3) > len(some) or least + price > most:
            break
        found = _fitted(points[some], length[some], name, reference, intervals, noisy.sigma)
        if found is None:
            break
        reference, curve, along = found
        # The others have moved along the profile as those of the sample.
        order = np.argsort(length[some], kind="stable")
        start = np.interp(length, length[some][order], along[order])
        chi = _total((_heights(points, start, name, reference, curve) / noisy.sigma) ** 2)
        if intervals > FEW and chi > HOPELESS * len(points):
            break
        yield Swept(name, reference, curve, 1.0, chi, len(points))


def _fitted(
    points: FloatArray,
    length: FloatArray,
    name: InvarianceClass,
    reference: Reference,
    intervals: int,
    sigma: float,
) -> tuple[Reference, BSpline, FloatArray] | None:
    """Motion, profile (a spline with so many intervals), and where the points (n,) are along it.

    Gauss-Newton: each round fits the profile, which is linear, then moves the motion by the
    distances that the profile can't follow, and each point along the profile to where it is
    nearest.
    """
    centre = points.mean(axis=0)
    size = max(float(np.sqrt(((points - centre) ** 2).sum(axis=1).mean())), 1e-300)
    best: tuple[Reference, BSpline, FloatArray] | None = None
    least = np.inf
    for _ in range(STEPS):
        if name == "helical" and abs(reference.lead) < LEAD * sigma:
            break
        quotient = profile_coordinates(points, name, reference, None)
        basis, curve = _spline(length, quotient, intervals)
        off, slope = quotient - basis @ curve.c, curve(length, 1)
        speed = np.maximum(np.linalg.norm(slope, axis=1), 1e-300)
        tangent = slope / speed[:, None]
        normal = np.column_stack([-tangent[:, 1], tangent[:, 0]])
        gradient = quotient_gradient(points, name, reference)
        stretch = np.linalg.norm(np.einsum("nqk,nq->nk", gradient, normal), axis=1)
        stretch = np.maximum(stretch, 1e-300)
        height = np.einsum("nq,nq->n", off, normal) / stretch
        total = _total((height / sigma) ** 2)
        settled = total > (1.0 - SETTLED) * least
        if total < least:
            least, best = total, (reference, curve, length)
        if settled:
            break
        turned = quotient_jacobian(points, name, reference)
        change = np.einsum("nqp,nq->np", turned, normal / stretch[:, None])
        change = change @ MotionChart(name, reference, centre, size).derivative()
        if not np.isfinite(change).all():
            break
        near = np.abs(height) <= OUTSIDE * sigma
        if int(near.sum()) < 2 * basis.shape[1]:
            break
        across = basis[near]
        gram = across.T @ across + 1e-9 * len(across) * np.eye(across.shape[1])
        design = change[near] - across @ np.linalg.solve(gram, across.T @ change[near])
        step = np.linalg.lstsq(design, -height[near], rcond=1e-6)[0]
        reference = MotionChart(name, reference, centre, size).moved(step)
        if not np.isfinite([*reference.point, *reference.direction, reference.lead]).all():
            break
        length = length + np.einsum("nq,nq->n", off, tangent) / speed
    return best


def _heights(
    points: FloatArray,
    along: FloatArray,
    name: InvarianceClass,
    reference: Reference,
    curve: BSpline,
) -> FloatArray:
    """(n,) mm distances of points (n, 3) from where they are nearest to the profile, sought from
    ``along`` (n,) on: elsewhere another part of the profile may be nearer by chance."""
    quotient = profile_coordinates(points, name, reference, curve)
    for _ in range(NEWTON):
        off, slope = quotient - curve(along), curve(along, 1)
        speed = np.maximum((slope**2).sum(axis=1), 1e-300)
        along = np.clip(along + (off * slope).sum(axis=1) / speed, curve.t[0], curve.t[-1])
    off, slope = quotient - curve(along), curve(along, 1)
    normal = np.column_stack([-slope[:, 1], slope[:, 0]])
    normal /= np.maximum(np.linalg.norm(slope, axis=1), 1e-300)[:, None]
    gradient = quotient_gradient(points, name, reference)
    stretch = np.linalg.norm(np.einsum("nqk,nq->nk", gradient, normal), axis=1)
    height: FloatArray = (off * normal).sum(axis=1) / np.maximum(stretch, 1e-300)
    return height


def _spline(length: FloatArray, quotient: FloatArray, intervals: int) -> tuple[FloatArray, BSpline]:
    """(n, intervals + 3) cubic B-splines at lengths (n,), and the curve through (n, 2) points."""
    low = float(length.min())
    high = low + max(float(np.ptp(length)), 1e-300) * (1.0 + 1e-9)
    knots = np.linspace(low, high, intervals + 1)
    knots = np.concatenate([np.full(3, low), knots, np.full(3, high)])
    basis: FloatArray = BSpline.design_matrix(length, knots, 3).toarray()
    # A little stiffness bridges intervals without points.
    bend = np.diff(np.eye(intervals + 3), 2, axis=0)
    gram = basis.T @ basis
    gram = gram + float(np.trace(gram)) / len(gram) * (
        1e-6 * bend.T @ bend + 1e-12 * np.eye(len(gram))
    )
    return basis, BSpline(knots, np.linalg.solve(gram, basis.T @ quotient), 3)


def _total(squares: FloatArray) -> float:
    return float(np.minimum(squares, OUTSIDE**2).sum())
