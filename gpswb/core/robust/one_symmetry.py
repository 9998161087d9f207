# SPDX-License-Identifier: LGPL-2.1-or-later
"""The symmetry that two regions have together."""

from __future__ import annotations

import numpy as np

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import BoolArray, IntArray, Mesh
from gpswb.core.recognition import allowed_slip, slip_of, weigh
from gpswb.core.reference import Reference
from gpswb.core.region_samples import RegionSample, confined_normals, region_samples
from gpswb.core.robust.decide import by_gap
from gpswb.core.tolerances import Tolerances


class Symmetries:
    """Symmetries of the unions of regions, while regions are joined.

    Args:
        mesh: the mesh.
        crease: (e,) feature edges, aligned with ``mesh.facet_pairs``.
        region: (m,) region of each facet, -1 for none.
        sigma: noise of the vertices, mm.
        tolerances: thresholds of recognition.
    """

    def __init__(
        self,
        mesh: Mesh,
        crease: BoolArray,
        region: IntArray,
        sigma: float,
        tolerances: Tolerances,
    ) -> None:
        self._mesh, self._crease = mesh, crease
        self._sigma, self._tolerances = sigma, tolerances
        self.region = region

    @property
    def size(self) -> IntArray:
        """Number of facets of each region."""
        return np.bincount(self.region[self.region >= 0])

    def of_union(self, a: int, b: int) -> tuple[InvarianceClass, Reference]:
        """Class that fits regions a and b together best, and its reference parameters."""
        union = np.where((self.region == a) | (self.region == b), 0, -1)
        evidence = weigh(self._samples(union, 1)[0], self._sigma, self._tolerances)
        name = by_gap(evidence, {})
        return name, evidence.references[name]

    def follow(self, a: int, b: int, name: InvarianceClass, reference: Reference) -> bool:
        """Whether regions a and b are each tangent to the motions of a class: vertices of a small
        piece lie on almost any profile."""
        both = np.where(self.region == a, 0, np.where(self.region == b, 1, -1))
        return all(
            slip_of(s.points, s.normals, s.weights, name, reference) <= allowed_slip(s, self._sigma)
            for s in self._samples(both, 2)
        )

    def join(self, kept: IntArray, gone: IntArray, count: int) -> None:
        """Let each region ``kept`` (p,) take ``gone`` (p,), of so many regions."""
        now = np.arange(count)
        now[gone] = kept
        self.region = np.where(self.region >= 0, now[self.region], -1)

    def _samples(self, region: IntArray, count: int) -> list[RegionSample]:
        normals = confined_normals(self._mesh, region, self._crease)
        return list(region_samples(self._mesh, region, count, normals))
