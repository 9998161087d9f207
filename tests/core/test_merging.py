# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest
from analytic_meshes import samples
from hypothesis import given
from hypothesis import strategies as st

from gpswb.core.merging import merge_regions
from gpswb.core.mesh import FloatArray, IntArray
from gpswb.core.quadric_moments import (
    cylinder_stand_off,
    plane_stand_off,
    quadric_moments,
    sphere_stand_off,
)
from gpswb.core.similarity import confidence, signature_similarity
from gpswb.core.slippage import slippage_moments
from gpswb.core.slippage_rule import MergeLimits, MergeState, SlippageRule


class Numbers:
    """Regions are numbers; alike where they differ by less than 1; a union is the mean."""

    def __init__(self, values: list[float]) -> None:
        self.values = np.array(values)
        self.joins: list[tuple[int, int]] = []

    def score(self, first: IntArray, second: IntArray) -> FloatArray:
        return np.maximum(0.0, 1.0 - np.abs(self.values[first] - self.values[second]))

    def join(self, kept: IntArray, gone: IntArray) -> None:
        self.joins += zip(kept.tolist(), gone.tolist(), strict=True)
        self.values[kept] = 0.5 * (self.values[kept] + self.values[gone])


def partition_of(label: IntArray) -> set[frozenset[int]]:
    return {frozenset(np.flatnonzero(label == k).tolist()) for k in np.unique(label)}


def test_the_most_similar_pair_merges_first_and_the_union_is_scored_anew() -> None:
    rule = Numbers([0.0, 0.3, 1.0, 5.0])
    label = merge_regions(4, np.array([[0, 1], [1, 2], [2, 3]]), rule, 0.2)
    assert set(rule.joins[0]) == {0, 1}
    # The union stands at 0.15, 0.85 from the third: below 0.2, so it stays apart.
    assert partition_of(label) == {frozenset({0, 1}), frozenset({2}), frozenset({3})}


def test_only_neighbours_merge() -> None:
    label = merge_regions(3, np.array([[0, 2]]), Numbers([1.0, 1.0, 1.0]), 0.5)
    assert partition_of(label) == {frozenset({0, 2}), frozenset({1})}


@given(st.integers(0, 10**6))
def test_equal_regions_end_as_connected_components(seed: int) -> None:
    rng = np.random.default_rng(seed)
    values = rng.integers(0, 3, 30).astype(float) * 10.0
    pairs = rng.integers(0, 30, (50, 2))
    label = merge_regions(30, pairs, Numbers(values.tolist()), 0.9)
    parent = list(range(30))

    def root(i: int) -> int:
        while parent[i] != i:
            i = parent[i]
        return i

    for a, b in pairs.tolist():
        if values[a] == values[b]:
            parent[root(a)] = root(b)
    expected = np.array([root(i) for i in range(30)])
    assert partition_of(label) == partition_of(expected)
    assert (label[label] == label).all()


@given(st.integers(0, 10**6), st.integers(1, 3))
def test_sigma_is_the_singular_value_of_the_combined_matrix(seed: int, k: int) -> None:
    rng = np.random.default_rng(seed)
    a, b = (np.linalg.qr(rng.normal(size=(6, k)))[0] for _ in range(2))
    b = np.linalg.qr(a + 0.2 * b)[0]
    sigma = np.linalg.svd(np.hstack([a, b]), compute_uv=False)[k]
    found = signature_similarity(a[None], b[None], k, 0.1)[0]
    assert found == pytest.approx(np.exp(-(sigma**2) / 0.02), abs=1e-9)


def test_confidence_of_equation_13() -> None:
    size, motions = np.array([10, 50, 200]), np.array([2, 2, 1])
    assert confidence(size, motions, 2, 50).tolist() == [0.2, 1.0, 0.0]


def state_of(*regions: tuple[FloatArray, FloatArray]) -> MergeState:
    p = np.concatenate([r[0] for r in regions])
    n = np.concatenate([r[1] for r in regions])
    label = np.repeat(np.arange(len(regions)), [len(r[0]) for r in regions])
    weights = np.ones(len(p))
    count = len(regions)
    s = slippage_moments(p, n, weights, label, count)
    return MergeState(
        s.motion,
        s.metric,
        quadric_moments(p, weights, label, count),
        np.full(count, 50),
        np.zeros((count, 2)),
    )


