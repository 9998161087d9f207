# SPDX-License-Identifier: LGPL-2.1-or-later
"""``./gps bench`` sees a stage that has become slower, at once or bit by bit."""

import pytest
from benchmark_modules import benchmark_module


@pytest.fixture(scope="module")
def ratios():
    return benchmark_module("ratios")


def test_one_and_a_half_times_is_slower(ratios):
    old = {"a": 1.0, "b": 2.0, "gone": 1.0}
    assert ratios.slower(old, {"a": 1.49, "b": 2.0, "new": 9.0}) == []
    assert ratios.slower(old, {"a": 1.5, "b": 1.0}) == ["a: 1.5, was 1"]


def test_small_losses_add_up_to_a_report(ratios):
    committed = {"a": 1.0}
    reports = []
    for step in range(1, 6):
        new = {"a": 1.2**step}
        reports += ratios.slower(committed, new)
        committed = ratios.renewed(committed, new)
    assert committed == {"a": 1.0}
    assert reports[0] == "a: 1.73, was 1"


def test_gains_and_new_stages_are_kept(ratios):
    assert ratios.renewed({"a": 1.0, "gone": 1.0}, {"a": 0.51234, "new": 3.0}) == {
        "a": 0.512,
        "new": 3.0,
    }
