# SPDX-License-Identifier: LGPL-2.1-or-later
"""One part among many, from wherever it lies: fetched, looked for in the cache, else examined."""

from __future__ import annotations

import json
import threading
import time
from collections.abc import Mapping
from dataclasses import asdict, replace
from pathlib import Path

from gpswb.batch.cache import Cache
from gpswb.batch.isolated import examine_isolated
from gpswb.batch.job import RESULTS, End, Job, Limits
from gpswb.batch.messages import one_line
from gpswb.batch.settings import Settings
from gpswb.batch.source import local_file, printable
from gpswb.errors import GpswbError
from gpswb.io.result_json import write_result

END = "end.json"
"""How the part ended, beside its results in the cache."""


def do_job(
    job: Job, settings: Settings, limits: Limits, cache: Cache | None, stop: threading.Event
) -> End:
    """Examine one part; its results are in ``job.directory`` when the end is ``done``.

    May be called from several threads at once.

    Args:
        job: the part; its directory is made.
        settings: how to examine it.
        limits: its time and memory; a part that isn't a local file is fetched outside the time.
        cache: where results are looked for first and kept; None for nowhere.
        stop: ends the child, and the call with it, once it is set.

    Raises:
        OSError: the directory can't be written.
    """
    start = time.perf_counter()
    job.directory.mkdir(parents=True)
    try:
        with local_file(job.url, limits.memory) as path:
            key = _key(path, settings) if cache else None
            known = cache.get(key) if cache and key else None
            if known:
                return _earlier(known, job)
            end = examine_isolated(path, job, settings, limits, stop)
            if cache and key and end.status == "done":
                files = {name: (job.directory / name).read_bytes() for name in RESULTS}
                cache.put(key, {**files, END: json.dumps(asdict(end)).encode()})
            return end
    except GpswbError as error:
        return End("refused", one_line(str(error)), time.perf_counter() - start)


def _key(path: Path, settings: Settings) -> str | None:
    """The name of the results in a cache; None where the part can't be read."""
    try:
        return Cache.key(path, settings.kernel, {"what": "part", "settings": settings.plain()})
    except OSError:
        return None


def _earlier(files: Mapping[str, bytes], job: Job) -> End:
    """Write the results of an earlier run, which may have had the same part elsewhere."""
    document = json.loads(files["result.json"])
    document["source"]["path"] = printable(job.url)
    write_result(job.directory / "result.json", document)
    (job.directory / "labels.npz").write_bytes(files["labels.npz"])
    return replace(End(**json.loads(files[END])), cached=True)
