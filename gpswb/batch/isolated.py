# SPDX-License-Identifier: LGPL-2.1-or-later
"""One file of a corpus in a process of its own, with a limit on time and memory.

A kernel may crash or hang on a file; then that file's row says so and the others go on. The
processes are forked from a server that has the kernel loaded already: loading it takes seconds.
"""

from __future__ import annotations

import json
import multiprocessing
import os
import resource
import signal
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from multiprocessing.connection import wait
from multiprocessing.process import BaseProcess
from pathlib import Path
from typing import Any

from gpswb.batch.messages import internal_error, one_line
from gpswb.batch.settings import Settings
from gpswb.errors import GpswbError, KernelError
from gpswb.validation.corpus import PartRow

ROW = "row.json"

GRACE = 2.0
"""Seconds that a child has to end by itself before it is killed."""


@dataclass(frozen=True)
class Limits:
    """Seconds of wall time and bytes of memory for one file."""

    seconds: float
    memory: int


@dataclass(frozen=True)
class Job:
    """A file and the directory that its results go in."""

    path: Path
    name: str
    directory: Path


def run_jobs(
    jobs: Sequence[Job], settings: Settings, limits: Limits, parallel: int
) -> Iterator[tuple[Job, PartRow]]:
    """Yield each job with its row as it ends; at most ``parallel`` run at once."""
    # Before the server starts: its children must not each start a thread a core.
    os.environ.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", MKL_NUM_THREADS="1")
    context = multiprocessing.get_context("forkserver")
    kernel = {"ocp": "gpswb.cad.ocp_read", "freecad": "gpswb.cad.freecad_read"}[settings.kernel]
    context.set_forkserver_preload(["gpswb.batch.one_part", "gpswb.io.result_json", kernel])
    waiting = list(jobs)[::-1]
    running: dict[Job, tuple[BaseProcess, float]] = {}
    try:
        while waiting or running:
            while waiting and len(running) < parallel:
                job = waiting.pop()
                job.directory.mkdir(parents=True)
                process: BaseProcess = context.Process(
                    target=_child, args=(job, settings, limits.memory)
                )
                process.start()
                running[job] = (process, time.perf_counter())
            for job, (child, start) in list(running.items()):
                elapsed = time.perf_counter() - start
                if child.is_alive() and elapsed < limits.seconds:
                    continue
                row = _row(job, child, elapsed, limits)
                del running[job]
                yield job, row
            wait([p.sentinel for p, _ in running.values()], timeout=0.2)
    finally:
        for child, _ in running.values():
            _stop(child)


def _stop(process: BaseProcess) -> None:
    """End a child: politely first, so that it ends the processes that it has started itself."""
    process.terminate()
    process.join(GRACE)
    if process.is_alive():
        process.kill()
        process.join()


def _row(job: Job, process: BaseProcess, elapsed: float, limits: Limits) -> PartRow:
    """How a job that has ended, or has run out of time, ended."""
    if process.is_alive():
        _stop(process)
        return PartRow(job.name, "timeout", f"not done after {limits.seconds:g} s", {}, elapsed)
    process.join()
    answer = job.directory / ROW
    try:
        said: dict[str, Any] = json.loads(answer.read_text(encoding="utf-8"))
        answer.unlink()
    except (OSError, ValueError):
        return PartRow(job.name, "crashed", _death(process.exitcode), {}, elapsed)
    result = job.directory / "result.json"
    document = json.loads(result.read_text("utf-8")) if said["status"] == "done" else {}
    return PartRow(job.name, said["status"], said["message"], document, elapsed)


def _death(code: int | None) -> str:
    if code is not None and code < 0:
        return f"the process was ended by {signal.Signals(-code).name}"
    return f"the process ended with code {code} and without a result"


def _child(job: Job, settings: Settings, memory: int) -> None:
    """In the child: examine, write, say how it went."""
    # Native code prints what it likes; only the parent speaks to the user.
    null = os.open(os.devnull, os.O_WRONLY)
    os.dup2(null, 1)
    os.dup2(null, 2)
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    resource.setrlimit(resource.RLIMIT_DATA, (memory, memory))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    said = _attempt(lambda: _examine(job, settings))
    # The row names the file already.
    said["message"] = said["message"].removeprefix(f"{job.path}: ").replace(str(job.path), job.name)
    draft = job.directory / (ROW + ".draft")
    draft.write_text(json.dumps(said), encoding="utf-8")
    draft.rename(job.directory / ROW)


def _attempt(work: Callable[[], None]) -> dict[str, str]:
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


def _examine(job: Job, settings: Settings) -> None:
    from gpswb.batch.one_part import examine
    from gpswb.io.labels_npz import write_labels
    from gpswb.io.result_json import result_document, write_result

    outcome = examine(job.path, settings)
    facemap = outcome.solid.facemap
    write_labels(job.directory / "labels.npz", outcome.partition, facemap)
    document = result_document(outcome.solid, outcome.partition, outcome.validation)
    write_result(job.directory / "result.json", document)
