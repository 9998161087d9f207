# SPDX-License-Identifier: LGPL-2.1-or-later
"""A scanner that never was: points of a part with noise, uneven density, gaps and outliers."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gpswb.cad.solid import Solid
from gpswb.core.invariance import CLASSES
from gpswb.core.mesh import FloatArray, IntArray

TIGHT = 0.05
"""Spread of the outliers that lie near the part, as a share of its diagonal."""


@dataclass(frozen=True)
class Scanner:
    """How a scan is simulated.

    Args:
        points: number of points before gaps are cut out, outliers not counted.
        noise: standard deviation along the surface's normal, mm.
        unevenness: how many times as dense as the least dense side the densest one is seen.
        gaps: number of balls in which nothing was seen.
        gap_radius: mm.
        outliers: share of points that are none of the part's.
        seed: of all that is drawn.
    """

    points: int
    noise: float
    unevenness: float = 4.0
    gaps: int = 6
    gap_radius: float = 2.0
    outliers: float = 0.005
    seed: int = 17


@dataclass(frozen=True, eq=False)
class SimulatedScan:
    """A scan and its truth.

    Args:
        points: (n, 3) mm, in random order.
        face: (n,) 0-based face of the part; -1 for outliers.
        label: (n,) true class as index into ``CLASSES``; -1 for outliers.
    """

    points: FloatArray
    face: IntArray
    label: IntArray


def simulate(solid: Solid, scanner: Scanner) -> SimulatedScan:
    """Scan a tessellated part; its chord error should be small against the noise.

    Raises:
        ValueError: the solid has no faces.
    """
    if solid.facemap is None:
        raise ValueError("a scan with known classes needs a part with faces")
    mesh, random = solid.mesh, np.random.default_rng(scanner.seed)
    # A scanner sees best what faces it; it stood up in front, on the right.
    view = np.array([0.5, -0.6, 0.6]) / np.linalg.norm([0.5, -0.6, 0.6])
    facing = 0.5 * (1.0 + mesh.facet_normals @ view)
    weight = mesh.areas * (1.0 + (scanner.unevenness - 1.0) * facing)
    facet = random.choice(len(weight), scanner.points, p=weight / weight.sum())
    u, v = random.uniform(size=(2, scanner.points))
    over = u + v > 1
    u, v = np.where(over, 1 - u, u)[:, None], np.where(over, 1 - v, v)[:, None]
    a, b, c = np.moveaxis(mesh.corners[facet], 1, 0)
    on = a + u * (b - a) + v * (c - a)
    height = random.normal(0.0, scanner.noise, (scanner.points, 1))
    points = on + height * mesh.facet_normals[facet]
    centres = on[random.choice(len(on), scanner.gaps, replace=False)]
    seen = np.ones(len(on), dtype=bool)
    for centre in centres:
        seen &= np.linalg.norm(on - centre, axis=1) > scanner.gap_radius
    count = int(scanner.outliers * scanner.points)
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    far = random.uniform(low - 0.1 * (high - low), high + 0.1 * (high - low), (count, 3))
    near = on[random.choice(len(on), count)] + random.normal(0.0, TIGHT * mesh.diagonal, (count, 3))
    strays = np.where(np.arange(count)[:, None] % 2, far, near)
    face = solid.facemap.face_of_triangle[facet]
    truth = np.array(
        [CLASSES.index(f.truth.nominal) if f.truth else -1 for f in solid.facemap.faces]
    )
    none = np.full(count, -1, dtype=np.int64)
    order = random.permutation(int(seen.sum()) + count)
    return SimulatedScan(
        points=np.concatenate([points[seen], strays])[order],
        face=np.concatenate([face[seen], none])[order],
        label=np.concatenate([truth[face[seen]], none])[order],
    )
