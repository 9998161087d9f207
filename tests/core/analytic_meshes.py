# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes and samples of surfaces whose every property is known in closed form."""

from collections.abc import Callable

import numpy as np
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh

TURN = 2.0 * np.pi
Surface = Callable[[FloatArray, FloatArray], FloatArray]


def sheet(surface: Surface, nu: int, nv: int, *, closed: bool = False) -> Mesh:
    """Grid of nu x nv quads over the unit square; ``closed`` joins u = 1 to u = 0."""
    u = np.arange(nu + (not closed)) / nu
    v = np.arange(nv + 1) / nv
    points = surface(*(a.ravel() for a in np.meshgrid(u, v, indexing="ij")))
    i, j = (a.ravel() for a in np.meshgrid(np.arange(nu), np.arange(nv), indexing="ij"))
    k = (i + 1) % len(u)
    a, b, c, d = i * (nv + 1) + j, k * (nv + 1) + j, k * (nv + 1) + j + 1, i * (nv + 1) + j + 1
    return Mesh(points, np.concatenate([np.column_stack(t) for t in ((a, b, c), (a, c, d))]))


def weld(*meshes: Mesh) -> Mesh:
    """One mesh of several; vertices within 1e-9 of one another become one."""
    points = np.concatenate([m.vertices for m in meshes])
    offset = np.cumsum([0, *(len(m.vertices) for m in meshes)])[:-1]
    facets = [m.triangles + o for m, o in zip(meshes, offset, strict=True)]
    triangles = np.concatenate(facets)
    _, first, inverse = np.unique(
        np.round(points / 1e-9).astype(np.int64), axis=0, return_index=True, return_inverse=True
    )
    triangles = inverse.ravel()[triangles]
    solid = (triangles != np.roll(triangles, 1, axis=1)).all(axis=1)
    return Mesh(points[first], triangles[solid])


def plane(a: float = 30.0, b: float = 20.0, nu: int = 12, nv: int = 8) -> Mesh:
    return sheet(lambda u, v: np.column_stack([a * u, b * v, 0.0 * u]), nu, nv)


def cylinder(
    radius: float = 5.0, height: float = 12.0, nu: int = 36, nv: int = 10, arc: float = 1.0
) -> Mesh:
    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        t = TURN * arc * u
        return np.column_stack([radius * np.cos(t), radius * np.sin(t), height * v])

    return sheet(surface, nu, nv, closed=arc == 1.0)


def cone(nu: int = 40, nv: int = 12) -> Mesh:
    """Half angle 30 degrees about z, outside facing out."""
    slope = np.tan(np.pi / 6.0)

    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        t, z = TURN * u, 10.0 - 6.0 * (1.0 - v)
        rho = slope * (14.0 - z)
        return np.column_stack([rho * np.cos(t), rho * np.sin(t), z])

    return sheet(surface, nu, nv, closed=True)


def torus(n: int = 24, major: float = 10.0, minor: float = 3.0, arc: float = 1.0) -> Mesh:
    """Ring torus: 2 n quads round the axis, n round the tube, the whole tube welded."""

    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        t, f = TURN * arc * u, TURN * v
        rho = major + minor * np.cos(f)
        return np.column_stack([rho * np.cos(t), rho * np.sin(t), minor * np.sin(f)])

    return weld(sheet(surface, 2 * n, n, closed=arc == 1.0))


def sphere(radius: float = 7.0, level: int = 8) -> Mesh:
    """A cube's grid blown up to a sphere."""
    cube = box((2.0, 2.0, 2.0), level)
    centred = cube.vertices - 1.0
    length = np.linalg.norm(centred, axis=1, keepdims=True)
    return Mesh(radius * centred / length, cube.triangles)


def box(size: tuple[float, float, float] = (30.0, 20.0, 10.0), n: int = 6) -> Mesh:
    """Closed box from the origin, n x n quads a side, facing out."""
    sides = []
    for axis in range(3):
        for end in (0.0, 1.0):

            def surface(
                u: FloatArray, v: FloatArray, axis: int = axis, end: float = end
            ) -> FloatArray:
                p = np.empty((len(u), 3))
                one, two = (axis + 1) % 3, (axis + 2) % 3
                p[:, axis] = end
                p[:, one], p[:, two] = (u, v) if end else (v, u)
                return p * np.array(size)

            sides.append(sheet(surface, n, n))
    return weld(*sides)


def capped_cylinder(
    radius: float = 5.0, height: float = 12.0, nu: int = 36, nv: int = 8, rings: int = 4
) -> Mesh:
    """Solid cylinder: wall and two discs, facing out."""

    def disc(z: float, up: bool) -> Mesh:
        def surface(u: FloatArray, v: FloatArray) -> FloatArray:
            t = TURN * (u if not up else 1.0 - u)
            return np.column_stack(
                [radius * v * np.cos(t), radius * v * np.sin(t), np.full(len(u), z)]
            )

        return sheet(surface, nu, rings)

    return weld(cylinder(radius, height, nu, nv), disc(0.0, False), disc(height, True))


def helicoid(lead: float = 10.0, nu: int = 60, nv: int = 10) -> Mesh:
    """The flank of a square thread: rho from 3 to 8, 1.3 turns."""

    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        t, rho = 1.3 * TURN * u, 3.0 + 5.0 * v
        return np.column_stack([rho * np.cos(t), rho * np.sin(t), lead * t / TURN])

    return sheet(surface, nu, nv)


