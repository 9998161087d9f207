# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can be counted on a mesh, whatever made it."""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import Mesh


def open_sides(mesh: Mesh) -> int:
    """Sides that don't belong to exactly two triangles which run along them in opposite ways."""
    t = mesh.triangles
    ways = np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]])
    directed = {tuple(w) for w in ways.tolist()}
    twice = len(ways) - len(directed)
    return twice + sum((b, a) not in directed for a, b in directed)


def volume(mesh: Mesh) -> float:
    c = mesh.corners
    return float(np.einsum("ij,ij->", c[:, 0], np.cross(c[:, 1], c[:, 2])) / 6)


def aspects(mesh: Mesh) -> np.ndarray:
    """Longest side over the height on it."""
    c = mesh.corners
    longest = np.linalg.norm(np.roll(c, -1, axis=1) - c, axis=2).max(axis=1)
    return longest**2 / (2 * mesh.areas)


def sides(mesh: Mesh) -> np.ndarray:
    c = mesh.corners
    return np.linalg.norm(np.roll(c, -1, axis=1) - c, axis=2).ravel()
