# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts on the workers of a Dask scheduler, on as many machines as there are.

Workers read the parts, this process writes the results: it alone writes the record, so a part that
two workers did, because one was thought dead, is in it once.
"""

from __future__ import annotations

import itertools
import logging
from collections.abc import Generator, Iterable
from typing import Any

from gpswb.batch.job import End, Job, Limits
from gpswb.batch.messages import one_line
from gpswb.batch.settings import Settings
from gpswb.batch.worker import examine_order, order
from gpswb.errors import InputError

AHEAD = 3
"""Parts a thread that the scheduler has at once: one in work, the others so that none waits for the
next. A million at once would fill its memory."""

PATIENCE = 60
"""Seconds to wait for the scheduler, and for a first worker."""


def run_on_cluster(
    jobs: Iterable[Job], settings: Settings, limits: Limits, cached: bool, address: str
) -> Generator[tuple[Job, End]]:
    """Yield each job with its end as it ends, its results in its directory.

    Args:
        jobs: the parts; every worker must see their paths or URLs.
        settings: how to examine each.
        limits: time and memory of each.
        cached: whether workers may use the caches of their machines.
        address: of the scheduler, ``tcp://host:port``.

    Raises:
        InputError: no scheduler or no worker answers, the scheduler dies, or a worker has another
            version of gpswb.
        OSError: results can't be written.
    """
    try:
        from distributed import CancelledError, Client, as_completed
        from distributed.client import ClosedClientError
    except ImportError:
        raise InputError("--scheduler needs the package distributed") from None
    for name in ("distributed", "distributed.client"):  # errors are raised, and told once
        logging.getLogger(name).setLevel(logging.CRITICAL)
    try:
        client: Any = Client(address, timeout=PATIENCE, set_as_default=False)
    except (OSError, ValueError) as error:
        raise InputError(f"no scheduler answers at {address}: {error}") from error
    with client:
        try:
            client.wait_for_workers(1, timeout=PATIENCE)
        except TimeoutError:
            raise InputError(f"the scheduler at {address} has no worker") from None
        waiting = iter(jobs)
        running: dict[str, Job] = {}
        ended: Any = as_completed(loop=client.loop)
        while True:
            try:
                room = AHEAD * sum(client.nthreads().values()) - len(running)
                for job in itertools.islice(waiting, max(room, 0 if running else 1)):
                    future = client.submit(
                        examine_order, order(job, settings, limits, cached), pure=False
                    )
                    running[future.key] = job
                    ended.add(future)
                if not running:
                    return
                future = next(ended)
                end, files = _answer(future)
            except (OSError, CancelledError, ClosedClientError) as error:
                raise InputError(f"the scheduler at {address} has gone") from error
            job = running.pop(future.key)
            job.directory.mkdir(parents=True)
            for name, content in files.items():
                (job.directory / name).write_bytes(content)
            yield job, end


def _answer(future: Any) -> tuple[End, dict[str, bytes]]:
    """What a future that has ended holds: how the part ended, and its files."""
    error = future.exception() if future.status == "error" else None
    if isinstance(error, InputError):
        raise error
    if error is not None:  # a worker's own trouble, or one that died again and again
        return End("crashed", one_line(f"on a worker: {type(error).__name__}: {error}"), 0.0), {}
    answer = future.result()
    return End(**answer["end"]), answer["files"]
