# SPDX-License-Identifier: LGPL-2.1-or-later
"""One surface of each kind with its points in closed form, and how two surfaces compare."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from analytic_meshes import TURN, sheet
from scipy.spatial.transform import Rotation

from gpswb.core.mesh import FloatArray, Mesh
from gpswb.core.robust.surfaces import Kind

CURVED: tuple[Kind, ...] = ("cylinder", "cone", "sphere", "torus")
HALF_ANGLE = 0.4
SIZES: dict[Kind, tuple[float, float]] = {
    "plane": (0.0, 0.0),
    "cylinder": (5.0, 0.0),
    "cone": (6.0 * np.cos(HALF_ANGLE), HALF_ANGLE),
    "sphere": (7.0, 0.0),
    "torus": (10.0, 3.0),
}
"""Columns a and b: cylinder R5, cone of radius 6 at its point, sphere R7, torus R10 r3; mm."""


class Frame:
    """A rotation and a translation by a few sizes of the surfaces."""

    def __init__(self, seed: int) -> None:
        rng = np.random.default_rng(seed)
        self.rotation = Rotation.from_quat(rng.normal(size=4)).as_matrix()
        self.origin = 20.0 * rng.normal(size=3)

    def point(self, p: FloatArray) -> FloatArray:
        return p @ self.rotation.T + self.origin

    @property
    def axis(self) -> FloatArray:
        return self.rotation[:, 2]


def surface_of(kind: Kind, frame: Frame) -> FloatArray:
    """(8,) the kind's surface about the frame's axis."""
    return np.concatenate([frame.origin, frame.axis, SIZES[kind]])


def point_on(kind: Kind, u: FloatArray, v: FloatArray, off: float = 0.0) -> FloatArray:
    """Points at ``off`` mm outside the surface about z: u turns about z, v is the other one."""
    a, b = SIZES[kind]
    if kind == "plane":
        return np.column_stack([u, v, np.full(len(u), off)])
    if kind == "cylinder":
        rho, z = (a + off) + 0.0 * v, v
    elif kind == "cone":
        rho = 6.0 + v * np.tan(b) + off * np.cos(b)
        z = v - off * np.sin(b)
    elif kind == "sphere":
        rho, z = (a + off) * np.cos(v), (a + off) * np.sin(v)
    else:
        rho, z = a + (b + off) * np.cos(v), (b + off) * np.sin(v)
    return np.column_stack([rho * np.cos(u), rho * np.sin(u), z])


def patch_mesh(kind: Kind, frame: Frame, n: int = 6, size: float = 1.0) -> Mesh:
    """An exact piece of the surface: 0.9 rad about the axis, by 0.8 rad or 3 mm, times ``size``."""
    height = size * (0.8 if kind in ("sphere", "torus") else 3.0)
    return sheet(
        lambda u, v: frame.point(point_on(kind, 0.3 + 0.9 * size * u, height * (v - 0.3))), n, n
    )


def full_torus(n: int) -> Mesh:
    """Torus R10 r3 about z, n rings of vertices; where n is 4k+2 two rings share the top plane."""
    mesh = sheet(lambda u, v: point_on("torus", TURN * u, TURN * v), 20, n, closed=True)
    last = np.arange(len(mesh.vertices)).reshape(20, n + 1)
    onto = np.where(np.arange(n + 1) == n, last[:, :1], last).ravel()
    kept, index = np.unique(onto, return_inverse=True)
    return Mesh(mesh.vertices[kept], index.reshape(-1)[mesh.triangles])


def misfit(kind: Kind, found: FloatArray, true: FloatArray) -> float:
    """Largest difference of two surfaces in their own sizes (mm) and position; 0 where equal.

    The point may slide along an axis or in a plane, and the axis may be turned round: the surface
    stays the same.
    """
    found = found.copy()
    if kind == "sphere":
        return float(np.abs(np.r_[found[:3] - true[:3], found[6] - true[6]]).max())
    if found[3:6] @ true[3:6] < 0.0:
        found[3:6] *= -1.0
        if kind == "cone":
            found[7] *= -1.0
    turn = np.abs(found[3:6] - true[3:6]).max()
    gap = found[:3] - true[:3]
    along = float(gap @ true[3:6])
    if kind == "plane":
        return float(max(turn, abs(along)))
    across = np.abs(gap - along * true[3:6]).max()
    if kind == "cylinder":
        return float(max(turn, across, abs(found[6] - true[6])))
    if kind == "cone":
        there = true[6] + along * np.sin(true[7])
        return float(max(turn, across, abs(found[7] - true[7]), abs(found[6] - there)))
    sizes = np.abs(np.abs(found[6:8]) - true[6:8]).max()
    return float(max(turn, across, abs(along), sizes))


def slope_of_moves(
    surface_after: Callable[[FloatArray], FloatArray], shape: tuple[int, int]
) -> FloatArray:
    """(b, 8, k) change of b surfaces with each of k coordinates, by central differences.

    Args:
        surface_after: the (b, 8) surfaces after a (b, k) step.
        shape: b and k.
    """
    slope = np.empty((shape[0], 8, shape[1]))
    for k in range(shape[1]):
        step = np.zeros(shape)
        step[:, k] = 1e-6
        slope[..., k] = (surface_after(step) - surface_after(-step)) / 2e-6
    return slope
