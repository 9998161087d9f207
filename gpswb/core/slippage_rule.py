# SPDX-License-Identifier: LGPL-2.1-or-later
"""The merge rule with its errors mended: additive moments, joint frame, no loss of symmetry."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gpswb.core.mesh import BoolArray, FloatArray, IntArray
from gpswb.core.quadric_moments import cylinder_stand_off, plane_stand_off, sphere_stand_off
from gpswb.core.similarity import signature_similarity
from gpswb.core.slippage import SlippageMoments, slippable_motions, slippage_values

_SMALL = 0.2  # a region of few facets may lose a motion to one five times its area
_TINY = 1e-9  # least score of a merge that is allowed at all; confidences only order merges


@dataclass(eq=False)
class MergeState:
    """Additive moments of r regions, all in one frame scaled to the mesh's diagonal.

    Args:
        motion, metric: (r, 6, 6) slippage moments M and V.
        quadric: (r, 10, 10) moments of the quadratic monomials of the vertices.
        facets: (r,) number of facets that the moments were taken over.
        turning: (r, 2) sum of squared turning angles of the interior edges, and their number.
    """

    motion: FloatArray
    metric: FloatArray
    quadric: FloatArray
    facets: IntArray
    turning: FloatArray


@dataclass(frozen=True)
class MergeLimits:
    """Limits of one merging pass, as pure numbers in the frame of the moments.

    A motion is slippable when mu <= slippable + coarse * mean squared turning angle: normals at a
    border that mixes two surfaces are off by a share of the turning.
    """

    slippable: float
    coarse: float
    stand_off: float
    similarity: float
    signature_width: float
    confident_facets: int


class SlippageRule:
    """Two regions may merge when they share k motions, keep them together, and lie on one surface.

    Mended against the print: M x = mu V x, so that nothing depends on unit or origin; signatures
    compared under the metric of the union; the union must itself have the motions; no confident
    region may lose one; where the union slips in two ways or more it must lie on one plane, sphere
    or cylinder; the confidences C only order the merges. With ``k = 0`` regions without any motion
    merge, so that a freeform face cut up by its shape types is one complex region.

    Args:
        state: moments, which the rule owns and adds up.
        k: number of motions that must agree, 0 to 3; may be set anew between merging rounds.
        limits: thresholds.
    """

    def __init__(self, state: MergeState, k: int, limits: MergeLimits) -> None:
        self._state, self.k, self._limits = state, k, limits
        self._mu, self._twist = slippable_motions(SlippageMoments(state.motion, state.metric))
        self._motions = self._slips(np.arange(len(self._mu))).sum(axis=1)

    def score(self, first: IntArray, second: IntArray) -> FloatArray:
        """Score (p,) of each pair: 0 where the merge is forbidden."""
        score = np.zeros(len(first))
        # Each question is asked only of the pairs that the cheaper ones before it leave.
        left = np.flatnonzero(self._may_merge(first, second))
        if not len(left):
            return score
        first, second = first[left], second[left]
        joint = self._joint_motions(first, second)
        kept = np.flatnonzero(self._keeps_motions(first, second, joint))
        left, first, second, joint = left[kept], first[kept], second[kept], joint[kept]
        if not self.k:
            score[left] = self._order(first, second)
        elif len(left):
            angle = self._agreement(first, second)
            kept = np.flatnonzero(angle >= self._limits.similarity)
            left, first, second = left[kept], first[kept], second[kept]
            one = self._one_surface(first, second, joint[kept])
            score[left] = np.where(one, angle[kept] * self._order(first, second), 0.0)
        return score

    def _may_merge(self, first: IntArray, second: IntArray) -> BoolArray:
        """Whether either region alone lets a pair merge: what is told without their union."""
        own, other = self._motions[first], self._motions[second]
        if self.k:
            may: BoolArray = (own >= self.k) & (other >= self.k)
        else:
            # A union without motions takes those of its parts.
            may = (own == 0) | ~self._sure(first, second)
            may &= (other == 0) | ~self._sure(second, first)
        return may

    def _sure(self, one: IntArray, other: IntArray) -> BoolArray:
        """Whether each region's motions are to be believed, beside another region."""
        area = self._state.metric[:, 3, 3]
        enough = self._state.facets[one] >= self._limits.confident_facets
        sure: BoolArray = enough | (area[one] >= _SMALL * area[other])
        return sure

    def _keeps_motions(self, first: IntArray, second: IntArray, joint: IntArray) -> BoolArray:
        """Whether the union has k motions, and all that are to be believed of its parts'."""
        kept: BoolArray = joint >= self.k if self.k else joint == 0
        for one, other in ((first, second), (second, first)):
            kept &= ~(self._sure(one, other) & (self._motions[one] > joint))
        return kept

    def _union(self, first: IntArray, second: IntArray) -> SlippageMoments:
        state = self._state
        return SlippageMoments(
            state.motion[first] + state.motion[second], state.metric[first] + state.metric[second]
        )

    def _joint_motions(self, first: IntArray, second: IntArray) -> IntArray:
        """(p,) number of slippable motions of each union."""
        limit = self._limit(self._state.turning[first] + self._state.turning[second])
        joint: IntArray = (slippage_values(self._union(first, second)) <= limit).sum(axis=1)
        return joint

    def join(self, kept: IntArray, gone: IntArray) -> None:
        """Add the moments and solve anew."""
        state = self._state
        for array in (state.motion, state.metric, state.quadric, state.facets, state.turning):
            array[kept] += array[gone]
        moments = SlippageMoments(state.motion[kept], state.metric[kept])
        self._mu[kept], self._twist[kept] = slippable_motions(moments)
        self._motions[kept] = self._slips(kept).sum(axis=1)

    def _limit(self, turning: FloatArray) -> FloatArray:
        """(p, 1) largest mu of a slippable motion."""
        mean = turning[:, [0]] / np.maximum(turning[:, [1]], 1.0)
        limit: FloatArray = self._limits.slippable + self._limits.coarse * mean
        return limit

    def _slips(self, index: IntArray) -> BoolArray:
        """(p, 6) which motions of each region are slippable."""
        slips: BoolArray = self._mu[index] <= self._limit(self._state.turning[index])
        return slips

    def _order(self, first: IntArray, second: IntArray) -> FloatArray:
        """C(P_i) C(P_j): large regions merge first."""
        share = np.minimum(1.0, self._state.facets / (4.0 * self._limits.confident_facets))
        order: FloatArray = np.maximum(share[first] * share[second], _TINY)
        return order

    def _agreement(self, first: IntArray, second: IntArray) -> FloatArray:
        """G(sigma_{k+1}) of the slippable motions under the metric of the union."""
        union = self._union(first, second)
        metric = union.metric / np.maximum(union.weight, 1e-300)[:, None, None]
        lower = np.swapaxes(np.linalg.cholesky(metric + 1e-10 * np.eye(6)), 1, 2)
        both = np.stack([first, second])
        # Motions ascend in mu, so orthonormalising keeps the slippable span in front.
        basis = np.linalg.qr(lower @ self._twist[both, :, :3])[0]
        basis *= np.arange(3) < self._motions[both][..., None, None]
        return signature_similarity(basis[0], basis[1], self.k, self._limits.signature_width)

    def _one_surface(self, first: IntArray, second: IntArray, joint: IntArray) -> BoolArray:
        """Whether unions that slip in two ways or more lie on one plane, sphere or cylinder."""
        union = self._union(first, second)
        quadric = self._state.quadric[first] + self._state.quadric[second]
        least = np.full(len(first), np.inf)
        least[joint < 2] = 0.0
        full = joint >= 3
        if full.any():
            least[full] = np.minimum(
                plane_stand_off(quadric[full]), sphere_stand_off(quadric[full])
            )
        two = joint == 2
        if two.any():
            _, twist = slippable_motions(SlippageMoments(union.motion[two], union.metric[two]))
            point, direction = _axes(twist[:, :, :2])
            least[two] = cylinder_stand_off(quadric[two], point, direction)
        allowed: BoolArray = least <= self._limits.stand_off * union.gyration
        return allowed


def _axes(twist: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Axis (point, direction) of two-dimensional motions (p, 6, 2) of cylinders."""
    omega = twist[:, :3, :]
    # All rotations of a cylinder share one axis: the leading left singular vector of the omegas.
    direction = np.linalg.svd(omega)[0][:, :, 0]
    share = np.einsum("pi,pik->pk", direction, omega)
    turn = np.einsum("pik,pk->pi", twist, share)
    squared = np.maximum(np.einsum("pk,pk->p", share, share), 1e-300)[:, None]
    # turn / squared is the unit rotation about the axis: its point is direction x t.
    point = np.cross(direction, turn[:, 3:]) / squared
    return point, direction
