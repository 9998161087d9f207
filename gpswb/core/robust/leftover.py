# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facets that no simple surface explains: a few planes in a row, swept faces and freeform ones."""

from __future__ import annotations

import numpy as np

from gpswb.core.initial import InitialPartition
from gpswb.core.mesh import BoolArray, IntArray, Mesh
from gpswb.core.projection import number_facet_regions
from gpswb.core.recognition import weigh
from gpswb.core.refine import refine_regions
from gpswb.core.region_samples import confined_normals, region_samples
from gpswb.core.robust.consensus import CREASE
from gpswb.core.robust.decide import by_gap
from gpswb.core.robust.jump_memory import JumpMemory
from gpswb.core.robust.parts import connected_parts, halves
from gpswb.core.robust.smooth_parts import smooth_parts
from gpswb.core.robust.strips import few_polygons
from gpswb.core.robust.swept import LEAST_FACETS, follows
from gpswb.core.robust.topology import FacetGraph
from gpswb.core.robust.unbroken import unbroken_parts
from gpswb.core.tolerances import Tolerances

SYMMETRIC_SHARE = 0.5
"""Share of a smooth component's area that its pieces must recognise before it is left in pieces:
pieces of a freeform surface are as freeform as the whole."""

LEVELS = 3
"""Times that a part is halved to find the motion of most of it: each piece costs a recognition."""


def label_leftover(
    mesh: Mesh,
    graph: FacetGraph,
    first: InitialPartition,
    polygon: IntArray,
    label: IntArray,
    jumps: JumpMemory,
    sigma: float,
    tolerances: Tolerances,
) -> tuple[IntArray, BoolArray]:
    """Give every facet without a label one.

    What hangs together across smooth edges without a jump of curvature is one face if one
    symmetry fits it all; else the pieces that slippage finds in it, if they have symmetries; else
    one freeform face.

    Args:
        mesh: the mesh.
        graph: its adjacency.
        first: the first step's result.
        polygon: (m,) coplanar polygon of each facet.
        label: (m,) label of the explained facets, -1 for the others.
        jumps: the jumps of curvature that are known.
        sigma: noise of the vertices, mm.
        tolerances: thresholds of merging and recognition.

    Returns:
        (m,) labels, -1 only where a facet has no area, and (m,) bool: facets that are a plane of
        their own because nothing around them is smooth.
    """
    rest = (label < 0) & (mesh.areas > 0.0)
    out = label.copy()
    few = few_polygons(graph, polygon, rest, first.crease)
    out[few] = int(label.max(initial=-1)) + 1 + polygon[few]
    rest &= ~few
    if not rest.any():
        return out, few
    joined = graph.within(rest)
    joined &= (graph.pair_dihedral < CREASE) & ~first.crease
    part = np.where(rest, smooth_parts(mesh, graph, joined, jumps)[0], -1)
    part, _ = number_facet_regions(part, mesh)
    names = classes_of(mesh, part, first.crease, sigma, tolerances)
    open_ = names == "complex"
    # What is seen to be one face isn't a swept one and something else, nor symmetric pieces.
    open_ &= ~unbroken_parts(mesh, graph, part, joined, open_)
    broken = np.append(open_, False)[part]
    cut = part
    if broken.any():
        cut = _swept_apart(mesh, graph, first, part, broken, joined, sigma, tolerances)
    if (cut != part).any():
        part = cut
        names = classes_of(mesh, part, first.crease, sigma, tolerances)
        broken &= np.append(names == "complex", False)[part]
    out[rest] = int(out.max(initial=-1)) + 1 + part[rest]
    if broken.any():
        pieces = _pieces(mesh, first, part, broken, sigma, tolerances)
        inside = pieces >= 0
        out[inside] = int(out.max(initial=-1)) + 1 + pieces[inside]
    return out, few


def _swept_apart(
    mesh: Mesh,
    graph: FacetGraph,
    first: InitialPartition,
    part: IntArray,
    broken: BoolArray,
    smooth: BoolArray,
    sigma: float,
    tolerances: Tolerances,
) -> IntArray:
    """(m,) the parts, with swept faces cut out of those that are broken, which no symmetry fits.

    A face that holds most of a part holds one of its halves, quarters or eighths whole: the motion
    of such a piece is sought, and the facets of the part that follow it.
    """
    out = part.copy()
    piece = np.where(broken, part, -1)
    links = graph.pairs[smooth]
    for _ in range(LEVELS):
        piece = connected_parts(halves(piece, links), links)
        size = np.bincount(piece[piece >= 0])
        worth = np.append(size >= LEAST_FACETS, False)
        piece, count = number_facet_regions(np.where(worth[piece], piece, -1), mesh)
        normals = confined_normals(mesh, piece, first.crease)
        for sample in region_samples(mesh, piece, count, normals):
            home = np.unique(out[sample.facets])
            if len(home) != 1:
                continue
            inside = np.flatnonzero(out == home[0])
            face = follows(mesh, graph, sample, inside, sigma, tolerances)
            if len(sample.facets) <= len(face) < len(inside):
                trial = np.full(len(part), -1, dtype=np.int64)
                trial[face] = 0
                if classes_of(mesh, trial, first.crease, sigma, tolerances)[0] != "complex":
                    out[face] = int(out.max()) + 1
                    piece[face] = -1
    if (out == part).all():
        return part
    return connected_parts(out, graph.pairs)


def _pieces(
    mesh: Mesh,
    first: InitialPartition,
    part: IntArray,
    broken: BoolArray,
    sigma: float,
    tolerances: Tolerances,
) -> IntArray:
    """(m,) pieces of the parts that slippage divides into symmetric ones, -1 elsewhere."""
    # No merge may leave its part: number the initial regions anew within each.
    key = part * (int(first.region.max(initial=0)) + 2) + first.region
    initial = np.full(len(part), -1, dtype=np.int64)
    initial[broken] = np.unique(key[broken], return_inverse=True)[1].reshape(-1)
    pieces = refine_regions(mesh, initial, first.crease, sigma, tolerances)
    pieces, _ = number_facet_regions(np.where(broken, pieces, -1), mesh)
    names = classes_of(mesh, pieces, first.crease, sigma, tolerances)
    area = np.where(broken, mesh.areas, 0.0)
    symmetric = area * (names != "complex")[pieces]
    parts = int(part.max()) + 1
    whole = np.bincount(part[broken], area[broken], parts)
    share = np.bincount(part[broken], symmetric[broken], parts) / np.maximum(whole, 1e-300)
    kept = broken & (share[np.maximum(part, 0)] >= SYMMETRIC_SHARE)
    return np.where(kept, pieces, -1)


def classes_of(
    mesh: Mesh, region: IntArray, crease: BoolArray, sigma: float, tolerances: Tolerances
) -> np.ndarray[tuple[int], np.dtype[np.str_]]:
    """(k,) invariance class that fits each region 0..k-1 best."""
    count = int(region.max(initial=-1)) + 1
    if not count:
        return np.array([], dtype=np.str_)
    normals = confined_normals(mesh, region, crease)
    samples = region_samples(mesh, region, count, normals)
    return np.array([by_gap(weigh(s, sigma, tolerances), {}) for s in samples])
