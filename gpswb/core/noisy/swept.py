# SPDX-License-Identifier: LGPL-2.1-or-later
"""A swept surface of a noisy region: a motion, and a cubic spline for the profile it carries."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.interpolate import BSpline
from scipy.spatial import cKDTree

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray
from gpswb.core.noisy.models import EXCESS, SURE
from gpswb.core.noisy.profile_length import quotient_gradient
from gpswb.core.quotient import axis_coordinates, quotient_coordinates
from gpswb.core.reference import Reference

MOTIONS: dict[InvarianceClass, int] = {"prismatic": 2, "revolute": 4, "helical": 5}
"""Classes of one motion, simplest first, with the unknowns of the motion."""

OUTSIDE = 4.0
"""Distance in sigma beyond which a vertex counts as if it were so far: it is a stray."""

TABLE = 400
"""Points of a profile among which the nearest is looked up."""


@dataclass(frozen=True, eq=False)
class Swept:
    """A swept surface and how well it explains its vertices.

    Args:
        invariance_class: prismatic, revolute or helical.
        reference: the motion.
        curve: the profile, in quotient coordinates.
        side: +1 or -1, the side of the surface that is outside.
        chi: sum of the squared distances over sigma², each at most ``OUTSIDE``².
        count: number of vertices n.
    """

    invariance_class: InvarianceClass
    reference: Reference
    curve: BSpline
    side: float
    chi: float
    count: int

    def price(self, count: int) -> float:
        """What the unknowns of motion and profile cost, in the unit of chi-square."""
        return (MOTIONS[self.invariance_class] + len(self.curve.c)) * float(np.log(max(count, 2)))

    @property
    def cost(self) -> float:
        """Chi-square and the price: smaller is likelier."""
        return self.chi + self.price(self.count)

    @property
    def explains(self) -> bool:
        """Whether the distances are those of noise."""
        return self.chi / self.count <= EXCESS + SURE * float(np.sqrt(2.0 / self.count))

    @cached_property
    def _table(self) -> tuple[cKDTree, FloatArray, FloatArray]:
        """Points (k, 2) along the profile, to look up, and unit tangents there."""
        t = np.linspace(self.curve.t[3], self.curve.t[-4], TABLE)
        slope = self.curve(t, 1)
        slope /= np.maximum(np.linalg.norm(slope, axis=1, keepdims=True), 1e-300)
        point = self.curve(t)
        return cKDTree(point), point, slope

    def along(self, points: FloatArray) -> tuple[FloatArray, FloatArray]:
        """(n,) length along the profile at which points (n, 3) are nearest to it, in the unit of
        the quotient coordinates, and (n, 2) those coordinates."""
        tree, point, tangent = self._table
        quotient = profile_coordinates(points, self.invariance_class, self.reference, self.curve)
        _, near = tree.query(quotient)
        step = np.linalg.norm(np.diff(point, axis=0), axis=1)
        reach = np.concatenate([[0.0], np.cumsum(step)])
        return reach[near] + np.einsum("nq,nq->n", quotient - point[near], tangent[near]), quotient

    def distance(self, points: FloatArray) -> tuple[FloatArray, FloatArray]:
        """(n,) mm signed distances of points (n, 3), and (n, 3) unit normals of the surface there.

        Beyond an end of the profile it is the distance to that end.
        """
        tree, point, tangent = self._table
        quotient = profile_coordinates(points, self.invariance_class, self.reference, self.curve)
        _, near = tree.query(quotient)
        gap, tangent = quotient - point[near], tangent[near]
        normal = np.column_stack([-tangent[:, 1], tangent[:, 0]])
        height = np.einsum("nq,nq->n", gap, normal)
        beyond = np.einsum("nq,nq->n", gap, tangent)
        past = ((near == 0) & (beyond < 0.0)) | ((near == len(point) - 1) & (beyond > 0.0))
        height = np.where(
            past, np.where(height < 0.0, -1.0, 1.0) * np.hypot(height, beyond), height
        )
        gradient = quotient_gradient(points, self.invariance_class, self.reference)
        across = np.einsum("nqk,nq->nk", gradient, normal)
        stretch = np.maximum(np.linalg.norm(across, axis=1), 1e-300)
        return height / stretch, across / stretch[:, None]


def profile_coordinates(
    points: FloatArray, name: InvarianceClass, reference: Reference, curve: BSpline | None
) -> FloatArray:
    """Quotient coordinates (n, 2) of points (n, 3), helical heights within half a lead of the
    curve's: `quotient_coordinates` counts them from where they leave the largest gap, which depends
    on the points. Without a curve they are cut at that gap."""
    quotient = quotient_coordinates(points, name, reference)
    if name == "helical":
        about = axis_coordinates(points, reference)
        height = about.z - reference.lead / (2.0 * np.pi) * about.phi
        middle = float(curve.c[:, 1].mean()) if curve is not None else 0.0
        if curve is None:
            shift = height[0] - quotient[0, 1]
            middle = shift + 0.5 * float(quotient[:, 1].min() + quotient[:, 1].max())
        lead = abs(reference.lead)
        quotient[:, 1] = height - lead * np.round((height - middle) / lead)
    return quotient
