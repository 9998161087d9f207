# SPDX-License-Identifier: LGPL-2.1-or-later
"""Crashes, hangs and bugs in a child process end as one line in the parent."""

import faulthandler
import os
import signal
import time

import numpy as np
import pytest

from gpswb.cli.guard import ChildError, guarded
from gpswb.errors import InputError, KernelError, OutputError


def crash(number: signal.Signals) -> None:
    faulthandler.disable()  # pytest's own would print a page
    os.kill(os.getpid(), number)


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
    child = guarded(os.getpid, "x")
    with pytest.raises(ChildProcessError):
        os.waitpid(child, os.WNOHANG)


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
