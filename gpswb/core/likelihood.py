# SPDX-License-Identifier: LGPL-2.1-or-later
"""Leave-one-out likelihood of a region under the seven semi-parametric models (paper, 5.4, Table
3).

Every model is a density in space. In ``corrected`` form each carries the Jacobian of its own
coordinates, so that the seven values compare and do not depend on the unit:

    spherical    p(rho) / (solid angle rho^2)      revolute   p(rho, z) / (angle rho)
    cylindrical  p(rho) p(z) / (angle rho)         prismatic  p(x', y') p(z')
    planar       p(x') p(y') p(z')                 complex    p(x, y, z)
    helical      p(rho, h) p(z) c / rho,  h = z - c phi modulo the lead, c = lead / 2 pi

The window (angle, solid angle) is what the region covers, or a quarter of a cylinder would pay log
4 a point. As ``printed`` the densities live in different coordinates: p(rho) cos(phi) / (4 pi),
p(rho) p(z') / (2 pi), p(rho, z') / (2 pi), p(h, rho) p(z'), and their ranking depends on the unit.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cached_property
from typing import Literal

import numpy as np

from gpswb.core.invariance import CLASSES, InvarianceClass
from gpswb.core.kernel_density import leave_one_out_log_density
from gpswb.core.mesh import FloatArray
from gpswb.core.quotient import (
    AxisCoordinates,
    axis_coordinates,
    largest_gap,
    quotient_coordinates,
)
from gpswb.core.reference import Reference, References, axis_frame, spread

Densities = Literal["corrected", "printed"]

_SAMPLES = 4000  # points evaluated; larger regions are thinned evenly and scaled up


class LogLikelihoods(Mapping[InvarianceClass, float]):
    """log L of every class for one region, computed when first read.

    They are reported, but decide only in mode `paper`: computing the seven takes longer than all
    else that is done with a region.

    Args:
        points: (n, 3) mm, n >= 2.
        references: gives the reference parameters by class; classes left out get no value.
        floor, densities: as in `log_likelihoods`.
    """

    def __init__(
        self,
        points: FloatArray,
        references: Callable[[], References],
        floor: float,
        densities: Densities = "corrected",
    ) -> None:
        # No more than is read is kept: a copy, so that the rest can be freed.
        self._points = points[spread(len(points), _SAMPLES)]
        self._scale = len(points) / max(len(self._points), 1)
        self._references, self._floor, self._densities = references, floor, densities

    @cached_property
    def _values(self) -> dict[InvarianceClass, float]:
        found = log_likelihoods(self._points, self._references(), self._floor, self._densities)
        return {name: self._scale * value for name, value in found.items()}

    def __getitem__(self, name: InvarianceClass) -> float:
        return self._values[name]

    def __iter__(self) -> Iterator[InvarianceClass]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)


def log_likelihoods(
    points: FloatArray,
    references: References,
    floor: float,
    densities: Densities = "corrected",
) -> dict[InvarianceClass, float]:
    """log L of every class, given the reference parameters of each class.

    The reference parameters are estimated once from all points, where the print estimates them anew
    without each point in turn; the difference is of the order of one point's weight.

    Args:
        points: (n, 3) mm, n >= 2.
        references: reference parameters by class; classes left out get no value.
        floor: least bandwidth, mm > 0: the distance below which points count as on the surface.
        densities: with the right Jacobians, or as printed.

    Returns:
        Natural log of the likelihood, in the order of the classes.

    Raises:
        ValueError: fewer than two points, or a floor that is not positive.
    """
    return {
        name: float(_MODELS[name](points, references[name], floor, densities == "printed").sum())
        for name in CLASSES
        if name in references
    }


def _one(values: FloatArray, floor: float) -> FloatArray:
    return leave_one_out_log_density(values[:, None], floor)


def _planar(p: FloatArray, reference: Reference, floor: float, printed: bool) -> FloatArray:
    frame = axis_frame(reference.direction)
    local = (p - reference.point) @ frame.T
    # In-plane axes along the principal directions: independent there for a rectangle.
    turn = np.linalg.svd(np.cov(local[:, :2].T))[0]
    across = local[:, :2] @ turn
    return _one(across[:, 0], floor) + _one(across[:, 1], floor) + _one(local[:, 2], floor)


def _spherical(p: FloatArray, reference: Reference, floor: float, printed: bool) -> FloatArray:
    ray = p - reference.point
    rho = np.maximum(np.linalg.norm(ray, axis=1), floor)
    if printed:
        cosine = np.maximum(np.hypot(ray[:, 0], ray[:, 1]) / rho, 1e-12)
        jacobian: FloatArray = np.log(cosine) - np.log(4.0 * np.pi)
    else:
        jacobian = -2.0 * np.log(rho) - np.log(solid_angle(ray / rho[:, None]))
    return _one(rho, floor) + jacobian


def _cylindrical(p: FloatArray, reference: Reference, floor: float, printed: bool) -> FloatArray:
    about = axis_coordinates(p, reference)
    density = _one(about.rho, floor) + _one(about.z, floor)
    return density - _orbit(about, floor, printed)


def _revolute(p: FloatArray, reference: Reference, floor: float, printed: bool) -> FloatArray:
    about = axis_coordinates(p, reference)
    density = leave_one_out_log_density(np.column_stack([about.rho, about.z]), floor)
    return density - _orbit(about, floor, printed)


def _helical(p: FloatArray, reference: Reference, floor: float, printed: bool) -> FloatArray:
    if not np.isfinite(reference.lead):
        return _prismatic(p, reference, floor, printed)
    pitch = abs(reference.lead) / (2.0 * np.pi)
    if pitch <= floor:
        # h runs through all its range on every orbit: p(rho, h) tends to p(rho) / (2 pi c).
        return _cylindrical(p, reference, floor, printed)
    quotient = quotient_coordinates(p, "helical", reference)
    about = axis_coordinates(p, reference)
    density = leave_one_out_log_density(quotient, floor) + _one(about.z, floor)
    if printed:
        return density
    jacobian: FloatArray = np.log(pitch) - np.log(np.maximum(about.rho, floor))
    return density + jacobian


def _prismatic(p: FloatArray, reference: Reference, floor: float, printed: bool) -> FloatArray:
    local = (p - reference.point) @ axis_frame(reference.direction).T
    return leave_one_out_log_density(local[:, :2], floor) + _one(local[:, 2], floor)


def _complex(p: FloatArray, reference: Reference, floor: float, printed: bool) -> FloatArray:
    return leave_one_out_log_density(p, floor)


def _orbit(about: AxisCoordinates, floor: float, printed: bool) -> FloatArray:
    """log of the length of the circle (or arc) that each point's orbit covers."""
    if printed:
        return np.full(len(about.rho), np.log(2.0 * np.pi))
    length: FloatArray = np.log(covered_angle(about.phi)) + np.log(np.maximum(about.rho, floor))
    return length


