# SPDX-License-Identifier: LGPL-2.1-or-later
"""The simplest surface that explains each of many parts of a mesh, where one does."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.robust.fitting import fit, fit_patches
from gpswb.core.robust.growth import to_world
from gpswb.core.robust.patches import Patches
from gpswb.core.robust.surfaces import UNKNOWNS, Kind, distance

KINDS: tuple[Kind, ...] = ("cylinder", "cone", "sphere", "torus")
"""Ruled kinds first: two rings of vertices lie on a cylinder or cone, but also on spheres."""

ROBUST_SHARE = 0.3
"""Share of a part that a robust fit must explain: below it hypotheses are found by chance."""

ROBUST_LEAST = 16
"""Vertices of a part in which a robust fit may choose; smaller parts are halved instead."""

FITTED = 48
"""Vertices of a part that a surface is fitted to: seven unknowns need far fewer. All are asked
whether they lie on it."""

FEW = 12
"""Facets with fewer of which pieces of anything lie near some surface: such a part doesn't look
freeform, and no half is that small where the tolerance is wider than rounding."""

FREEFORM = 0.03
"""A part whose best torus leaves less than this share of the part's own height, but more than the
tolerance, looks like a piece of a freeform surface. Two tangent surfaces of nearly equal curvature
look so, too, but not the halves of their part: two levels in a row must."""


@dataclass(frozen=True)
class Hypothesis:
    """A surface that explains a part: ``seed`` lies on it, ``score`` is the number of facets."""

    kind: Kind
    surface: FloatArray
    seed: int
    score: float


@dataclass(frozen=True, eq=False)
class Explained:
    """What was found of b patches.

    Args:
        hypotheses: the surfaces that explain some of them.
        freeform: (b,) mm, what the best torus leaves of those that look freeform, 0 for the others.
        residual: (b,) mm, what the nearest surface of any kind leaves of each.
    """

    hypotheses: list[Hypothesis]
    freeform: FloatArray
    residual: FloatArray


def explain(mesh: Mesh, patches: Patches, size: IntArray, tolerance: float) -> Explained:
    """The simplest surface that explains each patch, where one does.

    Plain least squares first; where a patch crosses a border, a robust fit may still find the
    surface that most of it lies on.

    Args:
        mesh: the mesh.
        patches: b patches.
        size: (b,) facets of the part that each patch is a sample of.
        tolerance: distance that counts as none, mm.
    """
    hypotheses: list[Hypothesis] = []
    freeform = np.zeros(len(patches.centre))
    residual = np.full(len(freeform), np.inf)
    nearest: dict[Kind, FloatArray] = {kind: np.zeros((len(freeform), 8)) for kind in KINDS}
    left = np.arange(len(patches.centre))
    few = patches.thinned(FITTED)
    enough = tolerance / patches.scale
    for robust in (False, True):
        for kind in KINDS:
            if robust:
                # A torus has too many unknowns to choose its points without a good first guess.
                left = left[(freeform[left] > 0.0) | (kind != "torus")]
            if not len(left):
                continue
            some = patches.take(left)
            floor = enough[left] if robust else None
            thin = few.take(left)
            if robust and kind == "torus":
                local = fit(kind, nearest[kind][left], thin.points, thin.weights, floor)
            else:
                local = fit_patches(
                    kind,
                    thin.points,
                    thin.weights,
                    thin.centroids,
                    thin.normals,
                    floor,
                    enough[left],
                    nearest["cylinder"][left] if kind == "cone" else None,
                )
            nearest[kind][left] = local
            world = to_world(local, some.centre, some.scale, kind)
            d, _ = distance(kind, local, some.points)
            d = np.where(some.weights > 0, np.abs(d), 0.0)
            inside = (d <= enough[left, None]) & (some.weights > 0)
            share = inside.sum(axis=1) / np.maximum(some.weights.sum(axis=1), 1.0)
            # A robust fit chooses its own points: it needs more of them to prove something.
            good = inside.sum(axis=1) - UNKNOWNS[kind] >= (3 if robust else 2)
            good &= (share >= (ROBUST_SHARE if robust else 1.0)) & _is_finite(kind, local)
            for row in np.flatnonzero(good):
                seed = _seed(mesh, kind, world[row], some.facets[row], tolerance)
                if seed is not None:
                    score = float(share[row] * size[left[row]])
                    hypotheses.append(Hypothesis(kind, world[row], seed, score))
            worst = np.nan_to_num(d.max(axis=1), nan=np.inf)
            residual[left] = np.minimum(residual[left], worst * some.scale)
            if kind == "torus" and not robust:
                looks = ~good & (worst < FREEFORM * bend_of(some)) & (size[left] >= FEW)
                freeform[left[looks]] = (worst * some.scale)[looks]
            # What a robust fit explains in part is no freeform surface.
            freeform[left[good]] = 0.0
            left = left[~good]
        left = left[patches.weights[left].sum(axis=1) >= ROBUST_LEAST]
    return Explained(hypotheses, freeform, residual)


def _seed(
    mesh: Mesh, kind: Kind, surface: FloatArray, facets: IntArray, tolerance: float
) -> int | None:
    """The largest of some facets (-1 for none) that has its corners on a surface."""
    facets = facets[facets >= 0]
    d, _ = distance(kind, surface[None], mesh.corners_of(facets).reshape(1, -1, 3))
    on = facets[(np.abs(d).reshape(-1, 3) <= tolerance).all(axis=1)]
    return int(on[np.argmax(mesh.areas[on])]) if len(on) else None


def bend_of(patches: Patches) -> FloatArray:
    """(b,) how far each patch's vertices leave its mean plane, in local units."""
    moment = np.einsum("bni,bnj->bij", patches.points, patches.points)
    normal = np.linalg.eigh(moment)[1][:, :, 0]
    height = np.einsum("bnk,bk->bn", patches.points, normal)
    sagitta: FloatArray = np.ptp(height, axis=1)
    return sagitta


def _is_finite(kind: Kind, local: FloatArray) -> BoolArray:
    """Whether the surface bends at all on the scale of its patch; else it is all but a plane."""
    size = local[:, 7] if kind == "torus" else local[:, 6]
    finite: BoolArray = np.isfinite(local).all(axis=1) & (np.abs(size) < 1e3)
    return finite
