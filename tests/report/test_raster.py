# SPDX-License-Identifier: LGPL-2.1-or-later
"""The z-buffer against areas and depths that are known."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from made_parts import sheet

from gpswb.core.mesh import Mesh
from gpswb.report.raster import Focus, camera, visible_triangles

DOWN = camera(np.array([0.0, 0.0, -1.0]))


def plate(z: float, half: float, cells: int = 1) -> tuple:
    h = half
    return sheet([[-h, -h, z], [h, -h, z], [h, h, z], [-h, h, z]], (cells, cells))


def stack(*patches: tuple) -> tuple[Mesh, np.ndarray]:
    offset = np.cumsum([0, *(len(v) for v, _ in patches)])
    mesh = Mesh(
        np.concatenate([v for v, _ in patches]),
        np.concatenate([t + o for (_, t), o in zip(patches, offset[:-1], strict=True)]),
    )
    return mesh, np.repeat(np.arange(len(patches)), [len(t) for _, t in patches])


@pytest.mark.parametrize("cells", [1, 7, 60])
def test_square_fills_its_area_at_any_fineness(cells: int) -> None:
    mesh, _ = stack(plate(0.0, 1.0, cells))
    seen = visible_triangles(mesh, DOWN, 200, 200)
    assert (seen >= 0).sum() == pytest.approx((0.94 * 200) ** 2, rel=0.015)


def test_pixels_of_a_triangle_follow_its_area() -> None:
    # Four squares in one row, of widths 1 to 4: pixels as 1 : 2 : 3 : 4.
    edges = [0, 1, 3, 6, 10]
    mesh, part = stack(
        *(sheet([[a, 0, 0], [b, 0, 0], [b, 4, 0], [a, 4, 0]]) for a, b in pairwise(edges))
    )
    seen = visible_triangles(mesh, DOWN, 400, 200)
    count = np.bincount(part[seen[seen >= 0]])
    assert count / count.sum() == pytest.approx([0.1, 0.2, 0.3, 0.4], abs=0.005)


@given(st.permutations([0, 1, 2]), st.booleans())
def test_nearest_hides_the_rest_whatever_the_order(order: list[int], from_below: bool) -> None:
    heights = [0.0, 1.0, 2.0]
    mesh, part = stack(*(plate(heights[i], 1.0, 3) for i in order))
    view = camera(np.array([0.0, 0.0, 1.0 if from_below else -1.0]))
    seen = visible_triangles(mesh, view, 40, 40)
    shown = {heights[order[i]] for i in np.unique(part[seen[seen >= 0]])}
    assert shown == {0.0 if from_below else 2.0}


def test_hidden_area_shows_where_nothing_covers_it() -> None:
    mesh, part = stack(plate(0.0, 1.0), plate(1.0, 0.5))
    seen = visible_triangles(mesh, DOWN, 200, 200)
    count = np.bincount(part[seen[seen >= 0]])
    assert count[1] / count.sum() == pytest.approx(0.25, abs=0.01)


def test_chunks_do_not_change_the_picture(monkeypatch: pytest.MonkeyPatch) -> None:
    mesh, _ = stack(plate(0.0, 1.0, 9), plate(0.7, 0.4, 5), plate(0.3, 0.9, 2))
    view = camera(np.array([1.0, 0.4, -0.8]))
    whole = visible_triangles(mesh, view, 120, 90)
    monkeypatch.setattr("gpswb.report.raster.CHUNK", 50)
    assert np.array_equal(visible_triangles(mesh, view, 120, 90), whole)


@given(st.lists(st.floats(-1, 1), min_size=3, max_size=3).filter(lambda v: np.hypot(*v[:2]) > 0.1))
def test_camera_is_a_rotation_that_looks_its_way(toward: list[float]) -> None:
    view = camera(np.array(toward))
    assert view @ view.T == pytest.approx(np.eye(3), abs=1e-12)
    assert np.linalg.det(view) == pytest.approx(1.0)
    assert view @ np.array(toward) == pytest.approx([0, 0, -np.linalg.norm(toward)], abs=1e-12)
    assert view[1, 2] >= 0  # z is up


def test_empty_mesh_is_background() -> None:
    mesh = Mesh(np.zeros((0, 3)), np.zeros((0, 3), dtype=int))
    assert (visible_triangles(mesh, DOWN, 8, 6) == -1).all()


def test_close_up_is_cut_to_its_ball() -> None:
    # A wide floor, a small plate on it, a lid far above: the lid would hide all but the close-up.
    mesh, part = stack(plate(0.0, 50.0), plate(0.5, 1.0), plate(30.0, 50.0))
    focus = Focus(np.array([0.0, 0.0, 0.5]), 2.0)
    seen = visible_triangles(mesh, DOWN, 100, 100, focus)
    count = np.bincount(part[seen[seen >= 0]], minlength=3)
    assert count.sum() == 100 * 100  # the floor fills the picture
    assert count[1] == pytest.approx((0.94 * 50) ** 2, rel=0.05)
    assert count[2] == 0
