# SPDX-License-Identifier: LGPL-2.1-or-later
"""The likeliest swept or freeform surface of facets that no simple surface describes."""

from __future__ import annotations

from collections.abc import Sequence

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import IntArray
from gpswb.core.noisy.freeform import Freeform, fit_freeform
from gpswb.core.noisy.noisy_mesh import NoisyMesh
from gpswb.core.noisy.swept import MOTIONS, Swept
from gpswb.core.noisy.swept_fit import SLIP, fit_swept
from gpswb.core.reference import Reference
from gpswb.core.slippage import SlippageMoments, slippable_motions

PRIOR: dict[InvarianceClass, float] = {
    "prismatic": 10.0,
    "revolute": 30.0,
    "helical": 50.0,
    "complex": 40.0,
}
"""As those of simple surfaces. An axis far away is as good as a translation, and a long lead as
good as a rotation: the simpler motion is meant where both describe a region."""

LEAST = 30
"""Facets of such a region at least: fewer lie on some swept surface always."""


def general_surface(
    noisy: NoisyMesh, facets: IntArray, moments: SlippageMoments, starts: Sequence[Reference]
) -> Swept | Freeform | None:
    """The likeliest swept or freeform surface of some facets."""
    if len(facets) < LEAST:
        return None
    best: Swept | Freeform | None = fit_freeform(noisy, facets)
    if float(slippable_motions(moments)[0][0, 0]) > SLIP:
        return best
    for name in MOTIONS:
        if name == "helical" and isinstance(best, Swept) and best.explains:
            break
        swept = fit_swept(noisy, facets, name, starts)
        if swept is not None and (best is None or priced(swept) < priced(best)):
            best = swept
    return best


def priced(surface: Swept | Freeform) -> float:
    """Its description length, but for the price of a region."""
    return surface.cost + PRIOR[surface.invariance_class]
