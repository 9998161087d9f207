# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far points stand off a surface of a given class: thickness in quotient space (design, 5)."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray, IntArray
from gpswb.core.quotient import axis_coordinates, quotient_coordinates
from gpswb.core.reference import Reference, axis_frame, spread

_SAMPLES = 400
_NEIGHBOURS = 12
_KEPT = 0.95
CONSISTENT = 0.8711
"""RMS of a standard normal deviate without its outermost 5 %."""


def thickness(points: FloatArray, invariance_class: InvarianceClass, reference: Reference) -> float:
    """RMS distance of points to the best surface of a class with the given reference, mm.

    For planar, spherical and cylindrical the scatter of the one quotient coordinate; for prismatic,
    revolute and helical the scatter of the projected points about their own profile, a quadratic
    through the nearest projected points; the outermost 5 % are left out. Complex fits all: 0.

    Args:
        points: (n, 3) mm, n >= 1; where fewer than 6 points leave a profile undetermined it is 0.
    """
    if invariance_class == "complex":
        return 0.0
    quotient = quotient_coordinates(points, invariance_class, reference)
    if quotient.shape[1] == 1:
        return float(quotient.std())
    if len(points) < 6:
        return 0.0
    offset, _ = profile_offsets(quotient, None)
    if not len(offset):
        return 0.0
    return float(np.sqrt(np.mean(offset[near_profile(offset)] ** 2))) / CONSISTENT


def near_profile(offset: FloatArray) -> IntArray:
    """Indices of all but the largest offsets: those are where a profile bends within its samples,
    or where its two sides come nearer than they are apart (a trailing edge)."""
    return np.argsort(np.abs(offset))[: int(np.ceil(_KEPT * len(offset)))]


def profile_offsets(
    quotient: FloatArray, jacobian: FloatArray | None
) -> tuple[FloatArray, FloatArray]:
    """Signed distances (s,) of sampled points between their neighbours to the quadratic through
    them.

    With the Jacobian (n, 2, q) of the quotient coordinates, also that of the distances (s, q): the
    fit is linear in the neighbours' offsets, so its weights carry over.
    """
    n = len(quotient)
    sample = spread(n, _SAMPLES)
    k = min(_NEIGHBOURS, max(5, n // 6))
    _, near = cKDTree(quotient).query(quotient[sample], k=k + 1)
    near = np.where(near == sample[:, None], near[:, [-1]], near)[:, :k]
    relative = quotient[near] - quotient[sample][:, None]
    # About the mean of the neighbours and the sample itself, which lies at the origin here.
    mean = relative.sum(axis=1, keepdims=True) / (k + 1.0)
    centred = relative - mean
    covariance = np.swapaxes(centred, 1, 2) @ centred + np.swapaxes(mean, 1, 2) @ mean
    angle = 0.5 * np.arctan2(2 * covariance[:, 0, 1], covariance[:, 0, 0] - covariance[:, 1, 1])
    tangent = np.column_stack([np.cos(angle), np.sin(angle)])
    normal = np.column_stack([-tangent[:, 1], tangent[:, 0]])
    along = np.einsum("ska,sa->sk", relative, tangent)
    # At an end of the profile, or beyond a gap, there is nothing to interpolate.
    inner = (along.min(axis=1) <= 0.0) & (along.max(axis=1) >= 0.0)
    scale = np.maximum(np.abs(along).max(axis=1, keepdims=True), 1e-300)
    along = along / scale
    design = np.stack([np.ones_like(along), along, along**2], axis=2)
    # The ridge keeps coincident neighbours (rings of a structured mesh) solvable: their mean
    # counts.
    gram = np.swapaxes(design, 1, 2) @ design + 1e-6 * k * np.diag([0.0, 1.0, 1.0])
    # The value at the sample itself: the first row of the inverse, which is its first column.
    first = np.linalg.solve(gram, np.broadcast_to([[1.0], [0.0], [0.0]], (len(gram), 3, 1)))
    weight = (design @ first)[..., 0]
    across = np.einsum("ska,sa->sk", relative, normal)
    offset: FloatArray = -np.einsum("sk,sk->s", weight, across)[inner]
    if jacobian is None:
        return offset, np.zeros((len(offset), 0))
    predicted = np.einsum("sk,skaq->saq", weight, jacobian[near])
    change: FloatArray = np.einsum("sa,saq->sq", normal, jacobian[sample] - predicted)[inner]
    return offset, change


def quotient_jacobian(
    points: FloatArray, invariance_class: InvarianceClass, reference: Reference
) -> FloatArray:
    """(n, 2, q) change of the quotient coordinates with tilt (2), shift (2) and lead of the
    axis."""
    n = len(points)
    if invariance_class == "prismatic":
        z = (points - reference.point) @ axis_frame(reference.direction)[2]
        jacobian = np.zeros((n, 2, 2))
        jacobian[:, 0, 0] = jacobian[:, 1, 1] = -z
        return jacobian
    about = axis_coordinates(points, reference)
    rho, z = about.rho, about.z
    cos, sin = np.cos(about.phi), np.sin(about.phi)
    d_rho = np.stack([-z * cos, -z * sin, -cos, -sin], axis=1)
    d_z = np.stack([rho * cos, rho * sin, 0 * z, 0 * z], axis=1)
    if invariance_class == "revolute":
        return np.stack([d_rho, d_z], axis=1)
    pitch = reference.lead / (2.0 * np.pi)
    safe = np.maximum(rho, 1e-9 * float(rho.max(initial=1.0)))
    d_phi = np.stack([z * sin, -z * cos, sin, -cos], axis=1) / safe[:, None]
    height = quotient_coordinates(points, "helical", reference)[:, 1]
    # h = z - c (phi + turns): the turns differ from point to point once h is unwrapped.
    turns = np.round((z - pitch * about.phi - height) / (2.0 * np.pi * pitch))
    angle = about.phi + 2.0 * np.pi * turns
    d_h = np.column_stack([d_z - pitch * d_phi, -angle / (2.0 * np.pi)])
    return np.stack([np.column_stack([d_rho, np.zeros(n)]), d_h], axis=1)
