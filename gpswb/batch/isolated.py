# SPDX-License-Identifier: LGPL-2.1-or-later
"""One part in a process of its own, with a limit on time and memory.

A kernel may crash or hang on a file; then that part's end says so and the others go on. The
processes are forked from a server that has the kernel loaded already: loading it takes seconds.
"""

from __future__ import annotations

import json
import math
import multiprocessing
import os
import resource
import signal
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from multiprocessing.connection import wait
from multiprocessing.context import ForkServerContext
from multiprocessing.process import BaseProcess
from pathlib import Path
from typing import Any

from gpswb.batch.messages import internal_error, one_line
from gpswb.batch.settings import Settings
from gpswb.batch.source import local_file, printable
from gpswb.errors import GpswbError, KernelError
from gpswb.validation.corpus import Status

RESULTS = ("result.json", "labels.npz")
"""What a part that is done leaves in its directory."""

ANSWER = "answer.json"

GRACE = 2.0
"""Seconds that a child has to end by itself before it is killed."""

_fork = threading.Lock()
"""Held while a child is started or reaped: multiprocessing's books are not for several threads."""


@dataclass(frozen=True)
class Limits:
    """Seconds of wall time and bytes of memory for one part."""

    seconds: float
    memory: int


@dataclass(frozen=True)
class Job:
    """A part, by path or URL, its name, and the directory that its results go in."""

    url: str
    name: str
    directory: Path


@dataclass(frozen=True)
class End:
    """How a part ended; anything but ``done`` comes with a one-line message.

    ``seconds`` is wall time, ``cpu_s`` user and system time, ``memory_mb`` the peak of the resident
    memory (MB of 10⁶ bytes); the last two are None where the child could not tell.
    """

    status: Status
    message: str
    seconds: float
    cpu_s: float | None = None
    memory_mb: float | None = None


def fork_server(kernel: str) -> ForkServerContext:
    """What children are started by. The first call decides which kernel is loaded beforehand."""
    # Before the server starts: its children must not each start a thread a core.
    os.environ.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", MKL_NUM_THREADS="1")
    context = multiprocessing.get_context("forkserver")
    module = {"ocp": "gpswb.cad.ocp_read", "freecad": "gpswb.cad.freecad_read"}[kernel]
    context.set_forkserver_preload(["gpswb.batch.one_part", "gpswb.io.result_json", module])
    return context


def examine_isolated(job: Job, settings: Settings, limits: Limits, stop: threading.Event) -> End:
    """Examine one part; its results are in ``job.directory`` when the end is ``done``.

    May be called from several threads at once.

    Args:
        job: the part; its directory is made.
        settings: how to examine it.
        limits: its time and memory; a part that isn't a local file is fetched outside the time.
        stop: ends the child, and the call with it, once it is set.

    Raises:
        OSError: the directory can't be written.
    """
    start = time.perf_counter()
    job.directory.mkdir(parents=True)
    try:
        with local_file(job.url, limits.memory) as path:
            return _examine_file(path, job, settings, limits, stop)
    except GpswbError as error:
        return End("refused", one_line(str(error)), time.perf_counter() - start)


def _examine_file(
    path: Path, job: Job, settings: Settings, limits: Limits, stop: threading.Event
) -> End:
    start = time.perf_counter()
    with _fork:
        child: BaseProcess = fork_server(settings.kernel).Process(
            target=_child, args=(path, job, settings, limits)
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


def _child(path: Path, job: Job, settings: Settings, limits: Limits) -> None:
    """In the child: examine, write, say how it went."""
    # Native code prints what it likes; only the parent speaks to the user.
    null = os.open(os.devnull, os.O_WRONLY)
    os.dup2(null, 1)
    os.dup2(null, 2)
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    resource.setrlimit(resource.RLIMIT_DATA, (limits.memory, limits.memory))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    # More than the wall time allows: it ends a hanging child whose parent was killed.
    cpu = math.ceil(limits.seconds) * (os.cpu_count() or 1)
    resource.setrlimit(resource.RLIMIT_CPU, (cpu, cpu))
    threading.Thread(target=_follow_parent, daemon=True).start()
    said = _attempt(lambda: _examine(path, job, settings))
    # The row names the part already.
    said["message"] = said["message"].removeprefix(f"{path}: ").replace(str(path), job.name)
    each = [resource.getrusage(w) for w in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    said["cpu_s"] = round(sum(use.ru_utime + use.ru_stime for use in each), 3)
    said["memory_mb"] = round(max(use.ru_maxrss for use in each) * 1024 / 1e6, 1)
    draft = job.directory / (ANSWER + ".draft")
    draft.write_text(json.dumps(said), encoding="utf-8")
    draft.rename(job.directory / ANSWER)


def _follow_parent() -> None:
    """End with the process that asked for this one, also where that was killed."""
    parent = multiprocessing.parent_process()
    assert parent is not None
    parent.join()
    os.kill(os.getpid(), signal.SIGTERM)


def _attempt(work: Callable[[], None]) -> dict[str, Any]:
    try:
        work()
    except KernelError as error:
        return {"status": "crashed", "message": one_line(str(error))}
    except GpswbError as error:
        return {"status": "refused", "message": one_line(str(error))}
    except MemoryError:
        return {"status": "memory", "message": "out of memory"}
    except Exception as error:  # noqa: BLE001 - one part's bug must not hide the other figures
        return {"status": "crashed", "message": internal_error(error)}
    return {"status": "done", "message": ""}


def _examine(path: Path, job: Job, settings: Settings) -> None:
    from gpswb.batch.one_part import examine
    from gpswb.io.labels_npz import write_labels
    from gpswb.io.result_json import result_document, write_result

    outcome = examine(path, settings)
    solid = replace(outcome.solid, source=printable(job.url))
    write_labels(job.directory / "labels.npz", outcome.partition, solid.facemap)
    document = result_document(solid, outcome.partition, outcome.validation)
    write_result(job.directory / "result.json", document)
