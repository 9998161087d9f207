# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facets that no simple surface explains: small flat polygons, fragments, swept or free faces."""

from __future__ import annotations

import numpy as np

from gpswb.core.initial import InitialPartition
from gpswb.core.mesh import BoolArray, IntArray, Mesh
from gpswb.core.refine import refine_regions
from gpswb.core.robust.strips import few_polygons
from gpswb.core.robust.topology import FacetGraph
from gpswb.core.tolerances import Tolerances


def label_leftover(
    mesh: Mesh,
    graph: FacetGraph,
    first: InitialPartition,
    polygon: IntArray,
    label: IntArray,
    sigma: float,
    tolerances: Tolerances,
) -> tuple[IntArray, BoolArray]:
    """Give every facet without a label one.

    Args:
        mesh: the mesh.
        graph: its adjacency.
        first: the first step's result.
        polygon: (m,) coplanar polygon of each facet.
        label: (m,) label of the explained facets, -1 for the others.
        sigma: noise of the vertices, mm.
        tolerances: thresholds of the merging.

    Returns:
        (m,) labels, -1 only where a facet has no area, and (m,) bool: facets that are a plane of
        their own because nothing around them is smooth.
    """
    rest = (label < 0) & (mesh.areas > 0.0)
    out = label.copy()
    flat = np.zeros(len(label), dtype=bool)
    if not rest.any():
        return out, flat
    few = few_polygons(graph, polygon, rest, first.crease)
    base = int(label.max(initial=-1)) + 1
    out[few] = base + polygon[few]
    flat[few] = True
    rest &= ~few
    if rest.any():
        initial = np.where(rest, first.region, -1)
        refined = refine_regions(mesh, initial, first.crease, sigma, tolerances)
        base = int(out.max(initial=-1)) + 1
        out[rest] = base + refined[rest]
    return out, flat
