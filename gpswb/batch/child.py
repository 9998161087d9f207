# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a part's own process does: examine it within its limits, write, say how it went."""

from __future__ import annotations

import json
import math
import multiprocessing
import os
import resource
import signal
import threading
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

from gpswb.batch.job import Job, Limits
from gpswb.batch.messages import internal_error, one_line
from gpswb.batch.settings import Settings
from gpswb.batch.source import printable
from gpswb.errors import GpswbError, KernelError

ANSWER = "answer.json"
"""Written last, in the job's directory: the fields of its `End` that the child knows."""


def examine_in_child(path: Path, job: Job, settings: Settings, limits: Limits) -> None:
    """Examine the part at ``path``, write its results and then `ANSWER`."""
    # Native code prints what it likes; only the parent speaks to the user.
    null = os.open(os.devnull, os.O_WRONLY)
    os.dup2(null, 1)
    os.dup2(null, 2)
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    resource.setrlimit(resource.RLIMIT_DATA, (limits.memory, limits.memory))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    # More than the wall time allows: it ends a hanging child whose parent was killed.
    cpu = math.ceil(limits.seconds) * (os.cpu_count() or 1)
    resource.setrlimit(resource.RLIMIT_CPU, (cpu, cpu))
    threading.Thread(target=follow_parent, daemon=True).start()
    said = _attempt(lambda: _examine(path, job, settings))
    # The row names the part already.
    said["message"] = said["message"].removeprefix(f"{path}: ").replace(str(path), job.name)
    each = [resource.getrusage(w) for w in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    said["cpu_s"] = round(sum(use.ru_utime + use.ru_stime for use in each), 3)
    said["memory_mb"] = round(max(use.ru_maxrss for use in each) * 1024 / 1e6, 1)
    draft = job.directory / (ANSWER + ".draft")
    draft.write_text(json.dumps(said), encoding="utf-8")
    draft.rename(job.directory / ANSWER)


def follow_parent() -> None:
    """End with the process that asked for this one, also where that was killed."""
    parent = multiprocessing.parent_process()
    assert parent is not None
    parent.join()
    os.kill(os.getpid(), signal.SIGTERM)


def _attempt(work: Callable[[], None]) -> dict[str, Any]:
    try:
        work()
    except KernelError as error:
        return {"status": "crashed", "message": one_line(str(error))}
    except GpswbError as error:
        return {"status": "refused", "message": one_line(str(error))}
    except MemoryError:
        return {"status": "memory", "message": "out of memory"}
    except Exception as error:  # noqa: BLE001 - one part's bug must not hide the other figures
        return {"status": "crashed", "message": internal_error(error)}
    return {"status": "done", "message": ""}


def _examine(path: Path, job: Job, settings: Settings) -> None:
    from gpswb.batch.one_part import examine
    from gpswb.io.labels_npz import write_labels
    from gpswb.io.result_json import result_document, write_result

    outcome = examine(path, settings)
    solid = replace(outcome.solid, source=printable(job.url))
    write_labels(job.directory / "labels.npz", outcome.partition, solid.facemap, solid.pointmap)
    document = result_document(solid, outcome.partition, outcome.validation)
    write_result(job.directory / "result.json", document)
