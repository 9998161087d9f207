# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reference parameters R_i of the seven models (paper, Table 3) from points with normals."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass

import numpy as np

from gpswb.core.facet_geometry import cross_product
from gpswb.core.invariance import CLASSES, InvarianceClass
from gpswb.core.mesh import FloatArray, IntArray
from gpswb.core.slippage import SlippageMoments, slippable_motions, slippage_moments

SAMPLES = 2000
"""Points that are read: more change the references by less than the tessellation does."""
_FAR = 1e4  # centres and axes further than this many region sizes say "plane" or "prism"


@dataclass(frozen=True, eq=False)
class Reference:
    """Situation of a symmetry; each class reads what it needs.

    Args:
        point: (3,) mm: sphere centre, or a point on the plane or axis.
        direction: (3,) unit: plane normal, axis, or direction of the prism.
        lead: mm per turn of a screw, right-handed positive; 0 otherwise.
    """

    point: FloatArray
    direction: FloatArray
    lead: float = 0.0

    def velocity(self, points: FloatArray) -> FloatArray:
        """(n, 3) mm a radian at which the screw moves points (n, 3); a rotation if it has no lead,
        and along the direction, whatever the speed, if it has no axis."""
        if not np.isfinite(self.lead):
            return np.tile(self.direction, (len(points), 1))
        circular = cross_product(self.direction[:, None], (points - self.point).T).T
        moved: FloatArray = circular + self.lead / (2.0 * np.pi) * self.direction
        return moved


References = Mapping[InvarianceClass, Reference]


def estimate_references(
    points: FloatArray,
    normals: FloatArray,
    weights: FloatArray | None = None,
    classes: Collection[InvarianceClass] = CLASSES,
) -> dict[InvarianceClass, Reference]:
    """Best reference parameters of each class, whether or not the region belongs to it.

    Normals give direction and position in closed form: eigenvectors of sum w n n^T for plane and
    prism, lines of normals for the sphere, the generalised slippage M x = mu V x for screws, the
    same with omega . t = 0 for the revolute axis. Positions then refine sphere and cylinder by
    geometric least squares, where they say more than normals.

    Args:
        points: (n, 3) mm; normals: (n, 3) unit; weights: (n,) areas, equal if not given.
        classes: the classes wanted.

    Raises:
        ValueError: fewer than 3 points, or sizes that differ.
    """
    if points.shape != normals.shape or points.ndim != 2 or points.shape[1] != 3 or len(points) < 3:
        raise ValueError(
            "at least 3 points (n, 3) with as many normals are needed, "
            f"not {points.shape} and {normals.shape}"
        )
    chosen = spread(len(points), SAMPLES)
    p, n = points[chosen], normals[chosen]
    w = np.ones(len(p)) if weights is None else weights[chosen]
    w = w / max(float(w.sum()), 1e-300)
    centre = w @ p
    size = max(float(np.sqrt(w @ ((p - centre) ** 2).sum(axis=1))), 1e-300)
    q = (p - centre) / size
    found = _normalised_references(q, n, w, classes)
    return {
        name: Reference(r.point * size + centre, r.direction, r.lead * size)
        for name, r in found.items()
    }


def spread(n: int, limit: int) -> IntArray:
    """At most ``limit`` evenly spaced indices of 0..n-1."""
    return np.linspace(0, n - 1, min(n, limit)).round().astype(np.int64)


def axis_frame(direction: FloatArray) -> FloatArray:
    """(3, 3) right-handed orthonormal frame as rows, the last one along the direction."""
    x, y, z = (direction / np.linalg.norm(direction)).tolist()
    # Branch on the sign of z only (Duff et al. 2017): no direction is near a singularity.
    sign = 1.0 if z >= 0.0 else -1.0
    a = -1.0 / (sign + z)
    b = x * y * a
    u = [1.0 + sign * x * x * a, sign * b, -sign * x]
    return np.array([u, [b, sign + y * y * a, -y], [x, y, z]])


def cross3(a: FloatArray, b: FloatArray) -> FloatArray:
    """a x b of two vectors (3,), in a tenth of numpy's time."""
    (ax, ay, az), (bx, by, bz) = a.tolist(), b.tolist()
    return np.array([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx])


def screw(twist: FloatArray) -> Reference:
    """Axis and lead of a twist (omega, t): point (omega x t)/|omega|^2, lead 2 pi
    (omega.t)/|omega|^2.

    A translation has no axis: its direction is t, its lead infinite.
    """
    omega, t = twist[:3], twist[3:]
    rotation, translation = float(np.linalg.norm(omega)), float(np.linalg.norm(t))
    if rotation * _FAR <= translation:
        return Reference(np.zeros(3), t / translation, np.inf)
    axis = omega / rotation
    across = cross3(axis, t / rotation)
    return Reference(across, axis, 2.0 * np.pi * float(axis @ t) / rotation)


