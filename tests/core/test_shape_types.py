# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest
from analytic_meshes import sphere

from gpswb.core.discrete_curvature import discrete_curvatures
from gpswb.core.growing import grow_regions
from gpswb.core.normals import wedge_normals
from gpswb.core.shape_types import (
    PLANE,
    plane_by_curvedness,
    plane_by_sagitta,
    shape_types,
)
from gpswb.core.wedges import find_wedges

# Table 5 as printed: lower bound of each interval, closed below; the last is closed above too.
TABLE_5 = [
    (-4, -1.0), (-3, -7 / 8), (-2, -5 / 8), (-1, -3 / 8), (0, -1 / 8),
    (1, 1 / 8), (2, 3 / 8), (3, 5 / 8), (4, 7 / 8),
]  # fmt: skip


@pytest.mark.parametrize(("shape", "low"), TABLE_5)
def test_intervals_of_table_5(shape: int, low: float) -> None:
    high = dict(TABLE_5).get(shape + 1, 1.0)
    inside = np.array([low, 0.5 * (low + high), high - 1e-9])
    assert (shape_types(inside, np.zeros(3, dtype=bool)) == shape).all()


def test_ends_of_the_scale_and_the_plane() -> None:
    ends = shape_types(np.array([-1.0, 1.0, 0.3]), np.array([False, False, True]))
    assert ends.tolist() == [-4, 4, PLANE]


def test_the_printed_plane_limit_carries_a_unit_and_the_sagitta_does_not() -> None:
    # A cylinder of 50 m with edges of 1 m, in mm and in m: the same surface.
    curved_mm, length_mm = np.array([1.0 / 50_000.0]), np.array([1000.0])
    curved_m, length_m = 1000.0 * curved_mm, length_mm / 1000.0
    assert plane_by_curvedness(curved_mm / 3.0, 1e-5).all()
    assert not plane_by_curvedness(curved_m / 3.0, 1e-5).any()
    for tolerance in (2.0, 3.0):
        in_mm = plane_by_sagitta(curved_mm, length_mm, tolerance)
        in_m = plane_by_sagitta(curved_m, length_m, tolerance / 1000.0)
        assert in_mm == in_m == (tolerance > 1000.0**2 / 50_000.0 / 8.0)


def test_regions_are_components_of_equal_type() -> None:
    # 0-1-2-3-4 in a row, and 5 apart; 2 has another type.
    pairs = np.array([[0, 1], [1, 2], [2, 3], [3, 4]])
    region, count = grow_regions(np.array([2, 2, 3, 2, 2, 2]), pairs)
    assert count == 4
    assert region.tolist() == [0, 0, 1, 2, 2, 3]


def test_regions_do_not_depend_on_the_order_of_pairs() -> None:
    rng = np.random.default_rng(2)
    labels = rng.integers(0, 2, 60)
    pairs = rng.integers(0, 60, (90, 2))
    region, count = grow_regions(labels, pairs)
    again, same = grow_regions(labels, rng.permutation(pairs)[:, ::-1])
    assert count == same
    assert np.array_equal(region, again)


def test_discretised_operators_find_a_sphere() -> None:
    # Cube corners have valence 3, where the operators converge slowest; the median is what counts.
    errors = []
    for level in (6, 12, 24):
        mesh = sphere(7.0, level)
        k_max, k_min = discrete_curvatures(mesh, wedge_normals(mesh, find_wedges(mesh)))
        errors.append(np.median(np.abs(0.5 * (k_max + k_min) - 1.0 / 7.0)) * 7.0)
    assert errors[2] < 2e-3
    assert errors[0] > 3.0 * errors[1] > 9.0 * errors[2]
