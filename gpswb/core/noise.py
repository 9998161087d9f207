# SPDX-License-Identifier: LGPL-2.1-or-later
"""Noise of a mesh's vertices, estimated from the mesh itself."""

from __future__ import annotations

import numpy as np
from scipy.sparse import csr_matrix
from scipy.special import chdtri

from gpswb.core.blocks import blocks
from gpswb.core.facet_edges import at_sides, heights_across
from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.reference import axis_frame, spread
from gpswb.core.robust.hypotheses import explain
from gpswb.core.robust.patches import patches_around
from gpswb.core.robust.topology import FacetGraph

SAMPLES = 1000
"""Vertices around which surfaces are fitted: the estimate's own scatter is below one percent."""

RINGS = ((2, 2, 20), (3, 4, 40))
"""Edges from the vertex, degree of the polynomial, and most vertices used, of the two fits."""

SHAPE = 0.2
"""What a polynomial of degree four leaves of what one of degree two leaves, at least, where that is
noise: both leave all of it. On a smooth surface less than a tenth is left, even when three edges
span 50 degrees."""

COPLANAR = 0.05
"""Share of the edges at which facets lie in one plane, to rounding, that noise never leaves: a box
of twelve triangles has no vertex inside a face, but 6 of its 18 edges are such."""

EXACT = 0.02
"""Share of the fits that are exact, from which there is no noise: noise leaves none exact."""

PATCHES = 256
"""Patches that are fitted by simple surfaces."""

QUARTER = 0.25
"""Share of the fits that leave nothing but shape, from which there is no noise."""

ROUNDING = 1e-6
"""Share of the diagonal up to which deviations are rounding of coordinates, not noise."""

BENT = (0.03, 0.6)
"""Turn (rad) between facets that says that a surface bends there, and that it is a crease."""

BENT_SHARE = 0.1
"""Share of the facets that bend, from which they may decide: a pole or a kink of one face is no
sample of the mesh."""

MILD = 3e-4
"""Share of the diagonal up to which bent parts may be off beside exact planes. What is rougher than
that is rough everywhere, or it is shape."""

LOW = 0.1
"""Quantile of the variances that is taken for undisturbed by creases, to begin with."""

CLEAN = 2.5
"""Standard deviations beyond the mean up to which a variance counts as undisturbed."""

UNBIASED = 1.03
"""What the mean loses by that limit, and by taking the lower of two variances, in sigma: measured
on noisy planes, cylinders and spheres."""


def estimate_noise(mesh: Mesh) -> float:
    """Standard deviation of the vertices across the surface, mm.

    Where the flat parts of a mesh are exact, its bent parts may not be (a remeshed or a rounded
    model). Then the bent parts decide.

    Args:
        mesh: the mesh.

    Returns:
        sigma >= 0; 0 where no vertex has enough neighbours, or vertices lie on smooth surfaces.
    """
    sigma = _estimate(mesh, mesh.diagonal)
    if sigma <= ROUNDING * mesh.diagonal:
        bends = _bent(mesh)
        if bends.mean() < BENT_SHARE:
            return 0.0
        bent = Mesh(mesh.vertices, mesh.triangles[bends])
        sigma = _estimate(bent, mesh.diagonal)
        mild = 10.0 * ROUNDING * mesh.diagonal < sigma < MILD * mesh.diagonal
        if not mild or _has_exact_patches(bent):
            return 0.0
    return sigma


def _has_exact_patches(mesh: Mesh) -> bool:
    """Whether small patches of a mesh lie on cylinders, cones, spheres or tori to rounding, which
    noise leaves none; where facets turn by much, no polynomial shows that."""
    graph = FacetGraph.of(mesh)
    seeds = spread(len(mesh.triangles), PATCHES)
    passable = (graph.neighbour >= 0) & (graph.dihedral < BENT[1])
    patches = patches_around(mesh, graph, seeds, passable, 2)
    count = (patches.facets >= 0).sum(axis=1)
    found = explain(mesh, patches, count, 1e-7 * mesh.diagonal)
    return len(found.hypotheses) >= EXACT * len(seeds)


def _bent(mesh: Mesh) -> BoolArray:
    """(m,) facets that turn from a neighbour, but at no crease."""
    chord = 2.0 * np.sin(0.5 * mesh.turning)
    chord[(mesh.areas[mesh.facet_pairs] <= 0.0).any(axis=1)] = 1.0
    most = at_sides(mesh, chord).max(axis=1)
    bent: BoolArray = (most > BENT[0]) & (most < BENT[1])
    return bent