def _normalised_references(
    q: FloatArray, n: FloatArray, w: FloatArray, classes: Collection[InvarianceClass]
) -> dict[InvarianceClass, Reference]:
    """References of centred points of unit radius of gyration."""
    origin = np.zeros(3)
    gauss = (n * w[:, None]).T @ n
    along, mean_normal = np.linalg.eigh(gauss)[1][:, [0, 2]].T
    # The plane that positions and normals agree on: both terms are squared angles.
    scatter = (q * w[:, None]).T @ q
    width = max(float(np.linalg.eigvalsh(scatter)[1]), 1e-12)
    normal = np.linalg.eigh(scatter / width + np.trace(gauss) * np.eye(3) - gauss)[1][:, 0]
    if normal @ (w @ n) < 0.0:
        normal = -normal
    found: dict[InvarianceClass, Reference] = {
        "planar": Reference(origin, normal),
        "prismatic": Reference(origin, along),
        "complex": Reference(origin, normal),
    }
    wanted = set(classes)
    if wanted & {"spherical", "revolute"}:
        found["spherical"] = Reference(_sphere_centre(q, n, w), mean_normal)
    if wanted & {"cylindrical", "revolute"}:
        found["cylindrical"] = _cylinder_axis(q, n, w, along)
    if wanted & {"revolute", "helical"}:
        moments = slippage_moments(q, n, w, np.zeros(len(q), dtype=np.int64), 1)
        found["helical"] = screw(slippable_motions(moments)[1][0, :, 0])
    if "revolute" in wanted:
        nested = [
            _axis_twist(found[name].point, found[name].direction)
            for name in ("planar", "cylindrical", "spherical")
        ]
        revolute = screw(_least_slip([*nested, _pure_rotation(moments)], moments))
        if not np.isfinite(revolute.lead):
            revolute = found["cylindrical"]
        found["revolute"] = Reference(revolute.point, revolute.direction)
    return {name: found[name] for name in CLASSES if name in wanted}


def _axis_twist(point: FloatArray, direction: FloatArray) -> FloatArray:
    twist: FloatArray = np.concatenate([direction, cross3(point, direction)])
    return twist


def _least_slip(candidates: list[FloatArray], moments: SlippageMoments) -> FloatArray:
    """The candidate twist with the least mu; the first on a tie to rounding."""
    m, v = moments.motion[0], moments.metric[0]
    usable = [x for x in candidates if np.isfinite(x).all()] or candidates[:1]
    # Rounding makes the mu of an exact motion negative as soon as positive.
    mu = [max(float(x @ m @ x), 0.0) / max(float(x @ v @ x), 1e-300) for x in usable]
    best = min(mu)
    return next(x for x, value in zip(usable, mu, strict=True) if value <= 1.01 * best + 1e-13)


def _pure_rotation(moments: SlippageMoments) -> FloatArray:
    """Twist of least mu among those with omega . t = 0 (rotations and translations).

    min x'Mx / x'Vx with x'Kx = 0, K the pitch form, equals the maximum over nu of the least
    eigenvalue of (M - nu K, V), which is concave in nu with slope -x'Kx: bisection finds it.
    """
    pitch = np.zeros((6, 6))
    pitch[:3, 3:] = pitch[3:, :3] = 0.5 * np.eye(3)
    inverse = np.linalg.inv(np.linalg.cholesky(moments.metric[0] + 1e-10 * np.eye(6)))
    m = inverse @ moments.motion[0] @ inverse.T
    k = inverse @ pitch @ inverse.T

    def least(nu: float) -> FloatArray:
        vector: FloatArray = np.linalg.eigh(m - nu * k)[1][:, 0]
        return vector

    low, high = -1e-3, 1e-3
    while least(low) @ k @ least(low) > 0.0 and low > -1e9:
        low *= 8.0
    while least(high) @ k @ least(high) < 0.0 and high < 1e9:
        high *= 8.0
    for _ in range(48):
        middle = 0.5 * (low + high)
        x = least(middle)
        if x @ k @ x < 0.0:
            low = middle
        else:
            high = middle
    # On either side of the maximum the pitch has opposite signs: mix both to make it vanish.
    a, b = least(low), least(high)
    if a @ b < 0.0:
        b = -b
    aa, ab, bb = float(a @ k @ a), float(a @ k @ b), float(b @ k @ b)
    root = np.sqrt(max(ab * ab - aa * bb, 0.0))
    denominator = ab + (root if ab >= 0.0 else -root)
    # At a smooth maximum both are the same vector, and have no pitch but rounding to make vanish.
    share = 0.0 if abs(aa) < 1e-10 or denominator == 0.0 else -aa / denominator
    twist: FloatArray = inverse.T @ (a + share * b)
    return twist


