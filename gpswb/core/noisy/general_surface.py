# SPDX-License-Identifier: LGPL-2.1-or-later
"""The likeliest swept or freeform surface of facets that no simple surface describes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import IntArray
from gpswb.core.noisy.freeform import Freeform, fit_freeform
from gpswb.core.noisy.models import Surface
from gpswb.core.noisy.noisy_mesh import NoisyMesh
from gpswb.core.noisy.swept import Swept
from gpswb.core.noisy.swept_fit import fit_swept, shown_motions
from gpswb.core.slippage import SlippageMoments, slippable_motions

PRIOR: dict[InvarianceClass, float] = {
    "prismatic": 10.0,
    "revolute": 30.0,
    "helical": 50.0,
    "complex": 40.0,
}
"""As those of simple surfaces. An axis far away is as good as a translation, and a long lead as
good as a rotation: the simpler motion is meant where both describe a region."""

SLIP = 0.02
"""Mean squared sine between a motion and the denoised normals up to which a profile is sought: they
are off by up to 0.1 rad, the more so where a region is narrow."""

CLEARLY = 0.7
"""Factor by which normals follow a freer motion better where that is the one."""

LEAST = 30
"""Facets of such a region at least: fewer lie on some swept surface always."""


def general_surface(
    noisy: NoisyMesh, facets: IntArray, moments: SlippageMoments, parts: Sequence[Surface | None]
) -> Swept | Freeform | None:
    """The likeliest swept or freeform surface of some facets."""
    if len(facets) < LEAST:
        return None
    best: Swept | Freeform | None = fit_freeform(noisy, facets)
    if float(slippable_motions(moments)[0][0, 0]) > SLIP:
        return best
    followed = SLIP
    for name, (shown, slip) in shown_motions(noisy, facets).items():
        if slip > followed:
            continue
        followed = CLEARLY * slip
        most = np.inf if best is None else priced(best) - PRIOR[name]
        own = [p for p in parts if isinstance(p, Swept) and p.invariance_class == name]
        starts = [shown, *(part.reference for part in own)]
        swept = fit_swept(noisy, facets, name, starts, most)
        if swept is not None and (best is None or priced(swept) < priced(best)):
            best = swept
    return best


def priced(surface: Swept | Freeform) -> float:
    """Its description length, but for the price of a region."""
    return surface.cost + PRIOR[surface.invariance_class]
