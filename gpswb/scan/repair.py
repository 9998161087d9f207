# SPDX-License-Identifier: LGPL-2.1-or-later
"""Safe repair of a mesh: nothing is moved by more than rounding, nothing is invented, all is told.

Holes and edges of three or more facets are left as they are: every later step survives them.
"""

from __future__ import annotations

import numpy as np

from gpswb.core.mesh import Mesh
from gpswb.errors import InputError
from gpswb.scan.orientation import components, flips
from gpswb.scan.weld import weld
from gpswb.sentence import Sentence


def repair(mesh: Mesh) -> tuple[Mesh, tuple[str, ...]]:
    """Weld corners at the same place, drop degenerate and repeated facets, orient the rest.

    Returns:
        The mesh, and a note on everything that was done or that a reader should know.

    Raises:
        InputError: no facet with an area is left.
    """
    notes: list[str] = []
    before = len(mesh.triangles)
    mesh = weld(mesh)
    solid = mesh.areas > 0.0
    folded = before - int(solid.sum())
    if folded:
        notes.append(f"{folded} degenerate triangles dropped")
    triangles = mesh.triangles[solid]
    _, first = np.unique(np.sort(triangles, axis=1), axis=0, return_index=True)
    if len(first) < len(triangles):
        notes.append(f"{len(triangles) - len(first)} repeated triangles dropped")
    triangles = triangles[np.sort(first)]
    if not len(triangles):
        raise InputError(Sentence("none of {n} triangles has an area", n=before))
    used, index = np.unique(triangles, return_inverse=True)
    mesh = Mesh(mesh.vertices[used], index.reshape(-1, 3))
    mesh, turned, left = orient(mesh)
    if turned:
        notes.append(f"{turned} of {len(triangles)} triangles turned round")
    if left:
        notes.append(f"{left} edges stay between triangles that run against each other")
    return mesh, (*notes, *topology_notes(mesh))


def orient(mesh: Mesh) -> tuple[Mesh, int, int]:
    """Turn facets so that neighbours run alike and parts look outward.

    Returns:
        The mesh; how many facets were turned; how many neighbours still run against each other.
    """
    flip, left = flips(mesh)
    if flip.any():
        triangles = np.where(flip[:, None], mesh.triangles[:, ::-1], mesh.triangles)
        mesh = Mesh(mesh.vertices, triangles)
    return mesh, int(flip.sum()), left


def topology_notes(mesh: Mesh) -> tuple[str, ...]:
    """What a reader should know of borders, forks and components."""
    notes = []
    ends = np.sort(mesh.triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    _, facets = np.unique(ends, axis=0, return_counts=True)
    if (facets == 1).any():
        notes.append(f"the mesh is open: {int((facets == 1).sum())} border edges")
    if (facets > 2).any():
        notes.append(f"{int((facets > 2).sum())} edges of three or more triangles are borders")
    parts = len(np.unique(components(len(mesh.vertices), mesh.triangles)))
    if parts > 1:
        notes.append(f"{parts} components, partitioned together")
    return tuple(notes)