def _sphere_centre(q: FloatArray, n: FloatArray, w: FloatArray) -> FloatArray:
    """Centre by the better of normals' lines and algebraic fit, then Gauss-Newton on distances."""
    across = np.eye(3) - (n * w[:, None]).T @ n
    lines = (w @ q) - (n * (w * np.einsum("ij,ij->i", n, q))[:, None]).sum(axis=0)
    design = np.column_stack([2.0 * q, np.ones(len(q))])
    root = np.sqrt(w)[:, None]
    squares = np.einsum("ij,ij->i", q, q)
    algebraic = np.linalg.lstsq(root * design, root[:, 0] * squares, rcond=1e-12)[0][:3]
    starts = [np.linalg.lstsq(across, lines, rcond=1e-12)[0], algebraic]
    starts = [c * min(1.0, _FAR / max(float(np.linalg.norm(c)), 1e-300)) for c in starts]

    def residual(c: FloatArray) -> tuple[FloatArray, FloatArray]:
        ray = q - c
        rho = np.maximum(np.linalg.norm(ray, axis=1), 1e-12)
        return rho, -ray / rho[:, None]

    centre: FloatArray = min(starts, key=lambda c: _spread_of(residual(c)[0], w))
    for _ in range(6):
        rho, jacobian = residual(centre)
        step = _step(rho, jacobian, w)
        if _spread_of(residual(centre + step)[0], w) >= _spread_of(rho, w):
            break
        centre = centre + step
    return centre


def _cylinder_axis(q: FloatArray, n: FloatArray, w: FloatArray, along: FloatArray) -> Reference:
    """Axis from the normals (their lines meet it), then Gauss-Newton on distances to the axis."""
    direction = along
    flat = q - np.outer(q @ direction, direction)
    flat_normal = n - np.outer(n @ direction, direction)
    length = np.maximum(np.linalg.norm(flat_normal, axis=1, keepdims=True), 1e-12)
    point = _line_meeting(flat, flat_normal / length, w)
    point *= min(1.0, _FAR / max(float(np.linalg.norm(point)), 1e-300))

    def residual(
        a: FloatArray, d: FloatArray
    ) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
        ray = q - a
        z = ray @ d
        radial = ray - z[:, None] * d
        rho = np.maximum(np.linalg.norm(radial, axis=1), 1e-12)
        u, v, _ = axis_frame(d)
        unit = radial / rho[:, None]
        cos, sin = unit @ u, unit @ v
        return rho, -np.column_stack([cos, sin, z * cos, z * sin]), u, v

    for _ in range(8):
        rho, jacobian, u, v = residual(point, direction)
        step = _step(rho, jacobian, w)
        moved = point + step[0] * u + step[1] * v
        turned = direction + step[2] * u + step[3] * v
        turned = turned / float(np.linalg.norm(turned))
        if _spread_of(residual(moved, turned)[0], w) >= _spread_of(rho, w):
            break
        point, direction = moved, turned
    return Reference(point - (point @ direction) * direction, direction)


def _line_meeting(p: FloatArray, n: FloatArray, w: FloatArray) -> FloatArray:
    """The point nearest to all lines p + s n in least squares (of least norm if not unique)."""
    across = float(w.sum()) * np.eye(3) - (n * w[:, None]).T @ n
    right = w @ p - (n * (w * np.einsum("ij,ij->i", n, p))[:, None]).sum(axis=0)
    point: FloatArray = np.linalg.lstsq(across, right, rcond=1e-10)[0]
    return point


def _spread_of(rho: FloatArray, w: FloatArray) -> float:
    """Weighted variance: what is left of the distances once the radius is fitted."""
    return float(w @ (rho - w @ rho) ** 2)


def _step(rho: FloatArray, jacobian: FloatArray, w: FloatArray) -> FloatArray:
    """Gauss-Newton step on the deviations from the mean distance (the radius is eliminated)."""
    root = np.sqrt(w)[:, None]
    centred = root * (jacobian - w @ jacobian)
    solution = np.linalg.lstsq(centred, -root[:, 0] * (rho - w @ rho), rcond=1e-9)
    return np.asarray(solution[0], dtype=np.float64)
