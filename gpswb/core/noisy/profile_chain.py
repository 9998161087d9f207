# SPDX-License-Identifier: LGPL-2.1-or-later
"""A profile as a chain of straights and arcs: the simple surfaces that one motion has in common.

Turned and extruded parts are chains of planes, cylinders, cones and tori that share an axis or a
direction. All vertices around the axis tell of one profile, so that it shows rounds that are too
small to be found on the surface itself. The chain with the least description length is found by
dynamic programming over bins of the profile; arcs are fitted with Pratt's constraint ("Direct
least-squares fitting of algebraic surfaces", 1987), which has lines as a limit.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gpswb.core.mesh import FloatArray, IntArray
from gpswb.core.noisy.merging import REGION
from gpswb.core.noisy.models import Model, fit_models
from gpswb.core.noisy.noisy_mesh import NoisyMesh
from gpswb.core.noisy.swept import MOTIONS, OUTSIDE, Swept

BINS = 96
"""Bins of a profile: pieces begin and end at their bounds."""

LEAST = 12
"""Vertices of a piece at least: twice the unknowns of a torus are needed for one, and some more."""

SHORTEST = 7.0
"""Length in sigma of a piece at least: a shorter one has no direction, since its points scatter as
much across it as along. It is that of evenly spread points of the same variance: a row of vertices
is as long as it is wide."""

TIGHT = 0.4
"""Radius of an arc, as a share of its length as above, at least: on a whole circle it is 0.41. A
tighter one curls through the scatter of two rows."""

BELOW = 2.0
"""Standard deviations of chi-square by which a piece may be better than the noise: bins cut rows of
vertices into slices that a circle across them fits far too well."""

LINE, ARC = 2, 3
"""Unknowns of a straight and of an arc, the motion being known."""

JOINT = 12.0
"""Price of each piece besides its unknowns, the motion having that of a region. A joint has a
place, which is an unknown, but mostly it is tangent, which saves one; what is left is the choice
among places."""

ALIKE = 24.0
"""Price of a joint of two arcs or of two straights besides: in drawn profiles they take turns, and
what is many arcs in a row is a spline."""

PRATT = np.array([[0, 0, 0, -0.5], [0, 1, 0, 0], [0, 0, 1, 0], [-0.5, 0, 0, 0]])
"""(4, 4) inverse of the matrix of Pratt's constraint B² + C² - 4AD = 1 on A(x²+y²)+Bx+Cy+D = 0."""


@dataclass(frozen=True, eq=False)
class Chain:
    """Simple surfaces of one motion side by side.

    Args:
        parts: facets and surface of each.
        length: description length of all together.
    """

    parts: tuple[tuple[IntArray, Model], ...]
    length: float


def profile_chain(noisy: NoisyMesh, facets: IntArray, swept: Swept) -> Chain | None:
    """The cheapest chain of straights and arcs that a swept surface's profile is.

    Args:
        noisy: the mesh and its noise.
        facets: (k,) connected facets on the surface.
        swept: the surface; prismatic or revolute.

    Returns:
        None where the profile is one piece, or a piece has no acceptable surface.
    """
    name = swept.invariance_class
    if name == "helical":
        return None
    vertices, local = np.unique(noisy.mesh.triangles[facets], return_inverse=True)
    points = noisy.mesh.vertices[vertices]
    reach = swept.along(points)[0]
    near = np.abs(swept.distance(points)[0]) < OUTSIDE * noisy.sigma
    along, quotient = swept.along(points[near])
    order = np.argsort(along, kind="stable")
    n = len(order)
    if n < 2 * LEAST:
        return None
    # Half by length, half by number: rounds are short and have many vertices.
    rank = np.empty(n)
    rank[order] = np.arange(n) / n
    length = (along - along.min()) / max(float(np.ptp(along)), 1e-300)
    bin_of = np.minimum((BINS * 0.5 * (rank + length)).astype(np.int64), BINS - 1)
    line, arc, count, extent = _residuals(quotient / noisy.sigma, bin_of)
    unit = float(np.log(n))
    noise = min(swept.chi / swept.count, 1.0)
    least = noise * (count - BELOW * np.sqrt(2.0 * count))
    line, arc = np.maximum(line, least), np.maximum(arc, least)
    cost = np.stack([line + LINE * unit, arc + ARC * unit]) + JOINT
    cost[:, (count < LEAST) | (extent < SHORTEST)] = np.inf
    bounds, total = _cheapest(cost)
    if len(bounds) < 3:
        return None
    centre = reach[local.reshape(-1, 3)].mean(axis=1)
    first = np.searchsorted(bin_of[order], bounds[1:-1])
    piece = np.searchsorted(along[order][np.minimum(first, n - 1)], centre, side="right")
    groups = [g for i in range(len(bounds) - 1) if len(g := facets[piece == i])]
    models = fit_models(noisy, groups, thorough=True)
    parts = tuple((g, m) for g, m in zip(groups, models, strict=True) if m is not None)
    if len(parts) < len(groups):
        return None
    strays = OUTSIDE**2 * float(len(points) - n)
    return Chain(parts, total + REGION + MOTIONS[name] * unit + strays)


