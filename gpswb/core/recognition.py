# SPDX-License-Identifier: LGPL-2.1-or-later
"""Invariance class of a region by parsimony: the most symmetric class that fits (design, section
5).

The classes are nested (planar in cylindrical in revolute, prismatic and helical; spherical in
revolute), so that likelihoods of nested classes tie by construction. A class is accepted when the
region's vertices lie on a surface of it and its normals agree; the first accepted in the order
below wins, and the likelihoods are reported beside it.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from gpswb.core.invariance import InvarianceClass
from gpswb.core.likelihood import Densities, LogLikelihoods
from gpswb.core.mesh import FloatArray
from gpswb.core.partition import Region
from gpswb.core.reference import Reference, estimate_references, spread
from gpswb.core.refine_reference import refine_reference
from gpswb.core.region_samples import RegionSample
from gpswb.core.situation import describe
from gpswb.core.thickness import thickness
from gpswb.core.tolerances import Tolerances

PARSIMONY: tuple[InvarianceClass, ...] = (
    "planar",
    "spherical",
    "cylindrical",
    "prismatic",
    "revolute",
    "helical",
    "complex",
)
"""Most symmetric first; prismatic before revolute, since an axis far away looks like a prism."""

_SAMPLES = 4000  # corners at which the slip of a region is measured

_MARGIN_CAP = 1e6  # a margin beyond this says "exact", whatever the rounding


@dataclass(frozen=True, eq=False)
class Evidence:
    """How each class fits a region.

    Args:
        references: reference parameters of each class.
        stand_off: RMS distance of the vertices to the class's best surface, mm.
        slip: mean squared sine between the class's motions and the surface.
        distance: mm: largest stand-off that counts as on the surface.
        angle: largest slip that counts as tangent.
    """

    references: Mapping[InvarianceClass, Reference]
    stand_off: Mapping[InvarianceClass, float]
    slip: Mapping[InvarianceClass, float]
    distance: Mapping[InvarianceClass, float]
    angle: float

    def fits(self, name: InvarianceClass) -> bool:
        """Whether positions and normals both allow the class."""
        return self.stand_off[name] <= self.distance[name] and self.slip[name] <= self.angle


def slip_of(
    points: FloatArray,
    normals: FloatArray,
    weights: FloatArray,
    invariance_class: InvarianceClass,
    reference: Reference,
) -> float:
    """Mean squared sine of the angle between a class's motions and the surface; 0 for complex.

    Averaged over the directions that the motions span at each point: both tangent directions for
    planar, spherical and cylindrical, the one direction of motion for the others. Rotations weigh
    points by their squared speed: on the axis itself no direction is defined.
    """
    share = weights / max(float(weights.sum()), 1e-300)
    if invariance_class == "complex":
        return 0.0
    direction, ray = reference.direction, points - reference.point
    along = normals @ direction
    if invariance_class == "planar":
        return float(0.5 * (1.0 - share @ along**2))
    if invariance_class == "spherical":
        radial = ray / np.maximum(np.linalg.norm(ray, axis=1, keepdims=True), 1e-300)
        return float(0.5 * (1.0 - share @ np.einsum("ij,ij->i", normals, radial) ** 2))
    if invariance_class == "prismatic" or not np.isfinite(reference.lead):
        return float(share @ along**2)
    screw = reference if invariance_class == "helical" else replace(reference, lead=0.0)
    circular = screw.velocity(points)
    across = share @ np.einsum("ij,ij->i", normals, circular) ** 2
    speed = max(float(share @ np.einsum("ij,ij->i", circular, circular)), 1e-300)
    if invariance_class == "cylindrical":
        return float(0.5 * (share @ along**2 + across / speed))
    return float(across / speed)


def weigh(
    sample: RegionSample,
    sigma: float,
    tolerances: Tolerances,
    classes: Collection[InvarianceClass] = PARSIMONY,
    refined: bool = True,
) -> Evidence:
    """Fit classes to a region and measure how it stands off.

    Args:
        sample: the region.
        sigma: standard deviation of the vertices' noise, mm.
        tolerances: ``distance`` is taken of the region's size here.
        classes: the classes to try.
        refined: whether references are refined by position, which takes most of the time.
    """
    on_surface = max(3.0 * sigma, tolerances.distance * sample.size)
    # A profile is known only through its chords: a tenth of their sagitta is left to it.
    on_profile = max(on_surface, 0.1 * sample.turning * sample.edge_length / 8.0)
    references = estimate_references(sample.points, sample.normals, sample.weights, classes)
    stand_off: dict[InvarianceClass, float] = {}
    for name, reference in references.items():
        if refined:
            references[name], stand_off[name] = refine_reference(
                sample.vertices, name, reference, on_profile
            )
        else:
            stand_off[name] = thickness(sample.vertices, name, reference)
    chosen = spread(len(sample.points), _SAMPLES)
    points, normals, weights = (a[chosen] for a in (sample.points, sample.normals, sample.weights))
    # Points fill a lead of a screw at random when it is none: its profile must be far thinner.
    allowed = dict.fromkeys(PARSIMONY, on_surface)
    allowed["prismatic"] = allowed["revolute"] = on_profile
    if "helical" in references:
        allowed["helical"] = min(on_profile, 0.01 * abs(references["helical"].lead))
    helical = stand_off.get("helical", np.inf) <= allowed["helical"]
    for rank, name in enumerate(PARSIMONY):
        weaker = [
            stand_off[n]
            for n in PARSIMONY[rank + 1 : -1]
            if n in stand_off and (n != "helical" or helical)
        ]
        if name not in ("helical", "complex"):
            best = tolerances.form_gain * min(weaker, default=np.inf)
            allowed[name] = max(allowed[name], min(best, tolerances.form * sample.size))
    return Evidence(
        references=references,
        stand_off=stand_off,
        slip={n: slip_of(points, normals, weights, n, r) for n, r in references.items()},
        distance=allowed,
        angle=allowed_slip(sample, sigma),
    )


def allowed_slip(sample: RegionSample, sigma: float) -> float:
    """Largest slip of a region, with noise of its vertices (mm), that counts as tangent."""
    noise = (2.0 * sigma / sample.edge_length) ** 2 if sample.edge_length > 0.0 else 0.0
    # Where a region ends, corner normals are off by up to half a facet's turning.
    return max(2e-3, sample.turning**2 / 6.0, 4.0 * noise)


Choice = Callable[[Evidence, Mapping[InvarianceClass, float]], InvarianceClass]
"""Decides the class from how each class fits and from its log-likelihood."""


def by_parsimony(
    evidence: Evidence, likelihoods: Mapping[InvarianceClass, float]
) -> InvarianceClass:
    """The most symmetric class that fits."""
    return next((name for name in PARSIMONY if evidence.fits(name)), "complex")


def always(name: InvarianceClass) -> Choice:
    """A choice that another method has already made."""

    def fixed(evidence: Evidence, likelihoods: Mapping[InvarianceClass, float]) -> InvarianceClass:
        return name

    return fixed


def margin(evidence: Evidence, name: InvarianceClass, stand_off: float) -> float:
    """How many times further the best rejected more symmetric class stands off than the class."""
    symmetric = PARSIMONY[: PARSIMONY.index(name)]
    rejected = [evidence.stand_off[n] for n in symmetric if not evidence.fits(n)]
    ratio = min(rejected, default=np.inf) / max(stand_off, 0.01 * evidence.distance["planar"])
    return float(min(max(ratio, 1.0), _MARGIN_CAP))


def recognise(
    number: int,
    sample: RegionSample,
    initial_regions: int,
    sigma: float,
    tolerances: Tolerances,
    *,
    choose: Choice = by_parsimony,
    densities: Densities = "corrected",
    refined: bool = True,
) -> Region:
    """Recognise one region and describe it.

    Args:
        number: its id.
        sample: the region.
        initial_regions: how many initial regions it was merged from.
        sigma: noise of the vertices, mm.
        tolerances: thresholds.
        choose: what decides the class.
        densities: which form of the likelihoods to compute.
        refined: see `weigh`; needless where the class is known.
    """
    evidence = weigh(sample, sigma, tolerances, refined=refined)
    likelihoods = LogLikelihoods(
        sample.vertices,
        partial(dict, evidence.references),
        evidence.distance["planar"],
        densities,
    )
    chosen = choose(evidence, likelihoods)
    few = len(sample.facets) < tolerances.confident_facets
    surface, situation, intrinsic = describe(
        sample.vertices,
        chosen,
        evidence.references[chosen],
        max(evidence.distance[chosen], 2.0 * evidence.stand_off[chosen]),
    )
    return Region(
        id=number,
        invariance_class=chosen,
        area=sample.area,
        triangles=len(sample.facets),
        surface=surface,
        situation=situation,
        intrinsic=intrinsic,
        residual=evidence.stand_off[chosen],
        margin=margin(evidence, chosen, evidence.stand_off[chosen]),
        initial_regions=initial_regions,
        log_likelihood=likelihoods,
        undecided=tuple(n for n in PARSIMONY if n != "complex" and evidence.fits(n)) if few else (),
    )
