# SPDX-License-Identifier: LGPL-2.1-or-later
"""The small motions that a feature locks, as rows C of C ξ = 0 with the twist ξ = (ω, v)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray
from gpswb.errors import InputError
from gpswb.sentence import Sentence

Vector = tuple[float, float, float]


def vector(values: Sequence[float] | FloatArray) -> Vector:
    """Three floats as a hashable tuple."""
    x, y, z = (float(value) for value in values)
    return (x, y, z)


@dataclass(frozen=True)
class SituationFeature:
    """Where an ideal feature is: its class with the point, line or plane that situates it.

    ``direction`` (unit) is the normal of a planar, the axis of a cylindrical, revolute or helical
    and the generator of a prismatic feature; ``point`` lies on it. ``lead`` (signed, right-handed
    positive) belongs to helical alone. What a class doesn't use is ignored. (ISO 17450-1, 22432)
    """

    invariance_class: InvarianceClass
    point: Vector = (0.0, 0.0, 0.0)
    direction: Vector = (0.0, 0.0, 1.0)
    lead: float = 0.0

    @property
    def directed(self) -> bool:
        """Whether the class has a direction at all."""
        return self.invariance_class not in ("spherical", "complex")

    @property
    def has_axis(self) -> bool:
        """Whether the class turns about exactly one axis."""
        return self.invariance_class in ("cylindrical", "revolute", "helical")


@dataclass(frozen=True)
class Frame:
    """Origin and characteristic length that make twists dimensionless.

    Take both from the part's points, once for a part: ranks then depend on neither unit nor place.
    """

    origin: Vector = (0.0, 0.0, 0.0)
    length: float = 1.0

    @staticmethod
    def around(points: FloatArray) -> Frame:
        """Centre and diagonal of the box of points (n, 3); InputError if it has no extent."""
        if not len(points) or not np.ptp(points, axis=0).any():
            raise InputError(
                Sentence("a part of {n} points without extent has no GPS features", n=len(points))
            )
        low, high = points.min(axis=0), points.max(axis=0)
        length = float(np.linalg.norm(high - low))
        return Frame(vector((low + high) / 2), length)


def perpendiculars(direction: Sequence[float] | FloatArray) -> tuple[FloatArray, FloatArray]:
    """Unit u, w with (u, w, direction) right-handed and orthonormal; ``direction`` unit."""
    d = np.asarray(direction, dtype=np.float64)
    across = np.cross(np.eye(3)[np.argmin(np.abs(d))], d)
    u: FloatArray = np.asarray(across / np.linalg.norm(across), dtype=np.float64)
    return u, np.asarray(np.cross(d, u), dtype=np.float64)


def rotation_row(e: FloatArray) -> FloatArray:
    """r(e): no rotation about e."""
    return np.concatenate([e, np.zeros(3)])


def translation_row(p: FloatArray, e: FloatArray) -> FloatArray:
    """t(p, e): the point p doesn't move along e, as e·(v + ω×p) = ω·(p×e) + v·e."""
    return np.concatenate([np.cross(p, e), e])


def constraint_rows(feature: SituationFeature, frame: Frame) -> FloatArray:
    """Rows of C ξ = 0 for the motions that leave the feature in place (design, 7).

    Args:
        feature: its point in the unit of ``frame``, its direction of unit length.
        frame: origin and length; v is in units of length, about the origin.

    Returns:
        (6 - dim, 6) float64, dimensionless, independent rows.
    """
    kind = feature.invariance_class
    if kind == "complex":
        return np.eye(6)
    p = (np.asarray(feature.point) - frame.origin) / frame.length
    if kind == "spherical":
        return np.array([translation_row(p, e) for e in np.eye(3)])
    d = np.asarray(feature.direction)
    u, w = perpendiculars(d)
    if kind == "planar":
        # The plane's foot below the origin: its moment is zero, however far away p was.
        return np.array([rotation_row(u), rotation_row(w), translation_row(d * (d @ p), d)])
    if kind == "prismatic":
        still = np.zeros(3)
        rows = [rotation_row(e) for e in np.eye(3)]
        return np.array([*rows, translation_row(still, u), translation_row(still, w)])
    p = p - d * (d @ p)
    rows = [rotation_row(u), rotation_row(w), translation_row(p, u), translation_row(p, w)]
    if kind == "revolute":
        rows.append(translation_row(p, d))
    elif kind == "helical":
        h = feature.lead / (2 * np.pi * frame.length)
        rows.append(translation_row(p, d) - h * rotation_row(d))
    return np.array(rows)


def null_space(rows: FloatArray, tolerance: float) -> FloatArray:
    """(6, k) orthonormal basis of the twists that rows (m, 6) let free, m = 0 included."""
    _, singular, vt = np.linalg.svd(np.vstack([rows, np.zeros((6, 6))]), full_matrices=False)
    free: FloatArray = vt[singular <= tolerance].T
    return free


def locked_degrees(free: FloatArray) -> tuple[int, int]:
    """(translations, rotations) locked when the twists free (6, k) are left."""
    rotations = 3 - rotation_rank(free)
    return 6 - free.shape[1] - rotations, rotations


def rotation_rank(free: FloatArray) -> int:
    """Number of independent rotations among twists (6, k)."""
    return len(rotations_of(free))


# A rotation about an axis at distance a (in lengths) has ω of norm 1/√(1+a²) in a unit twist, a
# translation none: the axis of the flattest arc may lie a thousand lengths away.
_TURNING = 1e-3


def rotations_of(free: FloatArray) -> FloatArray:
    """(r, 3) orthonormal directions about which twists (6, k) turn."""
    u, singular, _ = np.linalg.svd(np.hstack([free[:3], np.zeros((3, 3))]))
    turning: FloatArray = u[:, singular > _TURNING].T
    return turning


def translations_of(free: FloatArray) -> FloatArray:
    """(t, 3) orthonormal directions of the pure translations among twists (6, k)."""
    k = free.shape[1]
    square = np.zeros((6, 6))
    square[:3, :k] = free[:3]
    _, singular, vt = np.linalg.svd(square)
    still = vt[singular <= _TURNING, :k]
    return beyond(np.zeros((0, 3)), still @ free[3:].T)


def beyond(inner: FloatArray, outer: FloatArray) -> FloatArray:
    """Orthonormal rows of the space of ``outer`` (n, 3) perpendicular to the rows ``inner``."""
    rest = outer - outer @ inner.T @ inner
    _, singular, vt = np.linalg.svd(np.vstack([rest, np.zeros((3, 3))]), full_matrices=False)
    kept: FloatArray = vt[singular > 0.5]
    return kept


def as_datum(feature: SituationFeature) -> SituationFeature:
    """The feature as a datum: a thread stands for its pitch cylinder (ISO 5459)."""
    if feature.invariance_class == "helical":
        return replace(feature, invariance_class="cylindrical", lead=0.0)
    return feature