def _residuals(points: FloatArray, bin_of: IntArray) -> tuple[FloatArray, ...]:
    """(BINS + 1, BINS + 1) squared distances from the best line and circle through the points of
    the bins from i to before j, how many points they are, and how far they reach."""
    points = points - points.mean(axis=0)
    scale = max(float(np.abs(points).max()), 1e-300)
    x, y = points.T / scale
    terms = np.column_stack([x * x + y * y, x, y, np.ones(len(x))])
    products = (terms[:, i] * terms[:, j] for i in range(4) for j in range(4))
    sums = np.column_stack([np.bincount(bin_of + 1, p, BINS + 1) for p in products])
    sums = np.cumsum(sums, axis=0).reshape(-1, 4, 4)
    first, last = np.triu_indices(BINS + 1, 1)
    moment = sums[last] - sums[first]
    number = moment[:, 3, 3]
    mean = moment[:, 1:3, 3] / np.maximum(number, 1.0)[:, None]
    spread = moment[:, 1:3, 1:3] - number[:, None, None] * mean[:, :, None] * mean[:, None, :]
    flat, long = np.linalg.eigvalsh(spread).T
    reach = scale * np.sqrt(12.0 * np.maximum(long, 0.0) / np.maximum(number, 1.0))
    values, vectors = np.linalg.eig(PRATT @ moment)
    # One value is negative, that of no real circle; the least of the others is the residual.
    second = np.argsort(values.real, axis=1)[:, 1]
    row = np.arange(len(values))
    curved, circle = values.real[row, second], vectors.real[row, :, second]
    bend = circle[:, 1] ** 2 + circle[:, 2] ** 2 - 4.0 * circle[:, 0] * circle[:, 3]
    radius = scale * np.sqrt(np.maximum(bend, 0.0)) / np.maximum(2.0 * np.abs(circle[:, 0]), 1e-300)
    curved[radius < TIGHT * reach] = np.inf
    line = np.full((BINS + 1, BINS + 1), np.inf)
    arc, count, extent = line.copy(), np.zeros_like(line), np.zeros_like(line)
    line[first, last] = np.maximum(flat, 0.0) * scale**2
    arc[first, last] = np.maximum(curved, 0.0) * scale**2
    count[first, last] = number
    extent[first, last] = reach
    return line, arc, count, extent


def _cheapest(cost: FloatArray) -> tuple[IntArray, float]:
    """Bounds of the pieces from bin 0 to the last that cost least together, and what they cost.

    Args:
        cost: (2, BINS + 1, BINS + 1) of a straight and of an arc from bin i to before j.
    """
    kinds, size, _ = cost.shape
    alike = ALIKE * np.eye(kinds)
    least = np.full((kinds, size), np.inf)
    least[:, 0] = 0.0
    before = np.zeros((kinds, size), dtype=np.int64)
    for j in range(1, size):
        for kind in range(kinds):
            # The first piece has no neighbour to be like.
            to = least[:, :j] + alike[kind][:, None] * (np.arange(j) > 0)
            total = to.min(axis=0) + cost[kind, :j, j]
            i = int(total.argmin())
            least[kind, j] = total[i]
            before[kind, j] = i * kinds + int(to[:, i].argmin())
    end, kind = size - 1, int(least[:, -1].argmin())
    bounds = [end]
    while end > 0:
        end, kind = divmod(int(before[kind, end]), kinds)
        bounds.append(end)
    return np.array(bounds[::-1]), float(least[:, -1].min())
