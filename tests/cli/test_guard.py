# SPDX-License-Identifier: LGPL-2.1-or-later
"""Crashes, hangs and bugs in a child process end as one line in the parent."""

import faulthandler
import multiprocessing
import os
import signal
import time
from pathlib import Path

import numpy as np
import pytest

from gpswb.batch.isolated import Job, Limits, _row, run_jobs
from gpswb.batch.settings import Settings
from gpswb.cad.density import Density
from gpswb.cli.guard import ChildError, guarded
from gpswb.errors import InputError, KernelError, OutputError

SETTINGS = Settings(Density("stl"), "robust", "hybrid", "ocp")


def crash(number: signal.Signals) -> None:
    faulthandler.disable()  # pytest's own would print a page
    os.kill(os.getpid(), number)


def hang(deaf: bool) -> None:
    if deaf:
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
    time.sleep(60)


def raising(error: BaseException) -> object:
    raise error


def test_value_comes_back() -> None:
    assert guarded(lambda: {"a": [1, "ä"]}, "x") == {"a": [1, "ä"]}


@pytest.mark.parametrize("number", [signal.SIGSEGV, signal.SIGABRT, signal.SIGKILL])
def test_crash_is_a_kernel_error(number: signal.Signals) -> None:
    with pytest.raises(KernelError, match=f"part.step: .*{number.name}"):
        guarded(lambda: crash(number), "part.step")


def test_errors_of_the_user_keep_their_kind() -> None:
    with pytest.raises(InputError, match=r"^bad file$"):
        guarded(lambda: raising(InputError("bad file")), "x")
    with pytest.raises(OutputError, match="No space left"):
        guarded(lambda: raising(OSError(28, "No space left on device")), "x")
    with pytest.raises(KeyboardInterrupt):
        guarded(lambda: raising(KeyboardInterrupt()), "x")


def test_bug_says_where_it_is() -> None:
    with pytest.raises(ChildError, match=r"internal error at .*\.py:\d+: IndexError"):
        guarded(lambda: np.zeros(3)[7], "x")


def test_no_child_is_left_behind() -> None:
    guarded(lambda: 1, "x")
    with pytest.raises(ChildProcessError):
        os.waitpid(-1, os.WNOHANG)


def test_interrupt_ends_the_child(monkeypatch: pytest.MonkeyPatch) -> None:
    children: list[int] = []
    fork = os.fork
    monkeypatch.setattr(os, "fork", lambda: children.append(fork()) or children[-1])
    alarm = signal.signal(signal.SIGALRM, signal.default_int_handler)
    signal.setitimer(signal.ITIMER_REAL, 0.3)
    with pytest.raises(KeyboardInterrupt):
        guarded(lambda: time.sleep(60), "x")
    signal.signal(signal.SIGALRM, alarm)
    with pytest.raises(ProcessLookupError):
        os.kill(children[0], 0)


def job(tmp_path: Path, name: str = "part.step") -> Job:
    path = tmp_path / name
    path.write_bytes(b"nothing")
    return Job(path, name, tmp_path / "out" / name)


def test_crashed_child_gives_a_row(tmp_path: Path) -> None:
    context = multiprocessing.get_context("fork")
    process = context.Process(target=crash, args=(signal.SIGABRT,))
    process.start()
    process.join()
    row = _row(job(tmp_path), process, 1.0, Limits(9, 10**9))
    assert (row.status, row.message) == ("crashed", "the process was ended by SIGABRT")


@pytest.mark.parametrize("deaf", [False, True])
def test_child_out_of_time_is_ended(tmp_path: Path, deaf: bool) -> None:
    process = multiprocessing.get_context("fork").Process(target=hang, args=(deaf,))
    process.start()
    row = _row(job(tmp_path), process, 2.5, Limits(2, 10**9))
    assert (row.status, row.message) == ("timeout", "not done after 2 s")
    assert not process.is_alive()


def test_each_file_gets_its_row(tmp_path: Path) -> None:
    jobs = [job(tmp_path, name) for name in ("a.step", "b.brep", "c.txt")]
    limits = Limits(120, 6 * 10**9)
    rows = {j.name: row for j, row in run_jobs(jobs, SETTINGS, limits, 2)}
    assert set(rows) == {"a.step", "b.brep", "c.txt"}
    assert {row.status for row in rows.values()} == {"refused"}
    # The row names the file; its message doesn't again.
    assert not any(str(tmp_path) in row.message for row in rows.values())
