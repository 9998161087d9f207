# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one entry of the core: partition a mesh and recognise its regions."""

from __future__ import annotations

from typing import Literal

import numpy as np

from gpswb.core.as_printed import partition_as_printed
from gpswb.core.corrected import partition_corrected
from gpswb.core.mesh import Mesh
from gpswb.core.noise import estimate_noise
from gpswb.core.partition import Partition
from gpswb.core.rival_curvature import partition_by_curvature
from gpswb.core.rival_slippage import partition_by_slippage
from gpswb.core.robust.pipeline import partition_robust
from gpswb.core.stages import Progress
from gpswb.errors import InputError

Mode = Literal["robust", "corrected", "paper"]
Method = Literal["hybrid", "curvature", "slippage"]


def partition(
    mesh: Mesh,
    *,
    mode: Mode = "robust",
    method: Method = "hybrid",
    noise: float | None = None,
    progress: Progress | None = None,
) -> Partition:
    """Partition a mesh into regions and recognise the invariance class of each.

    Args:
        mesh: the mesh, mm.
        mode: `robust`, `corrected` (the paper's flow with its errors mended) or `paper` (as
            printed); read for the method `hybrid` only.
        method: `hybrid`, or one of the paper's rivals, `curvature` or `slippage`.
        noise: standard deviation of the vertices, mm; estimated from the mesh if not given.
        progress: told the stage and the fraction of it that is done.

    Returns:
        The partition; its facets in no region are the degenerate ones.

    Raises:
        InputError: no facet has an area, or the noise is negative or not finite.
        ValueError: an unknown mode or method.
    """
    if mode not in ("robust", "corrected", "paper"):
        raise ValueError(f"unknown mode {mode!r}: robust, corrected or paper")
    if method not in ("hybrid", "curvature", "slippage"):
        raise ValueError(f"unknown method {method!r}: hybrid, curvature or slippage")
    if noise is not None and not (np.isfinite(noise) and noise >= 0.0):
        raise InputError(f"the noise must be a length of at least 0 mm, not {noise}")
    if not (mesh.areas > 0.0).any():
        raise InputError(
            f"nothing to partition: none of {len(mesh.triangles)} triangles has an area"
        )
    sigma = estimate_noise(mesh) if noise is None else float(noise)
    if method == "curvature":
        return partition_by_curvature(mesh, sigma, progress=progress)
    if method == "slippage":
        return partition_by_slippage(mesh, sigma, progress=progress)
    if mode == "paper":
        return partition_as_printed(mesh, sigma, progress=progress)
    if mode == "corrected":
        return partition_corrected(mesh, sigma, progress=progress)
    return partition_robust(mesh, sigma, progress=progress)
