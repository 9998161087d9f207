# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a measured point cloud to a mesh through its points."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.errors import InputError
from gpswb.scan.advancing_front import advance
from gpswb.scan.empty_spheres import EmptySpheres, empty_spheres
from gpswb.scan.orientation import components
from gpswb.scan.outliers import lonely
from gpswb.scan.repair import orient, topology_notes
from gpswb.scan.thinning import thin
from gpswb.sentence import Sentence

MOST_POINTS = 5_000_000
"""Points read at most: memory, about 1 GB then."""

MOST_VERTICES = 50_000
"""Points kept for the mesh at most: about 100,000 triangles, as in the default density of parts."""

LEAST_POINTS = 4
"""Fewer distinct points make one triangle or none."""

NEIGHBOURS = 6
"""Neighbours in a mesh's ring: the distance to the sixth is the local spacing."""

BRIDGE = 2.0
"""Largest empty sphere of a triangle, in local spacings: wider gaps stay holes. A sample as random
as a scan's leaves empty circles of up to about 1.5 spacings."""

SPECK = 0.01
"""Components of fewer vertices than this share of the largest one's, and fewer than ``CROWD``, are
strays that lay together."""

CROWD = 12
"""Vertices from which on a component counts whatever its share: a region of as many facets can be
recognised."""


@dataclass(frozen=True, eq=False)
class MeshedCloud:
    """A mesh through a cloud's points, and where each point went.

    Args:
        mesh: the mesh, mm; every vertex is a measured point.
        vertex_of_point: (n,) int64 the vertex that stands for each point; -1 for points set aside.
        notes: what was done, with counts.
    """

    mesh: Mesh
    vertex_of_point: IntArray
    notes: tuple[str, ...]


def mesh_cloud(points: FloatArray, most: int = MOST_VERTICES) -> MeshedCloud:
    """Mesh a point cloud.

    Equal points are one; a cloud of more than ``most`` points is thinned by a grid; outliers are
    set aside; a surface is grown through the rest.

    Args:
        points: (n, 3) finite, mm.
        most: vertices at most.

    Raises:
        InputError: too many points, or too few different ones for a surface.
    """
    n = len(points)
    if n > MOST_POINTS:
        raise InputError(
            Sentence("{n} points are more than {most}: thin the cloud first", n=n, most=MOST_POINTS)
        )
    distinct, copy = np.unique(points, axis=0, return_inverse=True)
    copy = copy.reshape(-1)
    if len(distinct) < LEAST_POINTS:
        raise InputError(
            Sentence(
                "{different} different points among {n}: a surface needs at least {least}",
                different=len(distinct),
                n=n,
                least=LEAST_POINTS,
            )
        )
    notes: list[str] = []
    if len(distinct) < n:
        notes.append(f"{n - len(distinct)} of {n} points repeat others")
    kept, stands, edge = thin(distinct, most)
    if edge:
        notes.append(
            f"thinned from {len(distinct)} to {len(kept)} points: of those in each cube of "
            f"{edge:.4g} mm the one nearest to their mean"
        )
    x = distinct[kept]
    good = np.flatnonzero(~lonely(x))
    triangles = good[_surface(x[good])]
    triangles = triangles[~_specks(len(x), triangles)[triangles[:, 0]]]
    if not len(triangles):
        raise InputError(Sentence("no surface can be laid through {n} points", n=len(distinct)))
    used = np.unique(triangles)
    vertex = _stand_ins(x, used)
    lost = int((vertex[stands[copy]] < 0).sum())
    if lost:
        notes.append(f"{lost} points set aside as outliers: they lie apart from all surfaces")
    left = int((vertex >= 0).sum()) - len(used)
    if left:
        notes.append(f"{left} points are no vertices; each takes the label of the nearest")
    mesh, _, _ = orient(Mesh(x[used], vertex[triangles]))
    return MeshedCloud(mesh, vertex[stands[copy]], (*notes, *topology_notes(mesh)))


def _surface(x: FloatArray) -> IntArray:
    """(m, 3) triangles of a surface through the points."""
    if len(x) < LEAST_POINTS:
        return np.zeros((0, 3), dtype=np.int64)
    local = _spacing(x)
    spheres = empty_spheres(x, float(np.median(local)))
    near = spheres.radius <= BRIDGE * local[spheres.triangles].max(axis=1)
    return advance(x, EmptySpheres(spheres.triangles[near], spheres.radius[near]))


def _spacing(x: FloatArray) -> FloatArray:
    """(k,) distance of each point to its sixth neighbour, or to the last there is; mm."""
    near: FloatArray = cKDTree(x).query(x, k=min(NEIGHBOURS + 1, len(x)))[0][:, -1]
    return near


def _specks(n: int, triangles: IntArray) -> BoolArray:
    """(n,) bool: vertices of components that are too small to be a surface."""
    if not len(triangles):
        return np.zeros(n, dtype=bool)
    part = components(n, triangles)
    used = np.zeros(n, dtype=bool)
    used[triangles] = True
    size = np.bincount(part[used], minlength=int(part.max()) + 1)
    small = (size < SPECK * size.max()) & (size < CROWD)
    return np.asarray(used & small[part])


def _stand_ins(x: FloatArray, used: IntArray) -> IntArray:
    """(k,) the vertex of each point: its own, the nearest if that is near, or -1: a stray."""
    vertex = np.full(len(x), -1, dtype=np.int64)
    vertex[used] = np.arange(len(used))
    left = np.flatnonzero(vertex < 0)
    if len(left):
        tree = cKDTree(x[used])
        far, nearest = tree.query(x[left])
        near = far <= _spacing(x[used])[nearest]
        vertex[left[near]] = nearest[near]
    return vertex
