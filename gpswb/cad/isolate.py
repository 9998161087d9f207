# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run a job in a process of its own, so that a kernel's crash, hang or memory hunger is an error.

Native code (OCCT, gmsh) can segfault on broken input; no exception tells of it.
"""

from __future__ import annotations

import importlib
import json
import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

from gpswb.errors import GpswbError, InputError, KernelError, OutputError

_ERRORS: dict[str, type[GpswbError]] = {
    "InputError": InputError,
    "KernelError": KernelError,
    "OutputError": OutputError,
}


def run_isolated(
    function: str, args: list[Any], timeout_s: float, memory_mb: int | None = None
) -> Any:
    """Call ``function`` in a fresh Python process.

    Args:
        function: ``package.module:name`` of a function of ours.
        args: its positional arguments; they and the result travel as JSON.
        timeout_s: the process (and its children) is killed after this time.
        memory_mb: limit of its address space; None for none.

    Returns:
        What the function returned.

    Raises:
        GpswbError: the one that the function raised, of the same class.
        KernelError: it crashed, ran out of time or memory, or raised anything else.
    """
    with tempfile.TemporaryDirectory(prefix="gpswb-") as folder:
        answer = Path(folder) / "answer.json"
        job = {"function": function, "args": args, "memory_mb": memory_mb, "answer": str(answer)}
        process = subprocess.Popen(  # noqa: S603 - our own Python, our own module
            [_python(), "-m", "gpswb.cad.isolate"],
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            env={**os.environ, "PYTHONPATH": os.pathsep.join(p for p in sys.path if p)},
            start_new_session=True,
        )
        try:
            _, trouble = process.communicate(json.dumps(job).encode(), timeout=timeout_s)
        except subprocess.TimeoutExpired:
            raise KernelError(f"no result within {timeout_s:g} s") from None
        finally:
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGKILL)
                process.communicate()
        if process.returncode < 0:
            name = signal.Signals(-process.returncode).name
            raise KernelError(f"the CAD kernel crashed ({name})")
        if not answer.exists():
            last = trouble.decode(errors="replace").strip().splitlines()[-1:] or ["no message"]
            raise KernelError(f"the isolated process failed: {last[0][:200]}")
        outcome = json.loads(answer.read_text())
    if "error" in outcome:
        raise _ERRORS.get(outcome["error"], KernelError)(outcome["message"])
    return outcome["result"]


def _python() -> str:
    """The interpreter: inside FreeCAD's window sys.executable may be FreeCAD itself."""
    if Path(sys.executable or "").name.startswith("python"):
        return sys.executable
    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    return shutil.which(version) or shutil.which("python3") or sys.executable


def _serve() -> None:
    job = json.loads(sys.stdin.buffer.read())
    if job["memory_mb"] is not None:
        limit = int(job["memory_mb"]) * 2**20
        resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
    outcome: dict[str, Any]
    try:
        module, name = job["function"].split(":")
        outcome = {"result": getattr(importlib.import_module(module), name)(*job["args"])}
    except GpswbError as error:
        outcome = {"error": type(error).__name__, "message": str(error)}
    except MemoryError:
        outcome = {
            "error": "KernelError",
            "message": f"needs more than {job['memory_mb']} MB of memory",
        }
    except Exception as error:  # noqa: BLE001 - the caller gets it as a KernelError
        text = " ".join(str(error).split())[:200]
        outcome = {"error": "KernelError", "message": f"{type(error).__name__}: {text}"}
    Path(job["answer"]).write_text(json.dumps(outcome))


if __name__ == "__main__":
    _serve()
    # Kernels may crash while they are torn down: the answer is written, so leave at once.
    os._exit(0)
