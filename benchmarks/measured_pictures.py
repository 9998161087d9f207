# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of partitions for docs/measured.md: panels of one part, labelled."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from PIL import Image

from gpswb.core.invariance import CLASSES
from gpswb.core.mesh import Mesh
from gpswb.io.colours import NONE, SHAPE_TYPES, WHEEL
from gpswb.report.picture import distinct
from gpswb.report.raster import camera, visible_triangles

SIZE = (460, 400)


def by_class(label: np.ndarray) -> np.ndarray:
    """(m, 3) colours of the shape colour wheel."""
    return np.array([WHEEL[name] for name in CLASSES] + [NONE], dtype=float)[label]


def by_shape(shape: np.ndarray) -> np.ndarray:
    """(m, 3) colours of the shape types."""
    return np.array([colour for _, colour in SHAPE_TYPES], dtype=float)[shape + 4]


def by_region(region: np.ndarray) -> np.ndarray:
    """(m, 3) colours that tell regions apart."""
    return distinct(region)


def render(mesh: Mesh, colours: np.ndarray, toward: Sequence[float]) -> np.ndarray:
    """(h, w, 3) picture of a mesh, facets shaded."""
    view = camera(np.array(toward, dtype=float))
    seen = visible_triangles(mesh, view, *SIZE)
    shade = 0.45 + 0.55 * np.abs(mesh.facet_normals @ view[2])
    return np.where(seen[..., None] >= 0, (colours * shade[:, None])[seen], 255).astype(np.uint8)


def render_points(points: np.ndarray, toward: Sequence[float]) -> np.ndarray:
    """(h, w, 3) picture of a cloud, a pixel a point, the near ones darker."""
    view = camera(np.array(toward, dtype=float))
    x = points @ view.T
    low, high = x.min(axis=0), x.max(axis=0)
    scale = 0.94 * min(SIZE[0] / (high - low)[0], SIZE[1] / (high - low)[1])
    flat = ((x - (low + high) / 2)[:, :2] * scale * [1, -1] + np.array(SIZE) / 2).astype(int)
    image = np.full((SIZE[1], SIZE[0], 3), 255, dtype=np.uint8)
    order = np.argsort(x[:, 2])
    grey = 200 - 170 * (x[order, 2] - low[2]) / (high - low)[2]
    image[flat[order, 1], flat[order, 0]] = grey[:, None]
    return image


def panels(
    path: Path, pictures: Sequence[Sequence[tuple[str, np.ndarray]]], classes: Sequence[str]
) -> None:
    """Write rows of titled pictures, and a legend of the classes that occur, as a PNG."""
    rows, columns = len(pictures), max(map(len, pictures))
    figure = Figure(figsize=(3.6 * columns, 3.45 * rows + 0.4), layout="constrained")
    canvas = FigureCanvasAgg(figure)
    axes = figure.subplots(rows, columns, squeeze=False)
    for axis in axes.flat:
        axis.set_axis_off()
    for line, row in zip(axes, pictures, strict=True):
        for axis, (title, image) in zip(line, row, strict=False):
            axis.imshow(image)
            axis.set_title(title, fontsize=10)
    legend = [Patch(color=np.array(WHEEL[name]) / 255, label=name) for name in classes]
    figure.legend(handles=legend, loc="outside lower center", ncols=7, fontsize=9, frameon=False)
    canvas.draw()
    picture = Image.fromarray(np.asarray(canvas.buffer_rgba())[..., :3])
    path.parent.mkdir(parents=True, exist_ok=True)
    picture.quantize(256, Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE).save(
        path, optimize=True
    )


def occurring(*labels: np.ndarray) -> list[str]:
    """The classes that occur, in their order."""
    found = set(np.concatenate([np.unique(label) for label in labels]).tolist())
    return [name for i, name in enumerate(CLASSES) if i in found]
