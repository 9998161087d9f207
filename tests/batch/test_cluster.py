# SPDX-License-Identifier: LGPL-2.1-or-later
"""A real Dask scheduler and its workers, one of them killed in the midst of its work."""

import contextlib
import json
import os
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from unittest.mock import Mock

import pandas as pd
import pytest
from made_blocks import SETTINGS, make_blocks

from gpswb.batch.cluster import run_on_cluster
from gpswb.batch.job import End, Job, Limits
from gpswb.batch.record import decode
from gpswb.batch.source import find_parts
from gpswb.errors import InputError


@contextlib.contextmanager
def dask(program: str, *words: str) -> Iterator["subprocess.Popen[bytes]"]:
    command = [sys.executable, "-m", f"distributed.cli.dask_{program}", "--no-dashboard", *words]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
        try:
            yield process
        finally:
            process.terminate()


@contextlib.contextmanager
def scheduler_at(said: Path) -> Iterator["tuple[subprocess.Popen[bytes], str]"]:
    """A scheduler on loopback and its address, which workers find in the file ``said``."""
    words = ("--host", "127.0.0.1", "--port", "0", "--scheduler-file", str(said))
    with dask("scheduler", *words) as process:
        deadline = time.monotonic() + 60
        while not said.exists() and time.monotonic() < deadline:
            time.sleep(0.05)
        yield process, json.loads(said.read_text())["address"]


def joining(said: Path) -> tuple[str, ...]:
    return ("--scheduler-file", str(said), "--nthreads", "1", "--host", "127.0.0.1")


def batch(root: Path, out: Path, address: str) -> list[str]:
    words = [sys.executable, "-m", "gpswb", "batch", str(root), "--out", str(out)]
    return [*words, "--method", "curvature", "--no-cache", "--scheduler", address]


def children(pid: int) -> set[int]:
    """All processes below one."""
    parent = {}
    for status in Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(OSError):
            parent[int(status.parent.name)] = int(status.read_text().rpartition(")")[2].split()[1])
    below, new = set(), {pid}
    while new:
        new = {child for child, mother in parent.items() if mother in new}
        below |= new
    return below


def entries(record: Path) -> list[dict]:
    lines = record.read_bytes().splitlines(keepends=True) if record.exists() else []
    return [entry for line in lines if (entry := decode(line)) and "part" in entry]


def test_a_killed_worker_costs_no_part_and_doubles_none(tmp_path: Path) -> None:
    root, out, said = make_blocks(tmp_path, 12), tmp_path / "out", tmp_path / "scheduler.json"
    # The first under its nanny, as `dask worker` starts it; the second is the worker itself.
    with (
        scheduler_at(said) as (_, address),
        dask("worker", *joining(said)),
        dask("worker", *joining(said), "--no-nanny") as victim,
    ):
        words = batch(root, out, address)
        with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as run:
            deadline = time.monotonic() + 120
            while not children(victim.pid) and time.monotonic() < deadline:
                time.sleep(0.01)  # until it examines a part
            orphans = children(victim.pid)
            assert orphans
            assert len(entries(out / "record.jsonl")) < 12
            os.kill(victim.pid, signal.SIGKILL)
            printed, _ = run.communicate(timeout=200)
        assert run.returncode == 0
    assert "12 of 12 parts: 12 done" in printed
    names = [part.name for part in find_parts(str(root), (".off",))]
    recorded = Counter(entry["part"] for entry in entries(out / "record.jsonl"))
    assert recorded == Counter(names)
    table = pd.read_parquet(out / "summary.parquet")
    assert table["part"].tolist() == names
    assert table["planar_area"].gt(0).all()
    for name in names:
        assert json.loads((out / "parts" / name / "result.json").read_text())["regions"]
    # The killed worker's own children have gone, too.
    deadline = time.monotonic() + 20
    while any(Path(f"/proc/{pid}").exists() for pid in orphans) and time.monotonic() < deadline:
        time.sleep(0.1)
    assert not any(Path(f"/proc/{pid}").exists() for pid in orphans)


def test_a_killed_scheduler_ends_the_run_in_one_line(tmp_path: Path) -> None:
    root, out, said = make_blocks(tmp_path, 12), tmp_path / "out", tmp_path / "scheduler.json"
    with scheduler_at(said) as (scheduler, address), dask("worker", *joining(said)):
        words = batch(root, out, address)
        with subprocess.Popen(words, stderr=subprocess.PIPE, text=True) as run:
            deadline = time.monotonic() + 120
            while not entries(out / "record.jsonl") and time.monotonic() < deadline:
                time.sleep(0.01)
            scheduler.kill()
            _, complaint = run.communicate(timeout=100)
    assert run.returncode == 1
    assert complaint.startswith("gpswb: the scheduler at tcp://")
    assert complaint.count("\n") == 1
    here = subprocess.run(words[:-2], capture_output=True, text=True, check=True)
    assert "12 of 12 parts: 12 done" in here.stdout


def test_a_scheduler_that_dies_between_two_parts_is_not_taken_for_a_full_disk(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # Asked anew, it doesn't answer: an OSError like one of writing results.
    monkeypatch.setattr("gpswb.batch.cluster.PATIENCE", 20)
    monkeypatch.setattr("distributed.Client.nthreads", unanswered := Mock(side_effect=[{"w": 1}]))
    root, said = make_blocks(tmp_path, 2), tmp_path / "scheduler.json"
    jobs = [
        Job(part.url, part.name, tmp_path / "work" / part.name)
        for part in find_parts(str(root), (".off",))
    ]
    with scheduler_at(said) as (_, address), dask("worker", *joining(said)):
        runs = run_on_cluster(jobs, SETTINGS, Limits(60, 10**9), False, address)
        assert next(runs)[1].status == "done"
        unanswered.side_effect = OSError(f"Timed out trying to connect to {address} after 60 s")
        with pytest.raises(InputError, match=f"the scheduler at {address} has gone"):
            next(runs)


def test_no_scheduler_and_no_worker_are_said(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def ends(where: str) -> list[tuple[Job, End]]:
        job = Job("a.step", "a.step", tmp_path / "a")
        return list(run_on_cluster([job], SETTINGS, Limits(60, 10**9), False, where))

    monkeypatch.setattr("gpswb.batch.cluster.PATIENCE", 1)
    with pytest.raises(InputError, match="no scheduler answers at tcp:"):
        ends("tcp://127.0.0.1:9")
    said = tmp_path / "scheduler.json"
    with scheduler_at(said) as (_, address), pytest.raises(InputError, match="has no worker"):
        ends(address)