def extrusion(nu: int = 40, nv: int = 12) -> Mesh:
    """A sine wave drawn along z."""
    return sheet(lambda u, v: np.column_stack([20.0 * u, 3.0 * np.sin(TURN * u), 15.0 * v]), nu, nv)


def freeform(n: int = 30) -> Mesh:
    """A cubic patch without any symmetry."""

    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        x, y = 20.0 * u - 10.0, 20.0 * v - 10.0
        z = 0.03 * x * y + 0.02 * x**2 - 0.01 * y**2 + 0.004 * x**3 - 0.003 * x * y**2
        return np.column_stack([x, y, z])

    return sheet(surface, n, n)


def flipped(mesh: Mesh) -> Mesh:
    return Mesh(mesh.vertices, mesh.triangles[:, ::-1])


def moved(mesh: Mesh, pose: "Pose") -> Mesh:
    return Mesh(pose.point(mesh.vertices), mesh.triangles)


def relabelled(mesh: Mesh, seed: int) -> tuple[Mesh, IntArray]:
    """The mesh with vertices and triangles shuffled and corners rotated; and the facets' order."""
    rng = np.random.default_rng(seed)
    vertex = rng.permutation(len(mesh.vertices))
    rank = np.argsort(vertex)
    facets = rng.permutation(len(mesh.triangles))
    triangles = rank[mesh.triangles[facets]]
    turn = rng.integers(0, 3, len(triangles))[:, None]
    triangles = np.take_along_axis(triangles, (np.arange(3) + turn) % 3, axis=1)
    return Mesh(mesh.vertices[vertex], triangles), facets


class Pose:
    """A similarity: scale, rotation, translation."""

    def __init__(self, seed: int, scale: float, shift: float) -> None:
        rng = np.random.default_rng(seed)
        # A quaternion: uniform, and the same in every version of scipy.
        self.rotation = Rotation.from_quat(rng.normal(size=4)).as_matrix()
        self.scale = scale
        self.translation = scale * shift * rng.normal(size=3)

    def __repr__(self) -> str:
        return f"Pose(scale={self.scale}, translation={self.translation})"

    def point(self, p: FloatArray) -> FloatArray:
        return self.scale * p @ self.rotation.T + self.translation

    def vector(self, v: FloatArray) -> FloatArray:
        return v @ self.rotation.T


def poses(scales: tuple[float, ...] = (1e-3, 1.0, 25.4)) -> st.SearchStrategy[Pose]:
    """Random poses: the units metre, millimetre and inch, and offsets of a few part sizes."""
    return st.builds(
        Pose, st.integers(0, 10**6), st.sampled_from(scales), st.sampled_from([0.0, 50.0])
    )


def samples(name: str, n: int = 1500, seed: int = 1) -> tuple[FloatArray, FloatArray]:
    """Random points and exact normals on a surface of each class, none special in position."""
    a, b = np.random.default_rng(seed).random((2, n))
    zero, one = np.zeros(n), np.ones(n)
    t = TURN * a
    if name == "planar":
        p, q = np.column_stack([30.0 * a, 20.0 * b, zero]), np.column_stack([zero, zero, one])
    elif name in ("cylindrical", "quarter cylinder"):
        t = t if name == "cylindrical" else t / 4.0
        q = np.column_stack([np.cos(t), np.sin(t), zero])
        p = 5.0 * q + np.column_stack([zero, zero, 20.0 * b])
    elif name in ("spherical", "sphere"):
        z = 1.0 - b if name == "spherical" else 1.0 - 2.0 * b
        r = np.sqrt(1.0 - z * z)
        q = np.column_stack([r * np.cos(t), r * np.sin(t), z])
        p = 7.0 * q
    elif name == "revolute":
        f = TURN * b
        q = np.column_stack([np.cos(f) * np.cos(t), np.cos(f) * np.sin(t), np.sin(f)])
        p = np.column_stack([10.0 * np.cos(t), 10.0 * np.sin(t), zero]) + 3.0 * q
    elif name == "prismatic":
        x = 20.0 * a
        p = np.column_stack([x, 3.0 * np.sin(x / 3.0), 20.0 * b])
        q = np.column_stack([-np.cos(x / 3.0), one, zero])
    elif name == "helical":
        t, rho, c = 1.3 * t, 3.0 + 5.0 * b, 10.0 / TURN
        p = np.column_stack([rho * np.cos(t), rho * np.sin(t), c * t])
        q = np.column_stack([c * np.sin(t), -c * np.cos(t), rho])
    else:
        x, y = 20.0 * a - 10.0, 20.0 * b - 10.0
        z = 0.03 * x * y + 0.02 * x**2 - 0.01 * y**2 + 0.004 * x**3 - 0.003 * x * y**2
        p = np.column_stack([x, y, z])
        q = np.column_stack(
            [
                -(0.03 * y + 0.04 * x + 0.012 * x**2 - 0.003 * y**2),
                -(0.03 * x - 0.02 * y - 0.006 * x * y),
                one,
            ]
        )
    return p, q / np.linalg.norm(q, axis=1, keepdims=True)


def edge_set(mesh: Mesh, chosen: BoolArray) -> set[tuple[int, int]]:
    """Edges as pairs of vertices, smaller first."""
    return {(int(a), int(b)) for a, b in np.sort(mesh.pair_edges[chosen], axis=1)}
