# SPDX-License-Identifier: LGPL-2.1-or-later
"""Three pictures of a part side by side: truth, recognised classes, regions; errors outlined."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gpswb.core.invariance import CLASSES
from gpswb.core.mesh import FloatArray, IntArray, Mesh
from gpswb.io.colours import NONE, WHEEL
from gpswb.report.raster import Focus, camera, visible_triangles

Image = npt.NDArray[np.uint8]

DIRECTIONS = np.array([[x, y, z] for z in (-0.8, 0.8) for x in (-1, 1) for y in (-0.7, 0.7)])
"""The eight ways to look at a part; the one that shows most of what is wrong is taken."""

BACKGROUND = (255, 255, 255)
OUTLINE = (255, 0, 200)
BORDER = (60, 60, 60)
SIZE = (400, 330)
"""Width and height of one picture, pixels."""


@dataclass(frozen=True, eq=False)
class Labelled:
    """A mesh with all that is to be shown on it.

    Args:
        mesh: the part.
        face: (m,) 0-based face of every triangle; -1 for none.
        truth: true class of every face; None for none.
        label: (m,) recognised class of every triangle as index into ``CLASSES``; -1 for none.
        region: (m,) region of every triangle; -1 for none.
    """

    mesh: Mesh
    face: IntArray
    truth: Sequence[str | None]
    label: IntArray
    region: IntArray


def whole_part(part: Labelled, wrong_faces: IntArray) -> Image:
    """(h, 3 w, 3) picture of the part from where most of the faces to outline can be seen."""
    return _triptych(part, wrong_faces, None)


def close_up(part: Labelled, face: int) -> Image:
    """(h, 3 w, 3) picture of one face, outlined, with its surroundings."""
    own = part.mesh.corners_of(np.flatnonzero(part.face == face)).reshape(-1, 3)
    low, high = own.min(axis=0), own.max(axis=0)
    radius = max(0.7 * float(np.linalg.norm(high - low)), 0.01 * part.mesh.diagonal)
    return _triptych(part, np.array([face]), Focus((low + high) / 2, radius))


def _triptych(part: Labelled, outlined: IntArray, focus: Focus | None) -> Image:
    palette = np.array([WHEEL[name] for name in CLASSES] + [NONE], dtype=np.float64)
    true = [CLASSES.index(t) if t in CLASSES else -1 for t in part.truth]
    bad = np.isin(part.face, outlined)
    view = _best_view(part.mesh, bad, focus)
    seen = visible_triangles(part.mesh, view, *SIZE, focus)
    shade = 0.45 + 0.55 * np.abs(part.mesh.facet_normals @ view[2])
    outline = _edges(np.where(bad[seen] & (seen >= 0), part.face[seen], -1), thick=True)
    lines = _edges(np.where(seen >= 0, part.face[seen], -2), thick=False)
    images = []
    for colours in (
        palette[np.array([*true, -1])[part.face]],
        palette[part.label],
        distinct(part.region),
    ):
        image = np.where(seen[..., None] >= 0, (colours * shade[:, None])[seen], BACKGROUND)
        image[lines] = BORDER
        image[outline] = OUTLINE
        images.append(image.astype(np.uint8))
    return np.concatenate(images, axis=1)


def distinct(label: IntArray) -> FloatArray:
    """(m, 3) colours that tell neighbouring numbers apart; grey for -1."""
    turns = label[:, None] * 0.381966 + np.array([0.0, 1 / 3, 2 / 3])  # the golden angle
    bright = 150.0 + 35.0 * (label[:, None] % 3 - 1)
    colours: FloatArray = bright + 70.0 * np.cos(2 * np.pi * turns)
    colours[label < 0] = NONE
    return colours


def _best_view(mesh: Mesh, bad: npt.NDArray[np.bool_], focus: Focus | None) -> FloatArray:
    """The camera that shows the largest part of the wrong faces, from small trial pictures."""
    views = [camera(direction) for direction in DIRECTIONS]
    if not bad.any() or len(mesh.triangles) > 300_000:
        return views[0]
    score = []
    for view in views:
        seen = visible_triangles(mesh, view, 120, 100, focus)
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
