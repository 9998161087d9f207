# SPDX-License-Identifier: LGPL-2.1-or-later
"""Borders that run across the motion which the regions on both sides have in common."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from gpswb.core.facet_edges import edge_lengths
from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import IntArray, Mesh
from gpswb.core.quotient import quotient_coordinates
from gpswb.core.reference import Reference

ALONG = np.cos(np.deg2rad(45.0))
"""Cosine of the angle to the motion up to which an edge runs along it."""

ACROSS = 1.0 / 3.0
"""Share of a border's length, and of the smaller region's profile, that must be across: it may go
along the motion for a while, but between two faces it does nothing else."""

TOUCH = 0.1
"""Edges of a border, as share of the square root of the smaller region's number of facets: about so
many go through a region, and where two merely touch there are far fewer."""


def leaves_orbits(
    mesh: Mesh,
    edges: IntArray,
    region: IntArray,
    sides: tuple[int, int],
    name: InvarianceClass,
    reference: Reference,
) -> bool:
    """Whether a border of two regions is none, because it leaves the orbits of their motion.

    Surfaces with a motion in common meet along its orbits only, unless they are one surface: what
    is turned about one axis, along parallels; what is extruded one way, along straight lines.

    Args:
        mesh: the mesh.
        edges: (k,) the border, as in ``mesh.facet_pairs``.
        region: (m,) region of each facet.
        sides: the two regions.
        name: class of both together: revolute, prismatic or helical.
        reference: its reference parameters.
    """
    smaller = min(np.count_nonzero(region == side) for side in sides)
    if len(edges) < TOUCH * np.sqrt(smaller):
        return False
    leads = {"prismatic": np.inf, "revolute": 0.0}
    screw = replace(reference, lead=leads.get(name, reference.lead))
    start, end = np.moveaxis(mesh.vertices[mesh.pair_edges[edges]], 1, 0)
    motion, edge = screw.velocity(0.5 * (start + end)), end - start
    size = np.linalg.norm(motion, axis=1) * np.linalg.norm(edge, axis=1)
    across = np.abs(np.einsum("ij,ij->i", motion, edge)) < ALONG * size
    length = edge_lengths(mesh, edges)
    if length[across].sum() < ACROSS * length.sum():
        return False
    inside = [np.unique(mesh.triangles[region == side]) for side in sides]
    vertices = np.union1d(*inside)
    # In one go: where the heights of a screw are cut depends on the points.
    profile = quotient_coordinates(mesh.vertices[vertices], name, reference)

    def extent(some: IntArray) -> float:
        chosen = profile[np.searchsorted(vertices, some)]
        return float(np.linalg.norm(np.ptp(chosen, axis=0)))

    return extent(np.unique(mesh.pair_edges[edges])) >= ACROSS * min(map(extent, inside))