LIMITS = MergeLimits(
    slippable=2e-4,
    coarse=0.0,
    stand_off=1e-4,
    similarity=0.5,
    signature_width=0.1,
    confident_facets=12,
)


def merges(k: int, *regions: tuple[FloatArray, FloatArray]) -> bool:
    rule = SlippageRule(state_of(*regions), k, LIMITS)
    return bool(rule.score(np.array([0]), np.array([1]))[0] > 0.0)


def half(name: str, axis: int) -> list[tuple[FloatArray, FloatArray]]:
    p, n = samples(name, 1200)
    low = p[:, axis] < np.median(p[:, axis])
    return [(p[low], n[low]), (p[~low], n[~low])]


@pytest.mark.parametrize(
    ("name", "axis", "k"),
    [
        ("planar", 0, 3), ("spherical", 2, 3), ("cylindrical", 0, 2), ("cylindrical", 2, 2),
        ("revolute", 0, 1), ("revolute", 2, 1), ("prismatic", 0, 1), ("helical", 2, 1),
        ("complex", 0, 0),
    ],
)  # fmt: skip
def test_two_halves_of_a_surface_are_one(name: str, axis: int, k: int) -> None:
    # Two arcs of one cylinder agree exactly in a joint frame, whatever their own centres.
    assert merges(k, *half(name, axis))


def test_parallel_planes_with_a_step_are_two() -> None:
    p, n = samples("planar", 500)
    assert merges(3, (p, n), (p + np.array([40.0, 0.0, 0.0]), n))
    assert not merges(3, (p, n), (p + np.array([40.0, 0.0, 0.5]), n))


def test_coaxial_cylinders_and_concentric_spheres_are_two() -> None:
    p, n = samples("cylindrical", 500)
    assert merges(2, (p, n), (p + np.array([0.0, 0.0, 25.0]), n))
    assert not merges(2, (p, n), (1.2 * p + np.array([0.0, 0.0, 25.0]), n))
    p, n = samples("sphere", 800)
    upper = p[:, 2] > 0.0
    assert not merges(3, (p[upper], n[upper]), (1.1 * p[~upper], n[~upper]))


def test_no_region_loses_a_motion() -> None:
    # A wall and a rounding tangent to it share the one translation of their extrusion: the trap.
    p, n = samples("quarter cylinder", 600)
    wall = np.column_stack(
        [0 * p[:, 0] + 5.0, -10.0 * np.random.default_rng(0).random(600), p[:, 2]]
    )
    sideways = np.tile([1.0, 0.0, 0.0], (600, 1))
    for k in (3, 2, 1):
        assert not merges(k, (p, n), (wall, sideways))
    # A few facets may, beside something much larger: they only look more symmetric than they are.
    state = state_of((p, n), (wall[:20], sideways[:20]))
    state.facets[1] = 3
    rule = SlippageRule(state, 1, LIMITS)
    assert rule.score(np.array([0]), np.array([1]))[0] == 0.0  # the rounding would lose one still


def test_stand_off_of_planes_spheres_and_cylinders() -> None:
    def moments(p: FloatArray) -> FloatArray:
        return quadric_moments(p, np.ones(len(p)), np.zeros(len(p), dtype=np.int64), 1)

    p, n = samples("planar", 400)
    step = np.where(np.arange(400) % 2 == 0, 0.1, -0.1)[:, None] * n
    assert plane_stand_off(moments(p))[0] < 1e-6
    assert plane_stand_off(moments(p + step))[0] == pytest.approx(0.1, rel=0.02)
    p, n = samples("sphere", 4000)
    step = np.where(np.arange(4000) % 2 == 0, 0.1, -0.1)[:, None] * n
    assert sphere_stand_off(moments(p / 7.0))[0] < 1e-6
    assert sphere_stand_off(moments(p + step))[0] == pytest.approx(0.1, rel=0.02)
    p, n = samples("cylindrical", 4000)
    step = np.where(np.arange(4000) % 2 == 0, 0.1, -0.1)[:, None] * n
    axis = np.array([[3.0, -2.0, 1.0]]), np.array([[0.0, 0.0, 1.0]])
    assert cylinder_stand_off(moments((p + axis[0]) / 7.0), axis[0] / 7.0, axis[1])[0] < 1e-6
    assert cylinder_stand_off(moments(p + axis[0] + step), *axis)[0] == pytest.approx(0.1, rel=0.02)