def _estimate(mesh: Mesh, diagonal: float) -> float:
    """Noise by fits around sampled vertices.

    Around sampled vertices a quadric is fitted to the two rings of neighbours, and a polynomial of
    degree four to three; the variances that are left, over their degrees of freedom, are noise
    unless the higher degree leaves much less: then it is the surface's own shape. Creases only
    raise the variance: of all the fits those count that agree, by the chi-square distribution, with
    the lowest.

    Returns:
        sigma >= 0; 0 where no vertex has enough neighbours, where a quarter of the fits leave
        nothing, or where facets lie in one plane.
    """
    if _coplanar_share(mesh) >= COPLANAR:
        return 0.0
    n = len(mesh.vertices)
    ends = mesh.pair_edges
    row, col = np.concatenate([ends, ends[:, ::-1]]).T
    graph = csr_matrix((np.ones(len(row)), (row, col)), shape=(n, n))
    degree = np.diff(graph.indptr)
    candidates = np.flatnonzero(degree >= 4)
    if not len(candidates):
        return 0.0
    chosen = candidates[spread(len(candidates), SAMPLES)]
    frame = _frames(mesh, chosen, graph)
    near = graph[chosen] + graph[chosen] @ graph
    quadric, freedom = _variance(mesh, chosen, frame, near.tocsr(), *RINGS[0][1:])
    wide = (near + near @ graph).tocsr()
    quartic, _ = _variance(mesh, chosen, frame, wide, *RINGS[1][1:])
    plain, _ = _variance(mesh, chosen, frame, wide, 2, RINGS[1][2])
    least = np.fmin(quadric, quartic)
    variance = np.where(quartic < SHAPE**2 * plain, 0.0, least)
    known = np.isfinite(quadric)
    variance, freedom = variance[known], freedom[known]
    if not len(variance):
        return 0.0
    nothing = variance <= (1e-7 * diagonal) ** 2
    if nothing.mean() >= QUARTER or (least[known] <= (1e-7 * diagonal) ** 2).mean() >= EXACT:
        return 0.0
    return UNBIASED * float(np.sqrt(_agreeing(variance[~nothing], freedom[~nothing])))


def _coplanar_share(mesh: Mesh) -> float:
    """Share of the edges between two facets of which either lies in the other's plane."""
    pairs = mesh.facet_pairs
    normals = np.ascontiguousarray(mesh.facet_normals.T)
    flat = both = 0
    for part in blocks(len(pairs)):
        solid = (mesh.areas[pairs[part]] > 0.0).all(axis=1)
        near = heights_across(mesh, normals, part) <= 1e-7 * mesh.diagonal
        flat += int((solid & near.all(axis=0)).sum())
        both += int(solid.sum())
    return flat / max(both, 1)


def _agreeing(variance: FloatArray, freedom: FloatArray) -> float:
    """Mean of the variances that are scattered as those of one sigma are."""
    ratio = variance * freedom / chdtri(freedom, 1.0 - LOW)
    sigma2 = float(np.quantile(ratio, LOW))
    for _ in range(20):
        clean = variance <= sigma2 * (1.0 + CLEAN * np.sqrt(2.0 / freedom))
        if not clean.any():
            break
        better = float(np.average(variance[clean], weights=freedom[clean]))
        if abs(better - sigma2) <= 1e-6 * sigma2:
            break
        sigma2 = better
    return sigma2


def _frames(mesh: Mesh, chosen: IntArray, graph: csr_matrix) -> FloatArray:
    """(s, 3, 3) frames with the mean normal of the facets one edge around as last row."""
    n = len(mesh.vertices)
    corner = mesh.triangles.ravel()
    share = np.empty((n, 3))
    for axis in range(3):
        weighted = mesh.facet_normals[:, axis] * mesh.areas
        share[:, axis] = np.bincount(corner, np.repeat(weighted, 3), n)
    mean = share[chosen] + graph[chosen] @ share
    length = np.linalg.norm(mean, axis=1)
    mean[length <= 0.0] = [0.0, 0.0, 1.0]
    return np.array([axis_frame(direction) for direction in mean])


def _variance(
    mesh: Mesh, chosen: IntArray, frame: FloatArray, rings: csr_matrix, degree: int, most: int
) -> tuple[FloatArray, FloatArray]:
    """Variance (s,) that a polynomial leaves, NaN without freedom, and its degrees of freedom."""
    count = np.diff(rings.indptr)
    used = np.minimum(count, most)
    slot = np.arange(most)
    # Longer rings are thinned evenly.
    pick = slot * count[:, None] // np.maximum(used, 1)[:, None]
    pick = np.minimum(pick, np.maximum(count - 1, 0)[:, None])
    near = rings.indices[np.minimum(rings.indptr[:-1, None] + pick, len(rings.indices) - 1)]
    present: BoolArray = slot < used[:, None]
    local = np.einsum("ski,sci->skc", mesh.vertices[near] - mesh.vertices[chosen][:, None], frame)
    x, y, height = np.moveaxis(local, 2, 0)
    scale = np.where(present, np.hypot(x, y), 0.0).max(axis=1, keepdims=True)
    x, y = x / np.maximum(scale, 1e-300), y / np.maximum(scale, 1e-300)
    terms = [x**i * y**j for i in range(degree + 1) for j in range(degree + 1 - i)]
    design = np.stack(terms, axis=2) * present[:, :, None]
    height = height * present
    gram = np.swapaxes(design, 1, 2) @ design + 1e-9 * np.eye(len(terms))
    right = np.einsum("skc,sk->sc", design, height)
    fitted = np.linalg.solve(gram, right[:, :, None])[:, :, 0]
    rest = height - np.einsum("skc,sc->sk", design, fitted)
    freedom = (used - len(terms)).astype(np.float64)
    variance = np.where(freedom >= 4, (rest**2).sum(axis=1) / np.maximum(freedom, 1), np.nan)
    return variance, np.maximum(freedom, 1.0)
