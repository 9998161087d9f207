# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts that are fitted once, however many tolerances they are asked about at."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.robust.hypotheses import Hypothesis, bend_of, explain
from gpswb.core.robust.patches import patches_of

LEAST_BEND = 4.0
"""Tolerances that a part's vertices must leave their mean plane by: a flatter one proves nothing,
and its halves are flatter still."""


@dataclass(frozen=True, eq=False)
class Trial:
    """What fits to b parts say.

    Args:
        hypotheses: the surfaces that explain some of them.
        bend: (b,) mm, how far each leaves its mean plane.
        residual: (b,) mm, what the nearest surface of any kind leaves of it; infinite where it is
            too flat to be fitted.
        freeform: (b,) mm, what the best torus leaves of those that look freeform, 0 for the others.
        bent: (b,) those that aren't too flat.
        fresh: (b,) those that were fitted now, and not at a narrower tolerance.
    """

    hypotheses: list[Hypothesis]
    bend: FloatArray
    residual: FloatArray
    freeform: FloatArray
    bent: BoolArray
    fresh: BoolArray


class Trials:
    """Fits to parts of one mesh.

    What surfaces leave of a part hardly depends on the tolerance: a part of which they left more
    than a wider one is not fitted again.
    """

    def __init__(self, mesh: Mesh) -> None:
        self._mesh = mesh
        self._known: dict[tuple[int, bytes], tuple[float, float, float]] = {}

    def of(self, facets: IntArray, size: IntArray, tolerance: float) -> Trial:
        """Fit parts.

        Args:
            facets: (b, f) samples of the parts' facets, -1 for padding.
            size: (b,) facets of each part.
            tolerance: distance that counts as none, mm.
        """
        keys = [(int(n), row[row >= 0].tobytes()) for n, row in zip(size, facets, strict=True)]
        said = np.array([self._known.get(key, (0.0, 0.0, 0.0)) for key in keys]).reshape(-1, 3).T
        bend, residual, freeform = said
        new = np.flatnonzero(~(residual > tolerance))
        hypotheses: list[Hypothesis] = []
        if len(new):
            patches = patches_of(self._mesh, facets[new])
            bend[new] = bend_of(patches) * patches.scale
            residual[new], freeform[new] = np.inf, 0.0
        bent = bend > LEAST_BEND * tolerance
        fresh = np.zeros(len(bent), dtype=bool)
        fresh[new] = bent[new]
        some = np.flatnonzero(bent[new])
        if len(some):
            found = explain(self._mesh, patches.take(some), size[new[some]], tolerance)
            hypotheses = found.hypotheses
            residual[new[some]], freeform[new[some]] = found.residual, found.freeform
            for i in new[some]:
                self._known[keys[i]] = (bend[i], residual[i], freeform[i])
        return Trial(hypotheses, bend, residual, freeform, bent, fresh)
