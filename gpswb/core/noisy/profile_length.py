# SPDX-License-Identifier: LGPL-2.1-or-later
"""Length along the profile that a motion carries, at the vertices of a noisy region.

A region of one motion is a curve in quotient space. Noise makes a band of it, in which neighbours
say nothing of the order of points along the curve. The mesh does: the length is the function on the
vertices whose differences along edges are, in least squares, those of the quotient coordinates
along the profile's tangent, which the denoised normals give.
"""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_matrix, csr_matrix, diags
from scipy.sparse.csgraph import breadth_first_order
from scipy.sparse.linalg import spsolve

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray, IntArray
from gpswb.core.noisy.noisy_mesh import NoisyMesh
from gpswb.core.quotient import axis_coordinates, quotient_coordinates
from gpswb.core.reference import Reference, axis_frame

CLOSED = 0.25
"""Share of the whole length by which two ways to a vertex differ in length only where the profile
is closed: noise makes them differ by a few sigma."""


def profile_length(
    noisy: NoisyMesh, facets: IntArray, name: InvarianceClass, reference: Reference
) -> tuple[IntArray, FloatArray]:
    """Length along the profile at each vertex of a region.

    A closed profile is cut opposite to where the count begins.

    Args:
        noisy: the mesh and its noise.
        facets: (k,) connected facets.
        name: prismatic, revolute or helical.
        reference: the motion.

    Returns:
        (n,) the region's vertices and (n,) mm from an arbitrary zero.
    """
    mesh = noisy.mesh
    vertices, local = np.unique(mesh.triangles[facets], return_inverse=True)
    local = local.reshape(-1, 3)
    quotient = quotient_coordinates(mesh.vertices[vertices], name, reference)
    gradient = quotient_gradient(mesh.centroids[facets], name, reference)
    across = np.einsum("fqk,fk->fq", gradient, noisy.normals[facets])
    across /= np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-300)
    tangent = np.repeat(np.column_stack([-across[:, 1], across[:, 0]]), 3, axis=0)
    row, col = local.ravel(), np.roll(local, -1, axis=1).ravel()
    gap = quotient[col] - quotient[row]
    if name == "helical":
        # Heights are counted within one lead.
        gap[:, 1] -= abs(reference.lead) * np.round(gap[:, 1] / abs(reference.lead))
    ahead = np.einsum("eq,eq->e", gap, tangent)
    n = len(vertices)
    rough = _along_tree(row, col, ahead, n)
    kept = np.abs(rough[col] - rough[row] - ahead) < CLOSED * float(np.ptp(rough))
    row, col, ahead = row[kept], col[kept], ahead[kept]
    edge = coo_matrix((np.ones(len(row)), (row, col)), shape=(n, n)).tocsr()
    edge = edge + edge.T
    right = np.bincount(col, ahead, n) - np.bincount(row, ahead, n)
    # The small diagonal holds the arbitrary zero.
    degree = np.asarray(edge.sum(axis=1)).ravel() + 1e-9
    length: FloatArray = spsolve((diags(degree) - edge).tocsc(), right)
    return vertices, length


def _along_tree(row: IntArray, col: IntArray, ahead: FloatArray, n: int) -> FloatArray:
    """(n,) sums of ``ahead`` (e,) along the ways of fewest edges from one vertex."""
    number = np.arange(1, len(row) + 1)
    both = coo_matrix(
        (
            np.concatenate([number, -number]),
            (np.concatenate([row, col]), np.concatenate([col, row])),
        ),
        shape=(n, n),
    )
    # Each edge of two facets comes twice, and once is enough.
    one = np.unique(both.row * n + both.col, return_index=True)[1]
    step = csr_matrix((both.data[one], (both.row[one], both.col[one])), shape=(n, n))
    order, before = breadth_first_order(abs(step), int(row[0]))
    last = order[1:]
    code = np.asarray(step[before[last], last]).ravel()
    gain = np.zeros(n)
    gain[last] = np.sign(code) * ahead[np.abs(code) - 1]
    total = gain
    parent = np.where(before < 0, np.arange(n), before)
    while True:
        # Pointer jumping: each round doubles the length of way that is summed.
        further = parent[parent]
        if (further == parent).all():
            return total
        total = total + np.where(parent != np.arange(n), total[parent], 0.0)
        parent = further


def quotient_gradient(
    points: FloatArray, name: InvarianceClass, reference: Reference
) -> FloatArray:
    """(n, 2, 3) gradients of the two quotient coordinates of a motion at points (n, 3)."""
    u, v, d = axis_frame(reference.direction)
    if name == "prismatic":
        return np.broadcast_to(np.array([u, v]), (len(points), 2, 3))
    about = axis_coordinates(points, reference)
    cos, sin = np.cos(about.phi)[:, None], np.sin(about.phi)[:, None]
    along = np.broadcast_to(d, (len(points), 3))
    if name == "helical":
        pitch = reference.lead / (2.0 * np.pi)
        along = along - pitch * (cos * v - sin * u) / np.maximum(about.rho, 1e-300)[:, None]
    return np.stack([cos * u + sin * v, along], axis=1)
