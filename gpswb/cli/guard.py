# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work in a child process: a kernel that crashes on a broken file must not end the command."""

from __future__ import annotations

import json
import os
import signal
import sys
import time
import warnings
from collections.abc import Callable
from typing import Any

import gpswb.errors
from gpswb.batch.messages import internal_error
from gpswb.errors import GpswbError, KernelError

GRACE = 2.0
"""Seconds that a child has to end by itself before it is killed."""


class ChildError(Exception):
    """An error that is no user's: its text says what it was and where."""


def guarded(work: Callable[[], Any], what: str) -> Any:
    """Do ``work`` in a fork of this process and return what it returned.

    Fork before anything heavy is imported: no thread then holds a lock that the child needs.

    Args:
        work: returns what JSON can hold.
        what: the input's name, for the error.

    Raises:
        GpswbError: as raised by ``work``; ``KernelError`` if the child died.
        ChildError: any other exception of ``work``.
    """
    sys.stdout.flush()
    sys.stderr.flush()
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            os.close(reader)
            signal.signal(signal.SIGTERM, signal.default_int_handler)
            _hush()
            _answer(work, writer)
        finally:  # whatever happens, the child must not go on as a second parent
            os._exit(0)
    os.close(writer)
    try:
        with os.fdopen(reader, encoding="utf-8") as pipe:
            said = pipe.read()
        _, status = os.waitpid(child, 0)
    except BaseException:
        _stop(child)
        raise
    if os.WIFSIGNALED(status):
        name = signal.Signals(os.WTERMSIG(status)).name
        raise KernelError(f"{what}: processing it crashed ({name}); the file may be broken")
    if not said:
        raise KernelError(f"{what}: processing it ended without a result")
    answer = json.loads(said)
    if answer["kind"] == "value":
        return answer["value"]
    if answer["kind"] == "interrupted":
        raise KeyboardInterrupt
    error = getattr(gpswb.errors, answer["kind"], ChildError)
    raise error(answer["text"])


def _stop(child: int) -> None:
    """End the child: politely first, so that it ends the processes that it has started itself."""
    os.kill(child, signal.SIGTERM)
    deadline = time.monotonic() + GRACE
    while time.monotonic() < deadline:
        if os.waitpid(child, os.WNOHANG)[0]:
            return
        time.sleep(0.02)
    os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)


def _hush() -> None:
    """Keep native code's chatter and numpy's warnings off the terminal; the progress bar stays."""
    sys.stderr = os.fdopen(os.dup(2), "w", encoding="utf-8", errors="replace")
    null = os.open(os.devnull, os.O_WRONLY)
    os.dup2(null, 1)
    os.dup2(null, 2)
    warnings.simplefilter("ignore")


def _answer(work: Callable[[], Any], writer: int) -> None:
    """In the child: say how it went."""
    try:
        answer = {"kind": "value", "value": work()}
    except GpswbError as error:
        answer = {"kind": type(error).__name__, "text": str(error)}
    except KeyboardInterrupt:
        answer = {"kind": "interrupted"}
    except MemoryError:
        answer = {"kind": "GpswbError", "text": "out of memory; try a coarser --density"}
    except OSError as error:
        answer = {"kind": "OutputError", "text": f"can't write: {error.strerror or error}"}
    except Exception as error:  # noqa: BLE001 - the parent says it in one line
        answer = {"kind": "ChildError", "text": internal_error(error)}
    with os.fdopen(writer, "w", encoding="utf-8") as pipe:
        json.dump(answer, pipe)
    sys.stderr.flush()
