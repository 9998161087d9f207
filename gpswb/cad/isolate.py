# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run a job in a process of its own, so that a kernel's crash, hang or memory hunger is an error.

Native code (OCCT, gmsh) can segfault on broken input; no exception tells of it. `run_isolated`
waits for the answer; an `IsolatedJob` lets its caller go on, look at the progress, and cancel.
"""

from __future__ import annotations

import contextlib
import importlib
import json
import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from gpswb.errors import GpswbError, InputError, KernelError, OutputError
from gpswb.sentence import Sentence, packed, unpacked

_ERRORS: dict[str, type[GpswbError]] = {
    "InputError": InputError,
    "KernelError": KernelError,
    "OutputError": OutputError,
}
_FOLDER = "GPSWB_JOB_FOLDER"
"""Environment variable of a job's process: where it reads and writes. A job that starts a job keeps
it in its own process group, so that both end together."""
_LOOK_S = 1.0
"""Between two looks whether the caller is still alive."""


class IsolatedJob:
    """A function that runs in a fresh Python process.

    Args:
        function: ``package.module:name`` of a function of ours.
        args: its positional arguments; they and the result travel as JSON.
        memory_mb: limit of its address space; None for none.
    """

    def __init__(self, function: str, args: list[Any], memory_mb: int | None = None) -> None:
        # The caller's `close` or `result` removes the folder, else the finaliser.
        self._folder = tempfile.TemporaryDirectory(prefix="gpswb-")
        self._leader = _FOLDER not in os.environ
        folder = Path(self._folder.name)
        job = {"function": function, "args": args, "memory_mb": memory_mb}
        (folder / "job").write_text(json.dumps(job))
        with (folder / "trouble").open("wb") as trouble:
            self._process = subprocess.Popen(  # noqa: S603 - our own Python, our own module
                [_python(), "-m", "gpswb.cad.isolate"],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=trouble,
                env={
                    # BLAS's threads wait for one another by spinning, and our matrices are too
                    # small for it to pay. Two cores with a load of nine: 40 s with one thread,
                    # more than 250 s with two.
                    "OPENBLAS_NUM_THREADS": "1",
                    **os.environ,
                    "PYTHONPATH": os.pathsep.join(p for p in sys.path if p),
                    _FOLDER: str(folder),
                },
                start_new_session=self._leader,
            )

    @property
    def running(self) -> bool:
        """Whether the process is still at work."""
        return self._process.poll() is None

    @property
    def progress(self) -> tuple[str, float] | None:
        """Stage and share of it that the function last told; None before the first."""
        try:
            stage, share = json.loads(Path(self._folder.name, "progress").read_text())
        except (OSError, ValueError):  # not there yet
            return None
        return str(stage), float(share)

    def result(self, timeout_s: float | None = None) -> Any:
        """Wait for what the function returned.

        Raises:
            GpswbError: the one that the function raised, of the same class.
            KernelError: it crashed, ran out of time or memory, or raised anything else.
        """
        try:
            self._process.wait(timeout_s)
            return self._outcome()
        except subprocess.TimeoutExpired:
            raise KernelError(
                Sentence("no result within {seconds:g} s", seconds=timeout_s)
            ) from None
        finally:
            self.close()

    def close(self) -> None:
        """End the process and all that it started, and remove what it wrote."""
        if self._process.poll() is None:
            if self._leader:
                with contextlib.suppress(ProcessLookupError):
                    os.killpg(self._process.pid, signal.SIGKILL)
            else:
                self._process.kill()
            self._process.wait()
        self._folder.cleanup()

    def _outcome(self) -> Any:
        folder = Path(self._folder.name)
        if self._process.returncode < 0:
            name = signal.Signals(-self._process.returncode).name
            raise KernelError(Sentence("the CAD kernel crashed ({signal})", signal=name))
        try:
            outcome = json.loads((folder / "answer").read_text())
        except OSError:
            trouble = (folder / "trouble").read_text(errors="replace")
            last = trouble.strip().splitlines()[-1:] or ["no message"]
            raise KernelError(
                Sentence("the isolated process failed: {why}", why=last[0][:200])
            ) from None
        if "error" in outcome:
            raise _ERRORS.get(outcome["error"], KernelError)(unpacked(outcome["message"]))
        return outcome["result"]


def run_isolated(
    function: str, args: list[Any], timeout_s: float, memory_mb: int | None = None
) -> Any:
    """Call ``function`` in a fresh Python process and wait for it; see `IsolatedJob`.

    Args:
        timeout_s: the process (and its children) is killed after this time.

    Raises:
        GpswbError: as `IsolatedJob.result`.
    """
    return IsolatedJob(function, args, memory_mb).result(timeout_s)


def job_progress() -> Callable[[str, float], None]:
    """In a job: the callback that tells its caller the stage and the share of it that is done."""
    folder = Path(os.environ[_FOLDER])

    def tell(stage: str, share: float) -> None:
        draft = folder / "progress.draft"
        draft.write_text(json.dumps([stage, share]))
        draft.replace(folder / "progress")

    return tell


def _python() -> str:
    """The interpreter. Within FreeCAD sys.executable may be FreeCAD itself; its own Python then
    stands where its libraries do, and the first on PATH may be quite another."""
    if Path(sys.executable or "").name.startswith("python"):
        return sys.executable
    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    folders = [Path(sys.base_prefix, "bin"), Path(sys.base_prefix), Path(sys.executable).parent]
    for name in (version, "python3", "python", "python.exe"):
        for folder in folders:
            if (folder / name).is_file():
                return str(folder / name)
    return shutil.which(version) or shutil.which("python3") or sys.executable


def _die_with(caller: int) -> None:
    """End this process, and what it started, when its caller has died without ending it."""
    while os.getppid() == caller:
        time.sleep(_LOOK_S)
    if os.getpgrp() == os.getpid():
        os.killpg(0, signal.SIGKILL)
    os._exit(1)


def _serve() -> None:
    folder = Path(os.environ[_FOLDER])
    threading.Thread(target=_die_with, args=[os.getppid()], daemon=True).start()
    job = json.loads((folder / "job").read_text())
    if job["memory_mb"] is not None:
        limit = int(job["memory_mb"]) * 2**20
        resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
    outcome: dict[str, Any]
    try:
        module, name = job["function"].split(":")
        outcome = {"result": getattr(importlib.import_module(module), name)(*job["args"])}
    except GpswbError as error:
        outcome = {"error": type(error).__name__, "message": packed(str(error))}
    except MemoryError:
        outcome = {
            "error": "KernelError",
            "message": packed(
                Sentence("needs more than {limit} MB of memory", limit=job["memory_mb"])
            ),
        }
    except Exception as error:  # noqa: BLE001 - the caller gets it as a KernelError
        text = " ".join(str(error).split())[:200]
        outcome = {"error": "KernelError", "message": f"{type(error).__name__}: {text}"}
    (folder / "answer").write_text(json.dumps(outcome))


if __name__ == "__main__":
    _serve()
    # Kernels may crash while they are torn down: the answer is written, so leave at once.
    os._exit(0)
