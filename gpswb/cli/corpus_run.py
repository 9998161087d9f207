# SPDX-License-Identifier: LGPL-2.1-or-later
"""All files of a corpus, one after the other or several at once."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

from gpswb.batch.cache import Cache
from gpswb.batch.job import End, Job, Limits
from gpswb.batch.local import run_local
from gpswb.batch.settings import Settings
from gpswb.batch.source import CAD, find_parts, unique_name
from gpswb.cli.progress import count_bar
from gpswb.errors import InputError
from gpswb.validation.corpus import PartRow


def examine_all(
    files: Sequence[Path],
    draft: Path,
    settings: Settings,
    limits: Limits,
    cached: bool,
    parallel: int,
) -> list[PartRow]:
    """Examine every file in a process of its own, its results in ``draft/parts``.

    Returns:
        Rows in the order of the files. The largest files start first: none is left over at the end.
    """
    taken: set[str] = set()
    names = [unique_name(path.name, taken) for path in files]
    jobs = [
        Job(str(path), name, draft / "parts" / name)
        for path, name in zip(files, names, strict=True)
    ]
    cache = Cache.of_user() if cached else None
    rows: dict[Job, PartRow] = {}
    large_first = sorted(jobs, key=lambda job: -Path(job.url).stat().st_size)
    with count_bar(len(jobs), "part") as step:
        for job, end in run_local(large_first, settings, limits, cache, parallel):
            rows[job] = _row(job, end)
            step(job.name)
    return [rows[job] for job in jobs]


def _row(job: Job, end: End) -> PartRow:
    result = job.directory / "result.json"
    document = json.loads(result.read_text("utf-8")) if end.status == "done" else {}
    return PartRow(job.name, end.status, end.message, document, end.seconds)


def collect(paths: Sequence[Path]) -> list[Path]:
    """The files named, and those with a CAD ending in the directories named, sorted by path.

    Raises:
        InputError: a path does not exist, or there is no file at all.
    """
    files: list[Path] = []
    for path in paths:
        if path.is_dir():
            files += [Path(part.url) for part in find_parts(str(path), CAD)]
        elif path.is_file():
            files.append(path)
        else:
            raise InputError(f"{path}: no such file or directory")
    unique = list(dict.fromkeys(files))
    if not unique:
        raise InputError(f"no STEP, BREP or FCStd file in {', '.join(map(str, paths))}")
    return unique
