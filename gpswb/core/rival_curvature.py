# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rival `curvature`: shape types, growing and Table 4, nothing else (paper, section 4)."""

from __future__ import annotations

import dataclasses

import numpy as np

from gpswb.core.initial import curvature_between, initial_partition
from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray, IntArray, Mesh
from gpswb.core.partition import Partition
from gpswb.core.recognised_partition import recognised_partition
from gpswb.core.recognition import Choice, always
from gpswb.core.region_samples import RegionSample
from gpswb.core.shape_types import PLANE
from gpswb.core.stages import Progress, StageClock
from gpswb.core.tolerances import Tolerances

_CONSTANT = 0.1  # largest variation of a curvedness that Table 4 calls constant
_ERRATIC = 0.5  # beyond this variation no symmetry is assumed


def partition_by_curvature(
    mesh: Mesh,
    sigma: float,
    tolerances: Tolerances | None = None,
    progress: Progress | None = None,
) -> Partition:
    """Partition by shape type alone: initial regions are final, and Table 4 gives their class.

    There is no voting and no merging. The estimator is that of `corrected`, so that a comparison
    shows what the other steps add rather than whose curvature is better.

    Args:
        mesh: the mesh.
        sigma: noise of the vertices, mm.
        tolerances: thresholds; the defaults if not given.
        progress: listener.
    """
    tol = dataclasses.replace(tolerances or Tolerances(), vote_sweeps=0)
    clock = StageClock(progress)
    first = initial_partition(mesh, sigma, tol, clock)
    with clock.stage("refine"):
        wedges, curvature = curvature_between(mesh, first.crease, sigma)
        curved = curvature.curvedness[wedges.of_corner].mean(axis=1)

    def choose(sample: RegionSample) -> Choice:
        return always(class_by_table(first.facet_type[sample.facets], curved[sample.facets]))

    return recognised_partition(
        mesh, first, first.region, sigma, tol, clock, "corrected", "curvature", choose
    )


def class_by_table(types: IntArray, curvedness: FloatArray) -> InvarianceClass:
    """Class of a region of one shape type by Table 4.

    Planes are planar; caps and cups of constant curvedness spherical; ridges and ruts cylindrical
    if their curvedness is constant, else prismatic. The table can't tell revolute, helical and
    complex apart: what varies little is called revolute, the commonest, and the rest complex. It
    calls a cone's curvedness constant, wrongly: cones come out prismatic.

    Args:
        types: (f,) shape type of the facets, all equal.
        curvedness: (f,) their curvedness.
    """
    shape = int(types[0])
    if shape == PLANE:
        return "planar"
    variation = float(np.std(curvedness) / max(float(np.mean(curvedness)), 1e-300))
    if abs(shape) == 4:
        return "spherical" if variation <= _CONSTANT else "complex"
    if abs(shape) == 2:
        return "cylindrical" if variation <= _CONSTANT else "prismatic"
    return "revolute" if variation <= _ERRATIC else "complex"
