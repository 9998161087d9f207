# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every threshold of the paper's method in one place, each with its reason."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Tolerances:
    """Thresholds of the modes `corrected` and of the steps it shares with `robust`.

    All are pure numbers: angles in radians, lengths as a share of the bounding-box diagonal, so
    that the result depends neither on the unit nor on the size of the part.
    """

    always_sharp: float = 0.7
    """Turning angle (40 deg) above which an edge is sharp whatever surrounds it: the coarsest usual
    export turns by 0.5 rad an edge on a smooth surface."""

    never_sharp: float = 0.03
    """Turning angle (1.7 deg) below which no edge is sharp: shallower creases than this can't be
    told from the chords of a large smooth surface."""

    sharp_factor: float = 3.0
    """How far an edge must out-turn what the curvature beside it predicts. A single-strip fillet
    turns twice the prediction at both its borders, so the factor must exceed 2."""

    sagitta: float = 2e-6
    """A facet is plane when the sagitta c l^2 / 8 over its longest edge is below this share of the
    diagonal (the printed limit on c alone, 1e-5, carries a unit)."""

    vote_sweeps: int = 20
    """Cap on the voting sweeps (paper, 5.2.1 leaves the convergence condition open)."""

    signature_width: float = 0.1
    """Width w of the Gaussian G of equation (12)."""

    similarity: float = 0.5
    """Least similarity at which two regions merge: G falls to 0.5 at a signature angle of 7 deg."""

    slippable: float = 2e-4
    """Mean squared sine below which a motion counts as slippable on noise-free normals interpolated
    from corner normals (measured: 1e-20 to 6e-6 for true motions, 5e-4 for the least false one)."""

    coarse: float = 0.05
    """Added to ``slippable`` for each squared radian of a region's mean squared turning angle:
    where a border mixes two surfaces, outermost normals are off by a quarter of the turning."""

    confident_facets: int = 12
    """Regions of fewer facets are ambiguous: a short strip of a cylinder lies on a sphere too."""

    distance: float = 1e-4
    """Nominal vertices lie on their surface: how far (share of the region's size) they may stand
    off at once."""

    form: float = 2e-3
    """How far (share of the region's size) they may stand off where no less symmetric class does
    better: the form deviation of a surface that is not nominal."""

    form_gain: float = 2.0
    """A less symmetric class does better when it stands off less by this factor."""


@dataclass(frozen=True)
class PaperSettings:
    """The constants of mode `paper`, as printed or, where the print gives none, as usual.

    They keep the unit dependence of the print: ``plane_curvedness`` is in 1/mm and the condition
    number compares rotations (mm^2) with translations (1).
    """

    edge_coefficient: float = 1.0
    """lambda of equation (7); the print's default."""

    plane_curvedness: float = 1e-5
    """p_c of Table 5, 1/mm; the print's example."""

    vote_sweeps: int = 20
    """Cap on the synchronous sweeps, which otherwise may oscillate for ever."""

    condition_number: float = 150.0
    """g_set of equation (3): the value usual after Gelfand and Guibas; the print gives none."""

    signature_width: float = 0.1
    """Width of the Gaussian of equation (12); the print gives none."""

    similarity: float = 0.1
    """Least similarity at which regions merge; the print gives none. As both confidences multiply
    it, a larger one leaves every small region unmerged."""

    component_size: int = 20
    """N of equation (13), vertices: desired size of a component; the print gives none."""
