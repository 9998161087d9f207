# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gpswb.core.shape_types import PLANE, SHARP_EDGE
from gpswb.core.voting import shape_type_differences, vote


def difference(i: int, j: int) -> float:
    return float(shape_type_differences()[i + 4, j + 4])


def test_differences_of_equation_9() -> None:
    assert difference(-4, 4) == 1.0
    assert difference(2, 3) == difference(3, 2) == pytest.approx(1 / 8)
    assert difference(PLANE, PLANE) == 0.0
    assert all(difference(PLANE, t) == pytest.approx(1 / 9) for t in range(-4, 5))
    # A planar neighbour is ignored: its possibility vanishes.
    assert all(difference(t, PLANE) == 1.0 for t in range(-4, 5))


def test_the_stray_vertex_takes_its_neighbours_type() -> None:
    # A wheel: the hub is 0 (saddle) amid six ridges.
    rim = np.arange(1, 7)
    pairs = np.concatenate(
        [np.column_stack([np.zeros(6, int), rim]), np.column_stack([rim, np.roll(rim, 1)])]
    )
    types, sweeps = vote(np.array([0, 2, 2, 2, 2, 2, 2]), pairs)
    assert types.tolist() == [2] * 7
    assert sweeps <= 3


def test_synchronous_voting_oscillates_where_a_sweep_in_place_settles() -> None:
    # Two neighbours of different type swap for ever: each sees only the other.
    pairs = np.array([[0, 1]])
    start = np.array([2, 3])
    one, _ = vote(start, pairs, in_place=False, max_sweeps=1)
    two, used = vote(start, pairs, in_place=False, max_sweeps=2)
    assert one.tolist() == [3, 2]
    assert two.tolist() == [2, 3]
    assert used == 2
    _, used = vote(start, pairs, in_place=False, max_sweeps=20)
    assert used == 20
    settled, used = vote(start, pairs, in_place=True, max_sweeps=20)
    assert len(set(settled.tolist())) == 1
    assert used < 5


def test_ties_keep() -> None:
    # The middle of 2 - 2 - 3: own type and the other have a neighbour each; 1 beats 1 - 1/8.
    pairs = np.array([[0, 1], [1, 2]])
    fixed = np.array([True, False, True])
    types, _ = vote(np.array([2, 2, 3]), pairs, fixed=fixed)
    assert types[1] == 2
    # 1 - 2 - 3 with the middle 2: both sides score (1/2)(7/8), its own type 0: the first wins.
    types, _ = vote(np.array([1, 2, 3]), pairs, fixed=fixed)
    assert types[1] == 1


def test_planes_ask_for_eight_ninths() -> None:
    # A planar vertex among n - k planes and k ridges turns only if 8/9 k > n - k.
    for ridges, expected in ((4, PLANE), (5, 2)):
        n = 9
        ring = np.arange(1, n + 1)
        pairs = np.column_stack([np.zeros(n, int), ring])
        types = np.array([PLANE] + [2] * ridges + [PLANE] * (n - ridges))
        fixed = np.ones(n + 1, dtype=bool)
        fixed[0] = False
        assert vote(types, pairs, fixed=fixed)[0][0] == (
            expected if 8 * ridges > 9 * (n - ridges) else PLANE
        )


def test_sharp_edges_neither_vote_nor_change() -> None:
    pairs = np.array([[0, 1], [0, 2], [0, 3]])
    types, _ = vote(np.array([2, SHARP_EDGE, SHARP_EDGE, 2]), pairs)
    assert types.tolist() == [2, SHARP_EDGE, SHARP_EDGE, 2]


@given(st.integers(0, 1000))
def test_a_uniform_mesh_is_left_alone_and_the_result_is_a_fixed_point(seed: int) -> None:
    rng = np.random.default_rng(seed)
    pairs = rng.integers(0, 40, (80, 2))
    pairs = pairs[pairs[:, 0] != pairs[:, 1]]
    same = np.full(40, int(rng.integers(-4, 6)))
    assert np.array_equal(vote(same, pairs)[0], same)
    types, sweeps = vote(rng.integers(-4, 6, 40), pairs, max_sweeps=100)
    if sweeps < 100:
        assert np.array_equal(vote(types, pairs)[0], types)
