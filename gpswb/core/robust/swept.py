# SPDX-License-Identifier: LGPL-2.1-or-later
"""The face of a screw motion, translation or rotation that most of a smooth component follows."""

from __future__ import annotations

import numpy as np

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray, IntArray, Mesh
from gpswb.core.recognition import weigh
from gpswb.core.reference import Reference
from gpswb.core.region_samples import RegionSample
from gpswb.core.robust.decide import by_gap
from gpswb.core.robust.topology import FacetGraph
from gpswb.core.tolerances import Tolerances

LEAST_FACETS = 60
"""Facets that a motion is estimated from at least."""

SLIP = 0.02
"""Sine of the angle between velocity and facet up to which a facet may follow a motion, besides
what the facets themselves turn by."""


def follows(
    mesh: Mesh,
    graph: FacetGraph,
    seed: RegionSample,
    inside: IntArray,
    sigma: float,
    tolerances: Tolerances,
) -> IntArray:
    """Facets of a component that follow the one-parameter motion of a region in it.

    Args:
        mesh: the mesh.
        graph: its adjacency.
        seed: the region.
        inside: (k,) facets of the component.
        sigma: noise of the vertices, mm.
        tolerances: thresholds.

    Returns:
        The connected facets around the region, empty where it has no such motion.
    """
    none = np.zeros(0, dtype=np.int64)
    if len(seed.facets) < LEAST_FACETS:
        return none
    evidence = weigh(seed, sigma, tolerances)
    name = by_gap(evidence, {})
    if name not in ("prismatic", "revolute", "helical"):
        return none
    velocity = _velocity(mesh.centroids[inside], name, evidence.references[name])
    speed = np.maximum(np.linalg.norm(velocity, axis=1), 1e-300)
    slip = np.abs(np.einsum("ik,ik->i", velocity, mesh.facet_normals[inside])) / speed
    near = np.zeros(len(mesh.triangles), dtype=bool)
    near[inside[slip <= SLIP + seed.turning]] = True
    near[seed.facets] = True
    a, b = graph.pairs.T
    part = graph.components(near[a] & near[b], len(near))
    main = np.bincount(part[seed.facets]).argmax()
    return np.flatnonzero(near & (part == main))


def _velocity(points: FloatArray, name: InvarianceClass, reference: Reference) -> FloatArray:
    """(n, 3) velocity at (n, 3) points of a class's motion."""
    if name == "prismatic" or not np.isfinite(reference.lead):
        return np.broadcast_to(reference.direction, points.shape)
    turning: FloatArray = np.asarray(
        np.cross(reference.direction, points - reference.point), dtype=np.float64
    )
    if name == "helical":
        turning += reference.lead / (2.0 * np.pi) * reference.direction
    return turning
