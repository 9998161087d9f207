# SPDX-License-Identifier: LGPL-2.1-or-later
"""What runs on a Dask worker: a part is handed to a server process beside it, and its files back.

The server forks a process a part. The worker can't do that itself: under its nanny it is a daemon,
and daemons may not have children; and it has threads, so a fork of it would be unsafe.
"""

from __future__ import annotations

import json
import os
import queue
import shutil
import subprocess
import sys
import tempfile
import threading
from dataclasses import asdict
from pathlib import Path
from typing import Any

import gpswb
from gpswb.batch.cache import Cache
from gpswb.batch.job import RESULTS, Job, Limits
from gpswb.batch.one_job import do_job
from gpswb.batch.settings import Settings
from gpswb.errors import InputError, KernelError

_idle: queue.SimpleQueue[_Server] = queue.SimpleQueue()
"""Servers of this worker that wait for a job: as many as it has threads, in the end."""


def order(job: Job, settings: Settings, limits: Limits, cached: bool) -> dict[str, Any]:
    """A job as plain values, for another machine; ``cached`` if that one's cache may be used."""
    return {
        "gpswb": gpswb.__version__,
        "url": job.url,
        "name": job.name,
        "settings": settings.plain(),
        "limits": asdict(limits),
        "cached": cached,
    }


def examine_order(order: dict[str, Any]) -> dict[str, Any]:
    """On the worker: examine one part.

    Returns:
        ``end``, the fields of its `End`, and ``files``, the bytes of its results by name.

    Raises:
        InputError: this worker has another version of gpswb than the run.
        KernelError: the server died.
    """
    if order["gpswb"] != gpswb.__version__:
        raise InputError(f"a worker has gpswb {gpswb.__version__}, this run {order['gpswb']}")
    try:
        server = _idle.get_nowait()
    except queue.Empty:
        server = _Server()
    answer = server.ask(order)
    _idle.put(server)
    return answer


class _Server:
    """A process that examines one part after another; it ends when its worker does."""

    def __init__(self) -> None:
        self._process = subprocess.Popen(
            [sys.executable, "-m", "gpswb.batch.worker"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env={**os.environ, "PYTHONPATH": os.pathsep.join(p for p in sys.path if p)},
            start_new_session=True,  # Ctrl-C is the worker's affair
            text=True,
        )

    def ask(self, order: dict[str, Any]) -> dict[str, Any]:
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        try:
            self._process.stdin.write(json.dumps(order) + "\n")
            self._process.stdin.flush()
            said = self._process.stdout.readline()
        except OSError:
            said = ""
        if not said:
            raise KernelError("the process that examines the parts of a worker has died")
        answer = json.loads(said)
        directory = Path(answer["directory"])
        files = {name: directory / name for name in RESULTS if (directory / name).exists()}
        read = {name: path.read_bytes() for name, path in files.items()}
        shutil.rmtree(directory, ignore_errors=True)
        return {"end": answer["end"], "files": read}


def _serve() -> None:
    """Examine the orders on stdin, a line each, until it is closed."""
    stop = threading.Event()
    orders: queue.SimpleQueue[str] = queue.SimpleQueue()

    def listen() -> None:
        for line in sys.stdin:
            orders.put(line)
        stop.set()  # the worker has gone, or was killed: the part it waits for ends, too
        orders.put("")

    threading.Thread(target=listen, daemon=True).start()
    with tempfile.TemporaryDirectory(prefix="gpswb-worker-") as scratch:
        while line := orders.get():
            order = json.loads(line)
            job = Job(order["url"], order["name"], Path(scratch) / "part")
            settings, limits = Settings.from_plain(order["settings"]), Limits(**order["limits"])
            cache = Cache.of_user() if order["cached"] else None
            end = do_job(job, settings, limits, cache, stop)
            if stop.is_set():
                return
            answer = {"end": asdict(end), "directory": str(job.directory)}
            sys.stdout.write(json.dumps(answer) + "\n")
            sys.stdout.flush()


if __name__ == "__main__":
    _serve()
