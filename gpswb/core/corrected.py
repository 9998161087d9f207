# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mode `corrected`: the paper's flow with its errors mended."""

from __future__ import annotations

from gpswb.core.initial import initial_partition
from gpswb.core.mesh import Mesh
from gpswb.core.partition import Partition
from gpswb.core.recognised_partition import recognised_partition
from gpswb.core.refine import refine_regions
from gpswb.core.stages import Progress, StageClock
from gpswb.core.tolerances import Tolerances


def partition_corrected(
    mesh: Mesh,
    sigma: float,
    tolerances: Tolerances | None = None,
    progress: Progress | None = None,
) -> Partition:
    """Partition by the paper's three steps, mended.

    What differs from the print, and why:

    * facets are labelled, not vertices: a mesh as exported has no vertex inside a face;
    * curvature stops at creases, and sharp edges are found by dihedral angle against the smooth
      turning beside them: c_max comes from the shortest edge, so (6)-(7) miss the others;
    * a facet is plane by its sagitta, a length over a length: p_c = 1e-5 carries a unit;
    * votes are swept in place and capped: synchronous updates oscillate;
    * slippage solves M x = mu V x, free of unit, origin and pose, where (2)-(3) are not;
    * signatures are compared in one frame, the metric of the union;
    * no confident region loses a motion, and a union must lie on one surface: merging down to
      k = 1 as printed swallows tangent chains;
    * facets that a tangent border took along are given back to the surface they lie on;
    * the likelihoods carry the right Jacobians, and the class is decided by parsimony among the
      classes that fit, since nested classes tie.

    Args:
        mesh: the mesh.
        sigma: noise of the vertices, mm; 0 for a nominal mesh.
        tolerances: thresholds; the defaults if not given.
        progress: listener.
    """
    tol = tolerances or Tolerances()
    clock = StageClock(progress)
    first = initial_partition(mesh, sigma, tol, clock)
    with clock.stage("refine"):
        refined = refine_regions(mesh, first.region, first.crease, sigma, tol)
    return recognised_partition(mesh, first, refined, sigma, tol, clock, "corrected", "hybrid")
