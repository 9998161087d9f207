# SPDX-License-Identifier: LGPL-2.1-or-later
"""All files of a corpus, one after the other or several at once."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from gpswb.batch.isolated import Job, Limits, run_jobs
from gpswb.batch.settings import Settings
from gpswb.cli.progress import count_bar
from gpswb.errors import InputError
from gpswb.validation.corpus import PartRow

SUFFIXES = (".step", ".stp", ".p21", ".brep", ".brp", ".rle", ".fcstd")
"""Endings, in lower case, of the files that are taken from a directory."""


def examine_all(
    files: Sequence[Path], draft: Path, settings: Settings, limits: Limits, parallel: int
) -> list[PartRow]:
    """Examine every file in a process of its own, its results in ``draft/parts``.

    Returns:
        Rows in the order of the files. The largest files start first: none is left over at the end.
    """
    jobs = []
    taken: set[str] = set()
    for path in files:
        name, n = path.name, 2
        while name.lower() in taken:
            name, n = f"{path.name} ({n})", n + 1
        taken.add(name.lower())
        jobs.append(Job(path, name, draft / "parts" / name))
    rows: dict[Job, PartRow] = {}
    large_first = sorted(jobs, key=lambda job: -job.path.stat().st_size)
    with count_bar(len(jobs), "part") as step:
        for job, row in run_jobs(large_first, settings, limits, parallel):
            rows[job] = row
            step(job.name)
    return [rows[job] for job in jobs]


def collect(paths: Sequence[Path]) -> list[Path]:
    """The files named, and those with a CAD ending in the directories named, sorted by path.

    Raises:
        InputError: a path does not exist, or there is no file at all.
    """
    files: list[Path] = []
    for path in paths:
        if path.is_dir():
            try:
                inside = sorted(p for p in path.rglob("*") if p.suffix.lower() in SUFFIXES)
            except OSError as error:
                raise InputError(f"can't read {path}: {error.strerror or error}") from error
            files += [p for p in inside if p.is_file()]
        elif path.is_file():
            files.append(path)
        else:
            raise InputError(f"{path}: no such file or directory")
    unique = list(dict.fromkeys(files))
    if not unique:
        raise InputError(f"no STEP, BREP or FCStd file in {', '.join(map(str, paths))}")
    return unique
