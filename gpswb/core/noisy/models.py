# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces of the five kinds fitted to many groups of facets, and which kind the noise allows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from gpswb.core.mesh import FloatArray, IntArray
from gpswb.core.noisy.noisy_mesh import NoisyMesh
from gpswb.core.reference import spread
from gpswb.core.robust.fitting import fit, fit_patches
from gpswb.core.robust.growth import to_local, to_world
from gpswb.core.robust.surfaces import UNKNOWNS, Kind, distance

KINDS: tuple[Kind, ...] = ("plane", "cylinder", "cone", "sphere", "torus")

PRIOR: dict[Kind, float] = {
    "plane": 0.0,
    "cylinder": 2.0,
    "cone": 4.0,
    "sphere": 6.0,
    "torus": 8.0,
}
"""Minus twice the logarithm of how often a kind occurs on parts, against planes, roughly: it
decides where the data don't."""

COUNTED: dict[Kind, int] = {**UNKNOWNS, "sphere": UNKNOWNS["cone"]}
"""Unknowns that a surface is charged for. A narrow ring lies on a sphere as well as on a cone, and
the sphere has fewer unknowns, but rings are cones: a sphere has to fit better."""

SAMPLE = 200
"""Vertices of a group that a surface is fitted to: parameters are then known to sigma / 16."""

EXCESS = 1.1
"""Mean squared distance, in sigma², that an imperfect sigma and small form deviations may leave."""

SURE = 3.0
"""Standard deviations of chi-square beyond which a surface is rejected."""

AGREEMENT = 0.6
"""Mean cosine between facets and surface, at least: a thin tube through a strip of noisy vertices
explains their positions, but half of its normals point the wrong way."""


class Surface(Protocol):
    """What labelling asks of a surface."""

    @property
    def side(self) -> float:
        """+1 or -1, the side of the surface that is outside."""

    def distance(self, points: FloatArray) -> tuple[FloatArray, FloatArray]:
        """(n,) mm signed distances of points (n, 3), and (n, 3) unit normals there."""

    def price(self, count: int) -> float:
        """What the surface costs on so many vertices besides its chi-square."""


@dataclass(frozen=True, eq=False)
class Model:
    """A surface and how well it explains its vertices.

    Args:
        kind: its kind; ``surface`` (8,) its numbers, see `robust.surfaces`.
        side: +1 or -1, the side of the surface that is outside.
        cost: chi-square + unknowns · ln n + prior: smaller is likelier.
        chi: mean squared distance over sigma², per degree of freedom.
        count: number of vertices n.
    """

    kind: Kind
    surface: FloatArray
    side: float
    cost: float
    chi: float
    count: int

    @property
    def explains(self) -> bool:
        """Whether the distances are those of noise."""
        freedom = max(self.count - UNKNOWNS[self.kind], 1)
        return self.chi <= EXCESS + SURE * float(np.sqrt(2.0 / freedom))

    def distance(self, points: FloatArray) -> tuple[FloatArray, FloatArray]:
        """As `Surface.distance`."""
        d, normal = distance(self.kind, self.surface[None], points[None])
        return d[0], normal[0]

    def price(self, count: int) -> float:
        """As `Surface.price`."""
        return price(self.kind, count)


def fit_models(
    noisy: NoisyMesh,
    groups: Sequence[IntArray],
    sample: int = SAMPLE,
    thorough: bool = False,
) -> list[Model | None]:
    """The likeliest surface of each group of facets.

    Args:
        noisy: the mesh and its noise.
        groups: facets of each group.
        sample: vertices and facets used of each group.
        thorough: try every kind, also where a plane or cylinder explains the group.

    Returns:
        One model a group; None where no kind has an acceptable surface.
    """
    best: list[Model | None] = [None] * len(groups)
    by_size = sorted(range(len(groups)), key=lambda i: len(groups[i]))
    for start in range(0, len(groups), 64):
        chunk = by_size[start : start + 64]
        _fit_chunk(noisy, groups, chunk, sample, thorough, best)
    return best


