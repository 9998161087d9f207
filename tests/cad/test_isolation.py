# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job that crashes, hangs or eats memory is an error of one line, not the end of the caller."""

from __future__ import annotations

import os
import subprocess
import sys
import time

import pytest

from gpswb.cad.isolate import IsolatedJob, run_isolated
from gpswb.errors import InputError, KernelError


def test_results_come_back() -> None:
    assert run_isolated("math:hypot", [3, 4], 60) == 5
    assert run_isolated("operator:add", [[1, None], ["é"]], 60) == [1, None, "é"]


def test_a_crash_is_named() -> None:
    with pytest.raises(KernelError, match="SIGABRT"):
        run_isolated("os:abort", [], 60)


def test_a_segfault_is_named() -> None:
    with pytest.raises(KernelError, match="SIGSEGV"):
        run_isolated("signal:raise_signal", [11], 60)


def test_a_hang_ends() -> None:
    with pytest.raises(KernelError, match="no result within 1 s"):
        run_isolated("time:sleep", [600], 1)


def test_memory_is_bounded() -> None:
    with pytest.raises(KernelError, match="needs more than 2000 MB of memory"):
        run_isolated("builtins:bytearray", [8_000_000_000], 60, memory_mb=2000)


def test_an_early_exit_is_no_result() -> None:
    with pytest.raises(KernelError, match="isolated process failed"):
        run_isolated("os:_exit", [0], 60)


def test_our_errors_keep_their_class_and_text() -> None:
    with pytest.raises(InputError, match=r"none\.step: no such file"):
        run_isolated("sniffing:sniff_text", ["none.step"], 60)


def test_other_errors_become_one_line() -> None:
    with pytest.raises(KernelError, match=r"^ZeroDivisionError: ") as caught:
        run_isolated("operator:truediv", [1, 0], 60)
    assert "\n" not in str(caught.value)


def test_a_job_tells_its_progress_and_is_cancelled(tmp_path) -> None:
    job = IsolatedJob("sniffing:tell_and_sleep", [str(tmp_path / "alive")])
    while job.progress is None and job.running:
        time.sleep(0.02)
    assert job.progress == ("sleep", 0.5)
    # The job has started a job of its own: cancelling ends that one as well.
    while not (tmp_path / "alive").exists():
        time.sleep(0.02)
    job.close()
    assert not job.running
    (tmp_path / "alive").unlink()
    time.sleep(0.5)
    assert not (tmp_path / "alive").exists()


def test_a_job_dies_with_its_caller(tmp_path) -> None:
    alive = tmp_path / "alive"
    call = (
        "import os, pathlib, time\n"
        "from gpswb.cad.isolate import IsolatedJob\n"
        f"job = IsolatedJob('sniffing:tell_and_sleep', [{str(alive)!r}])\n"
        f"while not pathlib.Path({str(alive)!r}).exists():\n"
        "    time.sleep(0.02)\n"
        "os._exit(1)\n"
    )
    path = os.pathsep.join(p for p in sys.path if p)
    subprocess.run(
        [sys.executable, "-c", call], env={**os.environ, "PYTHONPATH": path}, check=False
    )
    end = time.monotonic() + 30
    while alive.exists():
        assert time.monotonic() < end
        alive.unlink(missing_ok=True)
        time.sleep(1.0)
