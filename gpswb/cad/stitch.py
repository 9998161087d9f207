# SPDX-License-Identifier: LGPL-2.1-or-later
"""Last repairs of a body's mesh: borders that touch but share no B-rep edge, inverted bodies."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from gpswb.cad.faced import FacedMesh, open_sides
from gpswb.core.mesh import IntArray


def stitch(mesh: FacedMesh, tolerance: float) -> FacedMesh:
    """Weld vertices on open borders that lie within ``tolerance`` (mm) of each other.

    For shells whose faces don't share their edges: where the borders were cut alike, they close.
    It is done only if no side comes to have two triangles on the same side of it.
    """
    border = open_sides(mesh.triangles)
    if not border.any():
        return mesh
    ends = np.unique(
        np.concatenate([mesh.triangles[border], np.roll(mesh.triangles, -1, axis=1)[border]])
    )
    pairs = cKDTree(mesh.vertices[ends]).query_pairs(tolerance, output_type="ndarray")
    if not len(pairs):
        return mesh
    n = len(mesh.vertices)
    a, b = ends[pairs].T
    label = connected_components(coo_matrix((np.ones(len(a)), (a, b)), shape=(n, n)), False)[1]
    _, first, vertex = np.unique(label, return_index=True, return_inverse=True)
    triangles = vertex[mesh.triangles]
    keep = (triangles != np.roll(triangles, -1, axis=1)).all(axis=1)
    triangles = triangles[keep]
    if _excess(triangles) > _excess(mesh.triangles):
        return mesh
    return FacedMesh(mesh.vertices[first], triangles, mesh.face[keep])


def outward(mesh: FacedMesh) -> FacedMesh:
    """Turn a closed body that encloses a negative volume inside out; leave any other as it is."""
    if open_sides(mesh.triangles).any() or signed_volume(mesh) >= 0:
        return mesh
    return FacedMesh(mesh.vertices, np.ascontiguousarray(mesh.triangles[:, ::-1]), mesh.face)


def signed_volume(mesh: FacedMesh) -> float:
    """Volume enclosed by a closed mesh, mm³; negative if its triangles look inwards."""
    if not len(mesh.triangles):
        return 0.0
    corner = mesh.vertices[mesh.triangles] - mesh.vertices.mean(axis=0)
    return float(np.einsum("ij,ij->", corner[:, 0], np.cross(corner[:, 1], corner[:, 2])) / 6)


def _excess(triangles: IntArray) -> int:
    """Sides that two triangles run along in the same direction: more than two triangles meet there,
    or two that look opposite ways."""
    ways = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2)
    return len(ways) - len(np.unique(ways, axis=0))
