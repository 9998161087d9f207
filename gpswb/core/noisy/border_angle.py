# SPDX-License-Identifier: LGPL-2.1-or-later
"""Creases that denoised normals don't show: two surfaces that meet at an angle."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gpswb.core.mesh import IntArray
from gpswb.core.noisy.models import Surface
from gpswb.core.noisy.noisy_mesh import NoisyMesh

CREASE = 0.35
"""Angle (rad) between two surfaces along their border from which it may be a crease: chamfers have
twice as much, and denoised normals don't show creases that are smaller."""

LEVER = 8.0
"""An angle that far above sigma over the widths of both regions is a crease: pieces of one smooth
surface stay within two sigma of it, so that they can't meet at more."""


def meet_at_crease(
    noisy: NoisyMesh,
    surfaces: Sequence[Surface],
    regions: Sequence[IntArray],
    border: IntArray,
) -> bool:
    """Whether two surfaces meet at an angle that pieces of one smooth surface can't have.

    Args:
        noisy: the mesh and its noise.
        surfaces: the two.
        regions: facets that lie on each.
        border: (e,) the edges between them, as rows of the graph's pairs.
    """
    mesh = noisy.mesh
    ends = mesh.vertices[noisy.graph.pair_edges[border]]
    length = max(float(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum()), 1e-300)
    first, second = (s.side * s.distance(ends.mean(axis=1))[1] for s in surfaces)
    sine = np.linalg.norm(np.cross(first, second), axis=1)
    angle = float(np.median(np.arctan2(sine, np.einsum("nk,nk->n", first, second))))
    natural = 0.0
    for facets in regions:
        area = float(mesh.areas[facets].sum())
        natural += noisy.sigma / max(min(area / length, area**0.5), 1e-300)
    return angle > max(CREASE, LEVER * natural)
