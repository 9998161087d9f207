# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts on this machine, some at once, each in a process of its own; no server is needed."""

from __future__ import annotations

import itertools
import threading
from collections.abc import Generator, Iterable
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait

from gpswb.batch.cache import Cache
from gpswb.batch.job import End, Job, Limits
from gpswb.batch.one_job import do_job
from gpswb.batch.settings import Settings


def run_local(
    jobs: Iterable[Job], settings: Settings, limits: Limits, cache: Cache | None, parallel: int
) -> Generator[tuple[Job, End]]:
    """Yield each job with its end as it ends; at most ``parallel`` run at once.

    Raises:
        OSError: a job's directory can't be written.
    """
    waiting = iter(jobs)
    running: dict[Future[End], Job] = {}
    stop = threading.Event()
    with ThreadPoolExecutor(parallel) as pool:  # a thread a child, which it watches
        try:
            while True:
                for job in itertools.islice(waiting, parallel - len(running)):
                    future = pool.submit(do_job, job, settings, limits, cache, stop)
                    running[future] = job
                if not running:
                    return
                for future in wait(running, return_when=FIRST_COMPLETED).done:
                    yield running.pop(future), future.result()
        finally:
            stop.set()
