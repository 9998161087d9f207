# SPDX-License-Identifier: LGPL-2.1-or-later
"""The class of a region by parsimony, unless a less symmetric class fits incomparably better."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray
from gpswb.core.quotient import quotient_coordinates
from gpswb.core.recognition import PARSIMONY, Choice, Evidence
from gpswb.core.reference import Reference

GAP = 20.0
"""Factor by which a wrong class stands off further than a right one, at least: nominal vertices lie
on their surface to rounding, on another they are off by orders of magnitude."""

PLACES = 8
"""Places on a profile that prove it: two rings of a cylinder lie on any surface of revolution."""

ROUNDING = 0.01
"""Share of the allowed distance below which stand-offs say no more than that all fit."""


def unless_far_better(name: InvarianceClass, residual: float, points: FloatArray) -> Choice:
    """The class of a simple surface, unless a less symmetric class fits incomparably better.

    A narrow strip of a blade lies on a torus to within a wide tolerance, but on a helicoid exactly.

    Args:
        name: class of the surface.
        residual: distance of the region's vertices from it, mm.
        points: (n, 3) mm, those vertices.
    """

    def choose(evidence: Evidence, likelihoods: Mapping[InvarianceClass, float]) -> InvarianceClass:
        rank = PARSIMONY.index(name)
        weaker = [
            evidence.stand_off[n]
            for n in PARSIMONY[rank + 1 : -1]
            if evidence.fits(n) and _places(points, n, evidence.references[n]) >= PLACES
        ]
        floor = ROUNDING * evidence.distance["planar"]
        if weaker and residual > max(floor, GAP * min(weaker)):
            return by_gap(evidence, likelihoods)
        return name

    return choose


def _places(points: FloatArray, name: InvarianceClass, reference: Reference) -> int:
    """Number of different places on a class's profile at which points lie, told apart by a
    fiftieth of what they span."""
    quotient = quotient_coordinates(points, name, reference)
    step = float(np.ptp(quotient, axis=0).max(initial=0.0)) / 50.0
    if not (np.isfinite(step) and step > 0.0):
        return 1
    return len(np.unique(np.round(quotient / step), axis=0))


def by_gap(evidence: Evidence, likelihoods: Mapping[InvarianceClass, float]) -> InvarianceClass:
    """The most symmetric class that fits about as well as the less symmetric ones that fit.

    A narrow cone lies on a sphere to within a tolerance, but on the cone far better.
    """
    floor = ROUNDING * evidence.distance["planar"]
    for rank, name in enumerate(PARSIMONY[:-1]):
        if not evidence.fits(name):
            continue
        weaker = [evidence.stand_off[n] for n in PARSIMONY[rank + 1 : -1] if evidence.fits(n)]
        if evidence.stand_off[name] <= max(floor, GAP * min(weaker, default=float("inf"))):
            return name
    return "complex"
