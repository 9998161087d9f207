# SPDX-License-Identifier: LGPL-2.1-or-later
"""One part in a process of its own, with a limit on time and memory.

A kernel may crash or hang on a file; then that part's end says so and the others go on. The
processes are forked from a server that has the kernel loaded already: loading it takes seconds.
"""

from __future__ import annotations

import json
import multiprocessing
import os
import signal
import threading
import time
from multiprocessing.connection import wait
from multiprocessing.context import ForkServerContext
from multiprocessing.process import BaseProcess
from pathlib import Path
from typing import Any

from gpswb.batch.child import ANSWER, examine_in_child
from gpswb.batch.job import End, Job, Limits
from gpswb.batch.settings import Settings

GRACE = 2.0
"""Seconds that a child has to end by itself before it is killed."""

_fork = threading.Lock()
"""Held while a child is started or reaped: multiprocessing's books are not for several threads."""


def fork_server(kernel: str) -> ForkServerContext:
    """What children are started by. The first call decides which kernel is loaded beforehand."""
    # Before the server starts: its children must not each start a thread a core.
    os.environ.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", MKL_NUM_THREADS="1")
    context = multiprocessing.get_context("forkserver")
    module = {"ocp": "gpswb.cad.ocp_read", "freecad": "gpswb.cad.freecad_read"}[kernel]
    context.set_forkserver_preload(["gpswb.batch.one_part", "gpswb.io.result_json", module])
    return context


def examine_isolated(
    path: Path, job: Job, settings: Settings, limits: Limits, stop: threading.Event
) -> End:
    """Examine one part; its results are in ``job.directory`` when the end is ``done``.

    May be called from several threads at once.

    Args:
        path: the part.
        job: its name, as messages say it, and its directory, which is there.
        settings: how to examine it.
        limits: its time and memory.
        stop: ends the child, and the call with it, once it is set.
    """
    start = time.perf_counter()
    with _fork:
        child: BaseProcess = fork_server(settings.kernel).Process(
            target=examine_in_child, args=(path, job, settings, limits)
        )
        child.start()
    try:
        while not stop.is_set() and time.perf_counter() - start < limits.seconds:
            if wait([child.sentinel], timeout=0.2):
                break
        return end_of(child, job, limits, time.perf_counter() - start)
    finally:
        end_child(child)


def end_child(child: BaseProcess) -> None:
    """End a child: politely first, so that it ends the processes that it has started itself."""
    with _fork:
        if child.is_alive():
            child.terminate()
    wait([child.sentinel], timeout=GRACE)
    with _fork:
        if child.is_alive():
            child.kill()
        child.join()


def end_of(child: BaseProcess, job: Job, limits: Limits, elapsed: float) -> End:
    """How a child that has ended, or has run out of time, ended."""
    with _fork:
        alive, code = child.is_alive(), child.exitcode
    if alive:
        return End("timeout", f"not done after {limits.seconds:g} s", elapsed)
    answer = job.directory / ANSWER
    try:
        said: dict[str, Any] = json.loads(answer.read_text(encoding="utf-8"))
        answer.unlink()
    except (OSError, ValueError):
        return End("crashed", _death(code), elapsed)
    return End(seconds=elapsed, **said)


def _death(code: int | None) -> str:
    if code is not None and code < 0:
        return f"the process was ended by {signal.Signals(-code).name}"
    return f"the process ended with code {code} and without a result"
