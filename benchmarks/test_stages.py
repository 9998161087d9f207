# SPDX-License-Identifier: LGPL-2.1-or-later
"""CPU seconds of each stage on the benchmark part; pytest-benchmark keeps them as JSON."""

import resource

import pytest
from stages import MODES, NEEDS, STAGES, Run, whole

SLOW = ("tessellation", "consensus")
"""Stages timed once: they take so long that a second round would tell nothing new."""


def cpu_seconds() -> float:
    """Of this process and of the children it has waited for: a busy machine changes little."""
    each = [resource.getrusage(w) for w in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(use.ru_utime + use.ru_stime for use in each)


@pytest.mark.benchmark(timer=cpu_seconds)
@pytest.mark.parametrize("stage", STAGES)
def test_stage(benchmark, run: Run, stage: str) -> None:
    for needed in NEEDS[stage]:
        run[needed]
    rounds = 1 if stage in SLOW else 3
    result = benchmark.pedantic(STAGES[stage], args=(run,), rounds=rounds)
    run.keep(stage, result)
    describe(benchmark, run, stage=stage)


@pytest.mark.benchmark(timer=cpu_seconds)
@pytest.mark.parametrize("mode", MODES)
def test_whole(benchmark, run: Run, mode: str) -> None:
    run["tessellation"]
    benchmark.pedantic(whole, args=(run, mode), rounds=1)
    describe(benchmark, run, mode=mode)


def describe(benchmark, run: Run, **what: str) -> None:
    solid = run["tessellation"]
    benchmark.extra_info.update(
        **what,
        asked=run.vertices,
        vertices=len(solid.mesh.vertices),
        triangles=len(solid.mesh.triangles),
        mesher=solid.mesher,
    )
