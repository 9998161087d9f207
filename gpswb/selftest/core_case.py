# SPDX-License-Identifier: LGPL-2.1-or-later
"""The algorithms run in FreeCAD's own Python."""

from __future__ import annotations

import unittest

import numpy as np

from gpswb.core.mesh import Mesh
from gpswb.core.pipeline import partition


class CoreCase(unittest.TestCase):
    """A mesh that no CAD kernel has seen is partitioned into its true surfaces."""

    def test_cylinder_mesh(self) -> None:
        result = partition(_cylinder(radius=10.0, height=25.0, around=48, along=12))
        classes = sorted(region.invariance_class for region in result.regions)
        self.assertEqual(classes, ["cylindrical", "planar", "planar"])
        side = next(r for r in result.regions if r.invariance_class == "cylindrical")
        self.assertAlmostEqual(side.intrinsic["radius"], 10.0, places=6)


def _cylinder(radius: float, height: float, around: int, along: int) -> Mesh:
    """A closed cylinder about z, its vertices on the surface: rings, then the two caps' centres."""
    angle = 2 * np.pi * np.arange(around) / around
    circle = radius * np.column_stack([np.cos(angle), np.sin(angle)])
    levels = np.repeat(np.linspace(0.0, height, along + 1), around)
    rings = np.column_stack([np.tile(circle, (along + 1, 1)), levels])
    vertices = np.vstack([rings, [[0.0, 0.0, 0.0], [0.0, 0.0, height]]])
    here = np.arange(around)
    following = (here + 1) % around
    triangles = []
    for level in range(along):
        low, high = level * around, (level + 1) * around
        triangles.append(np.column_stack([low + here, low + following, high + following]))
        triangles.append(np.column_stack([low + here, high + following, high + here]))
    bottom, top = len(rings), len(rings) + 1
    last = along * around
    triangles.append(np.column_stack([np.full(around, bottom), following, here]))
    triangles.append(np.column_stack([np.full(around, top), last + here, last + following]))
    return Mesh(vertices, np.vstack(triangles))