def covered_angle(phi: FloatArray) -> float:
    """Angle that points cover about an axis: 2 pi less the largest gap, if that is one.

    Args:
        phi: (n,) radians.
    """
    gap, _ = largest_gap(phi, 2.0 * np.pi)
    n = len(phi)
    # Among n even draws the largest gap of a full turn is about 2 pi log(n) / n.
    if gap <= 2.0 * 2.0 * np.pi * (np.log(n) + 1.0) / n:
        return 2.0 * np.pi
    return max((2.0 * np.pi - gap) * (n + 1.0) / n, 1e-9)


def solid_angle(directions: FloatArray) -> float:
    """Solid angle that unit directions (n, 3) cover: occupied cells of an equal-area grid."""
    n = len(directions)
    mean = directions.mean(axis=0)
    length = float(np.linalg.norm(mean))
    pole = mean / length if length > 1e-6 else np.array([0.0, 0.0, 1.0])
    x, y, z = (directions @ axis_frame(pole).T).T
    low = max(float(z.min()), -1.0)
    span = max(1.0 - low, 1e-12) * (1.0 + 1e-9)
    # About six points a cell, so that a covered cell stays empty once in 400.
    rows = max(1, round(np.sqrt(n / 6.0 / 3.0)))
    columns = 3 * rows
    row = np.minimum(((z - low) / span * rows).astype(np.int64), rows - 1)
    column = ((np.arctan2(y, x) / (2.0 * np.pi) + 0.5) * columns).astype(np.int64) % columns
    occupied = len(np.unique(row * columns + column))
    return float(2.0 * np.pi * span * occupied / (rows * columns))


_Model = Callable[[FloatArray, Reference, float, bool], FloatArray]

_MODELS: dict[InvarianceClass, _Model] = {
    "planar": _planar,
    "cylindrical": _cylindrical,
    "spherical": _spherical,
    "revolute": _revolute,
    "prismatic": _prismatic,
    "helical": _helical,
    "complex": _complex,
}
