# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pair of pictures of a part: truth and what was recognised, wrong faces outlined."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from gpswb.core.invariance import CLASSES
from gpswb.core.mesh import FloatArray, IntArray, Mesh
from gpswb.io.colours import NONE, WHEEL
from gpswb.report.raster import camera, visible_triangles

Image = npt.NDArray[np.uint8]

DIRECTIONS = np.array([[x, y, z] for z in (-0.8, 0.8) for x in (-1, 1) for y in (-0.7, 0.7)])
"""The eight ways to look at a part; the one that shows most of what is wrong is taken."""

BACKGROUND = (255, 255, 255)
OUTLINE = (255, 0, 200)
BORDER = (60, 60, 60)


def truth_and_recognised(
    mesh: Mesh,
    face: IntArray,
    truth: Sequence[str | None],
    label: IntArray,
    wrong_faces: IntArray,
    width: int = 420,
    height: int = 340,
) -> Image:
    """(height, 2·width, 3) picture: left coloured by truth, right by the recognised class.

    Args:
        mesh: the part.
        face: (m,) 0-based face of every triangle; -1 for none.
        truth: true class of every face; None for none.
        label: (m,) recognised class of every triangle as index into ``CLASSES``; -1 for none.
        wrong_faces: 0-based faces to outline.
        width, height: of one half, pixels.
    """
    palette = np.array([WHEEL[name] for name in CLASSES] + [NONE], dtype=np.float64)
    true = np.array([CLASSES.index(t) if t in CLASSES else -1 for t in truth] + [-1])[face]
    bad = np.isin(face, wrong_faces)
    view = _best_view(mesh, bad)
    seen = visible_triangles(mesh, view, width, height)
    shade = 0.45 + 0.55 * np.abs(mesh.facet_normals @ view[2])
    outline = _edges(np.where(bad[seen] & (seen >= 0), face[seen], -1), thick=True)
    lines = _edges(np.where(seen >= 0, face[seen], -2), thick=False)
    halves = []
    for kind in (true, label):
        colour = palette[kind] * shade[:, None]
        image = np.where(seen[..., None] >= 0, colour[seen], BACKGROUND)
        image[lines] = BORDER
        image[outline] = OUTLINE
        halves.append(image.astype(np.uint8))
    return np.concatenate(halves, axis=1)


def _best_view(mesh: Mesh, bad: npt.NDArray[np.bool_]) -> FloatArray:
    """The camera that shows the largest part of the wrong faces, from small trial pictures."""
    views = [camera(direction) for direction in DIRECTIONS]
    if not bad.any() or len(mesh.triangles) > 300_000:
        return views[0]
    score = []
    for view in views:
        seen = visible_triangles(mesh, view, 120, 100)
        score.append(int(bad[seen[seen >= 0]].sum()))
    return views[int(np.argmax(score))]


def _edges(label: IntArray, thick: bool) -> npt.NDArray[np.bool_]:
    """Pixels at which the label changes."""
    edge = np.zeros(label.shape, dtype=bool)
    across = label[:, 1:] != label[:, :-1]
    down = label[1:] != label[:-1]
    edge[:, 1:] |= across
    edge[1:] |= down
    if thick:
        edge[:, :-1] |= across
        edge[:-1] |= down
    return edge
