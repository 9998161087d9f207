# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facets that a fault of the mesh has cut out of the region around them."""

from __future__ import annotations

import numpy as np
from scipy.sparse import csr_array

from gpswb.core.facet_edges import side_lengths
from gpswb.core.mesh import FloatArray, IntArray, Mesh
from gpswb.core.robust.competition import CREASED
from gpswb.core.robust.topology import SMOOTH, FacetGraph

SLIVER = CREASED / 8.0
"""Height of a facet, as share of its longest side, below which its turning says nothing: less than
the sagitta of that side where the coarsest usual export turns."""


def take_enclosed(mesh: Mesh, graph: FacetGraph, label: IntArray, few: int) -> IntArray:
    """Give regions the small pieces that have no corner of their own.

    Tessellations fold facets over and leave slivers whose normals say nothing. A face of straight
    edges has at least three others around it, and one of curved edges many corners: where all the
    corners of a few facets are one other region's, they lie in it as far as the mesh shows. A flat
    along a cylinder has its corners there, too, but is wider than the facets beside it, and the end
    of a thread turns away from it: beyond a crease only slivers are taken.

    Args:
        mesh: the mesh.
        graph: its adjacency.
        label: (m,) region of each facet, -1 for none.
        few: facets from which a piece is a region in its own right.

    Returns:
        (m,) labels, with gaps.
    """
    out = label.copy()
    m = len(label)
    size = np.bincount(out[out >= 0], minlength=int(label.max(initial=-1)) + 1)
    small = np.flatnonzero((out >= 0) & (size < few)[out])
    if not len(small):
        return out
    small = small[np.argsort(out[small], kind="stable")]
    pieces = np.split(small, np.flatnonzero(np.diff(out[small])) + 1)
    corner = mesh.triangles.ravel()
    at = csr_array(
        (np.ones(3 * m, dtype=np.int8), (corner, np.repeat(np.arange(m), 3))),
        shape=(len(mesh.vertices), m),
    )
    length = side_lengths(mesh)
    width = 2.0 * mesh.areas / np.maximum(length.max(axis=1), 1e-300)
    before = -1
    while len(pieces) != before:
        before, left = len(pieces), []
        for facets in sorted(pieces, key=len):
            host = _host(mesh, graph, out, facets, at, width, length)
            if host >= 0 and size[host] >= max(few, 2 * len(facets)):
                size[host] += len(facets)
                out[facets] = host
            else:
                left.append(facets)
        pieces = left
    return out


def _host(
    mesh: Mesh,
    graph: FacetGraph,
    label: IntArray,
    facets: IntArray,
    at: csr_array,
    width: FloatArray,
    length: FloatArray,
) -> int:
    """Region beside a piece that has all its corners, by the longest border with it; -1: none.

    Args:
        label: (m,) regions; the piece is one of them.
        facets: (k,) the piece.
        at: (n, m) which facets have which vertices.
        width: (m,) least height of each facet, mm; ``length`` (m, 3) its sides.
    """
    neighbour = graph.neighbour[facets]
    other = np.where(neighbour >= 0, label[np.maximum(neighbour, 0)], -1)
    border = (other >= 0) & (other != label[facets[0]])
    if not border.any():
        return -1
    edge, turn = length[facets], graph.dihedral[facets]
    # A facet that is folded over lies in the region beside it all the same.
    smooth = border & (np.minimum(turn, np.pi - turn) < SMOOTH)
    shared = np.bincount(other[border], edge[border])
    flush = np.bincount(other[smooth], edge[smooth], len(shared)) >= 0.5 * shared
    sliver = bool((width[facets] <= SLIVER * edge.max(axis=1)).all())
    corners = np.unique(mesh.triangles[facets])
    touching = [at.indices[at.indptr[c] : at.indptr[c + 1]] for c in corners]
    for host in np.argsort(-shared)[: np.count_nonzero(shared)].tolist():
        if not (sliver or flush[host]):
            continue
        beside = [t[label[t] == host] for t in touching]
        if all(map(len, beside)) and width[facets].max() <= width[np.concatenate(beside)].max():
            return int(host)
    return -1
