# SPDX-License-Identifier: LGPL-2.1-or-later
"""A region whose surface is known before it is recognised."""

from __future__ import annotations

from functools import partial

from gpswb.core.invariance import InvarianceClass
from gpswb.core.likelihood import LogLikelihoods
from gpswb.core.partition import Region
from gpswb.core.recognition import PARSIMONY, margin, weigh
from gpswb.core.reference import SAMPLES, estimate_references
from gpswb.core.region_samples import RegionSample
from gpswb.core.situation import Description
from gpswb.core.tolerances import Tolerances

_SAMPLES = 500
"""Corners and vertices that more symmetric classes are fitted to: they are rejected by orders of
magnitude, or not at all."""


def known_region(
    number: int,
    sample: RegionSample,
    initial_regions: int,
    name: InvarianceClass,
    description: Description,
    residual: float,
    sigma: float,
    tolerances: Tolerances,
) -> Region:
    """The region of a surface, with the margin by which more symmetric classes are rejected.

    Args:
        number: its id.
        sample: the region.
        initial_regions: how many initial regions it was merged from.
        name: its class.
        description: its surface, situation and intrinsic characteristics.
        residual: RMS distance of its vertices from the surface, mm.
        sigma: noise of the vertices, mm.
        tolerances: thresholds.
    """
    classes = PARSIMONY[: PARSIMONY.index(name) + 1]
    evidence = weigh(sample.thinned(_SAMPLES), sigma, tolerances, classes, refined=False)
    read = sample.thinned(SAMPLES)
    surface, situation, intrinsic = description
    return Region(
        id=number,
        invariance_class=name,
        area=sample.area,
        triangles=len(sample.facets),
        surface=surface,
        situation=situation,
        intrinsic=intrinsic,
        residual=residual,
        margin=margin(evidence, name, residual),
        initial_regions=initial_regions,
        log_likelihood=LogLikelihoods(
            sample.vertices,
            partial(estimate_references, read.points, read.normals, read.weights),
            evidence.distance["planar"],
        ),
    )
