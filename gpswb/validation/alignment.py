# SPDX-License-Identifier: LGPL-2.1-or-later
"""Alignment of a scan with its nominal part: generalised ICP (Segal et al. 2009), by small_gicp.

It measures distances across both local planes: along its surface a point may slide.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gpswb.core.mesh import FloatArray
from gpswb.errors import InputError

REACH = (0.1, 0.03, 0.01)
"""Farthest partners in three rounds, shares of the nominal part's diagonal: a rough placement may
be off by several per cent; at the end noise and form deviation are far smaller than one."""

MOST_POINTS = 30_000
"""Points of the scan that take part: a pose has six numbers."""

NEIGHBOURS = 12
"""Points that tell the local plane of each."""

_STEPS = 100


@dataclass(frozen=True, eq=False)
class Alignment:
    """Where the scan goes.

    Args:
        transform: (4, 4) from the scan's coordinates to the nominal part's.
        paired: share of the points that found a partner in the last round.
    """

    transform: FloatArray
    paired: float


def align(points: FloatArray, target: FloatArray, diagonal: float, start: FloatArray) -> Alignment:
    """Refine a rough placement so that the points lie on the target.

    Args:
        points: (n, 3) of the scan, mm.
        target: (k, 3) dense points of the nominal surface, mm.
        diagonal: of the nominal part, mm.
        start: (4, 4) rough placement of the scan.

    Raises:
        InputError: small_gicp isn't installed, or the scan is too far off to find partners.
    """
    try:
        import small_gicp
    except ImportError as error:
        raise InputError("aligning needs the Python package small-gicp; or --no-align") from error
    chosen = points[:: -(-len(points) // MOST_POINTS)]
    source, goal = small_gicp.PointCloud(chosen), small_gicp.PointCloud(target)
    tree = small_gicp.KdTree(goal)
    small_gicp.estimate_covariances(goal, tree, NEIGHBOURS)
    small_gicp.estimate_covariances(source, small_gicp.KdTree(source), NEIGHBOURS)
    transform = start
    for reach in REACH:
        found = small_gicp.align(
            goal,
            source,
            tree,
            init_T_target_source=transform,
            registration_type="GICP",
            max_correspondence_distance=reach * diagonal,
            max_iterations=_STEPS,
            rotation_epsilon=1e-9,
            translation_epsilon=1e-9 * diagonal,
        )
        if found.num_inliers < 6:
            raise InputError(
                "the scan doesn't lie on the part: place it roughly with --place X,Y,Z,RX,RY,RZ"
            )
        transform = np.array(found.T_target_source, dtype=np.float64)
    return Alignment(
        transform=transform,
        paired=found.num_inliers / len(chosen),
    )


def placement(numbers: Sequence[float]) -> FloatArray:
    """(4, 4) of a translation (mm) and turns about x, then y, then z (degrees)."""
    x, y, z, *turns = numbers
    matrix = np.eye(4)
    for axis, degrees in enumerate(turns):
        c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
        turn = np.eye(4)
        i, j = (axis + 1) % 3, (axis + 2) % 3
        turn[[i, j], [i, j]] = c
        turn[i, j], turn[j, i] = -s, s
        matrix = turn @ matrix
    matrix[:3, 3] = x, y, z
    return matrix