def _fit_chunk(
    noisy: NoisyMesh,
    groups: Sequence[IntArray],
    chunk: Sequence[int],
    sample: int,
    thorough: bool,
    best: list[Model | None],
) -> None:
    mesh, normals = noisy.mesh, noisy.normals
    facets = [groups[i][spread(len(groups[i]), sample)] for i in chunk]
    weighed = [vertex_weights(noisy, groups[i], sample) for i in chunk]
    used = np.array([len(v) for v, _ in weighed])
    b, n, f = len(chunk), int(used.max()), max(len(x) for x in facets)
    points, weights = np.zeros((b, n, 3)), np.zeros((b, n))
    centres, turned = np.zeros((b, f, 3)), np.zeros((b, f, 3))
    centre, scale = np.zeros((b, 3)), np.ones(b)
    for row, ((v, weight), x) in enumerate(zip(weighed, facets, strict=True)):
        p = mesh.vertices[v]
        centre[row] = p.mean(axis=0)
        scale[row] = max(float(np.abs(p - centre[row]).max()), 1e-300)
        points[row, : len(v)] = (p - centre[row]) / scale[row]
        weights[row, : len(v)] = weight
        area = mesh.areas[x]
        centres[row, : len(x)] = (mesh.centroids[x] - centre[row]) / scale[row]
        root = np.sqrt(area / max(float(area.sum()), 1e-300))
        turned[row, : len(x)] = normals[x] * root[:, None]
    open_rows = np.arange(b)
    for kind in KINDS:
        if kind in ("cone", "sphere", "torus") and not thorough:
            known = [best[i] for i in chunk]
            open_rows = np.flatnonzero([m is None or not m.explains for m in known])
        least = UNKNOWNS[kind] + 1 if kind == "plane" else 2 * UNKNOWNS[kind]
        enough = open_rows[used[open_rows] >= least]
        if not len(enough):
            continue
        p, w, c, t = points[enough], weights[enough], centres[enough], turned[enough]
        local = fit_patches(kind, p, w, c, t)
        _weigh(kind, local, p, w, c, t, centre, scale, enough, noisy.sigma, chunk, best)


def _weigh(
    kind: Kind,
    local: FloatArray,
    points: FloatArray,
    weights: FloatArray,
    centres: FloatArray,
    turned: FloatArray,
    centre: FloatArray,
    scale: FloatArray,
    rows: IntArray,
    sigma: float,
    chunk: Sequence[int],
    best: list[Model | None],
) -> None:
    """Keep a kind's surfaces where they are the likeliest so far."""
    d, _ = distance(kind, local, points)
    rss = (d**2 * weights).sum(axis=1) * (scale[rows] / sigma) ** 2
    _, normal = distance(kind, local, centres)
    length = np.linalg.norm(turned, axis=2)
    agreement = (np.einsum("bfk,bfk->bf", normal, turned) * length).sum(axis=1)
    agreement /= np.maximum((length**2).sum(axis=1), 1e-300)
    world = to_world(local, centre[rows], scale[rows], kind)
    for i, row in enumerate(rows):
        if not np.isfinite(world[i]).all() or abs(agreement[i]) < AGREEMENT:
            continue
        n = round(float(weights[i].sum()))
        unknowns = UNKNOWNS[kind]
        chi = float(rss[i]) / max(n - unknowns, 1)
        cost = float(rss[i]) + price(kind, n)
        known = best[chunk[row]]
        if known is None or cost < known.cost:
            best[chunk[row]] = Model(kind, world[i], float(np.sign(agreement[i])), cost, chi, n)


def refit(noisy: NoisyMesh, model: Model, facets: IntArray) -> Model:
    """The same kind of surface fitted to other facets, from where it is.

    Fitted to a sample of the vertices, but judged by all of them.
    """
    vertices, weight = vertex_weights(noisy, facets)
    points = noisy.mesh.vertices[vertices]
    some = spread(len(points), SAMPLE)
    p, w = points[some], weight[some]
    centre = p.mean(axis=0)
    scale = max(float(np.abs(p - centre).max()), 1e-300)
    local = to_local(model.surface[None], centre[None], np.array([scale]), model.kind)
    better = fit(model.kind, local, (p - centre)[None] / scale, w[None])
    surface = to_world(better, centre[None], np.array([scale]), model.kind)[0]
    d = distance(model.kind, surface[None], points[None])[0][0]
    rss = float(weight @ d**2) / noisy.sigma**2
    n = round(float(weight.sum()))
    chi = rss / max(n - UNKNOWNS[model.kind], 1)
    return Model(model.kind, surface, model.side, rss + price(model.kind, n), chi, n)


def vertex_weights(
    noisy: NoisyMesh, facets: IntArray, most: int | None = None
) -> tuple[IntArray, FloatArray]:
    """The vertices of a region, at most so many, and their weights, at most 1.

    Where the mesh is denser than on most of the region, vertices count less, by the area that is
    theirs: a fillet too small to be told from the face beside it has many vertices on little area.
    """
    corner = noisy.mesh.triangles[facets].ravel()
    vertices, which = np.unique(corner, return_inverse=True)
    area = np.bincount(which.reshape(-1), np.repeat(noisy.mesh.areas[facets], 3))
    if most is not None:
        some = spread(len(vertices), most)
        vertices, area = vertices[some], area[some]
    return vertices, np.minimum(area / max(float(area.mean()), 1e-300), 1.0)


def price(kind: Kind, count: int) -> float:
    """What a surface of a kind costs by its unknowns and its rarity, in the unit of chi-square."""
    return COUNTED[kind] * float(np.log(max(count, 2))) + PRIOR[kind]
