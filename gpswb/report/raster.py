# SPDX-License-Identifier: LGPL-2.1-or-later
"""An orthographic z-buffer: which triangle each pixel sees."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gpswb.core.mesh import FloatArray, IntArray, Mesh

CHUNK = 1_000_000
"""Most pixel candidates tested at once: bounds the memory."""


def camera(toward: FloatArray) -> FloatArray:
    """(3, 3) rows right, up, back of a camera that looks along ``toward`` with z up."""
    back = -np.asarray(toward, dtype=np.float64) / np.linalg.norm(toward)
    up = np.array([0.0, 0.0, 1.0]) if abs(back[2]) < 0.99 else np.array([0.0, 1.0, 0.0])
    right = np.cross(up, back)
    right /= np.linalg.norm(right)
    return np.array([right, np.cross(back, right), back])


@dataclass(frozen=True, eq=False)
class Focus:
    """What a close-up shows: a ball, and nothing that stands well before it.

    Args:
        centre: (3,) mm.
        radius: mm.
    """

    centre: FloatArray
    radius: float


def visible_triangles(
    mesh: Mesh, view: FloatArray, width: int, height: int, focus: Focus | None = None
) -> IntArray:
    """(height, width) int64 index of the triangle seen at each pixel; -1 for the background.

    The mesh, or the ball in focus, fills the picture but for a margin of 3 %.

    Args:
        mesh: what to draw.
        view: (3, 3) rows right, up, back, from `camera`.
        width, height: size of the picture, pixels.
        focus: of a close-up; None for the whole mesh.
    """
    image = np.full(width * height, -1, dtype=np.int64)
    if not len(mesh.triangles):
        return image.reshape(height, width)
    seen = mesh.vertices @ view.T
    low, high = seen.min(axis=0), seen.max(axis=0)
    if focus is not None:
        low, high = (view @ focus.centre + side * focus.radius for side in (-1, 1))
    span = np.maximum(high - low, 1e-12 + 1e-9 * mesh.diagonal)
    scale = 0.94 * min(width / span[0], height / span[1])
    flat = (seen[:, :2] - (low + high)[:2] / 2) * scale * [1, -1] + [width / 2, height / 2]
    corner = flat[mesh.triangles]  # (m, 3, 2)
    depth = seen[:, 2][mesh.triangles]
    frame = np.array([width, height])
    first = np.ceil(np.clip(corner.min(axis=1), -1, frame + 1) - 0.5).astype(np.int64)
    last = np.floor(np.clip(corner.max(axis=1), -1, frame + 1) - 0.5).astype(np.int64)
    # A triangle between the pixel centres is still drawn as a point, lest tiny faces vanish.
    last = np.maximum(last, first)
    shown = ((last >= 0) & (first < frame)).all(axis=1)
    if focus is not None:
        shown &= depth.max(axis=1) <= high[2] + focus.radius
    first, last = np.maximum(first, 0), np.minimum(last, frame - 1)
    size = np.where(shown, (last - first + 1).prod(axis=1), 0)
    nearest = np.full(width * height, -np.inf)
    order = np.argsort(size, kind="stable")[int((~shown).sum()) :]
    ends = np.searchsorted(np.cumsum(size[order]), np.arange(CHUNK, size.sum() + CHUNK, CHUNK))
    start = 0
    for end in np.unique(np.minimum(ends + 1, len(order))):
        part = order[start:end]
        start = int(end)
        triangle, pixel, z = _fragments(
            part, first[part], last[part], corner[part], depth[part], width, height
        )
        turn = np.argsort(z, kind="stable")  # the nearest is written last and stays
        triangle, pixel, z = triangle[turn], pixel[turn], z[turn]
        front = z > nearest[pixel]
        image[pixel[front]] = triangle[front]
        nearest[pixel[front]] = z[front]
    return image.reshape(height, width)


def _fragments(
    index: IntArray,
    first: IntArray,
    last: IntArray,
    corner: FloatArray,
    depth: FloatArray,
    width: int,
    height: int,
) -> tuple[IntArray, IntArray, FloatArray]:
    """Triangle, pixel and depth of every pixel centre inside a triangle."""
    extent = last - first + 1
    size = extent.prod(axis=1)
    which = np.repeat(np.arange(len(index)), size)
    serial = np.arange(len(which)) - np.repeat(np.cumsum(size) - size, size)
    row, column = np.divmod(serial, extent[which, 0])
    x, y = first[which, 0] + column, first[which, 1] + row
    a, b, c = corner[:, 0], corner[:, 1], corner[:, 2]
    area = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    inverse = np.divide(1.0, area, out=np.zeros_like(area), where=area != 0)
    px, py = x + 0.5 - a[which, 0], y + 0.5 - a[which, 1]
    e, f = (b - a)[which], (c - a)[which]
    v = (px * f[:, 1] - py * f[:, 0]) * inverse[which]
    w = (py * e[:, 0] - px * e[:, 1]) * inverse[which]
    small = size[which] == 1
    inside = small | ((v >= -1e-9) & (w >= -1e-9) & (v + w <= 1 + 1e-9) & (area[which] != 0))
    inside &= (x >= 0) & (x < width) & (y >= 0) & (y < height)
    v, w, which = np.clip(v[inside], 0, 1), np.clip(w[inside], 0, 1), which[inside]
    z = depth[which, 0] + v * (depth[which, 1] - depth[which, 0])
    z += w * (depth[which, 2] - depth[which, 0])
    return index[which], (y[inside] * width + x[inside]), z
