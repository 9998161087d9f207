# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs go on where others were ended: nothing is lost, nothing is done twice."""

import contextlib
import json
import os
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Generator, Iterable
from pathlib import Path

import pandas as pd
import pytest
from made_blocks import SETTINGS, make_blocks

from gpswb.batch.columns import COLUMNS
from gpswb.batch.job import End, Job
from gpswb.batch.record import decode
from gpswb.batch.run import run_batch
from gpswb.batch.settings import Settings
from gpswb.batch.shard import Shard
from gpswb.batch.source import Part, find_parts
from gpswb.cad.density import Density
from gpswb.errors import InputError

OFF = (".off",)
DOCUMENT = {
    "source": {"sha256": "ab12", "unit": "mm"},
    "settings": {"sigma": 0.0},
    "mesh": {"density": "auto", "mesher": "none", "vertices": 8, "triangles": 12},
    "initial_region_count": 6,
    "regions": [{"class": "planar", "area": 2.0, "undecided": []}],
    "faces": [],
    "validation": None,
}


class Examiner:
    """Stands in for the pipeline: counts what it is asked for, and may be told to fail."""

    def __init__(self, stop_after: int = 10**9, bad: str = "") -> None:
        self.seen: Counter[str] = Counter()
        self.stop_after, self.bad = stop_after, bad

    def __call__(self, jobs: Iterable[Job]) -> Generator[tuple[Job, End]]:
        for job in jobs:
            if self.seen.total() == self.stop_after:
                raise KeyboardInterrupt
            self.seen[job.name] += 1
            job.directory.mkdir(parents=True)
            if self.bad and self.bad in job.name:
                yield job, End("timeout", "not done after 1 s", 1.0)
                continue
            (job.directory / "result.json").write_text(json.dumps(DOCUMENT))
            (job.directory / "labels.npz").write_text(job.name)
            yield job, End("done", "", 0.5, 0.25, 100.0)


def run(
    parts: list[Part],
    out: Path,
    examiner: Examiner,
    settings: Settings = SETTINGS,
    shard: Shard | None = None,
    retry: bool = False,
) -> pd.DataFrame:
    counted = contextlib.nullcontext(lambda name: None)
    run_batch(parts, out, settings, examiner, shard or Shard(), retry, lambda total, done: counted)
    table = pd.read_parquet(out / "summary.parquet")
    pd.testing.assert_frame_equal(table, pd.read_csv(out / "summary.csv"), check_dtype=False)
    return table


def test_an_ended_run_is_gone_on_with(tmp_path: Path) -> None:
    parts, out = find_parts(str(make_blocks(tmp_path, 9)), OFF), tmp_path / "out"
    first, second, third = Examiner(stop_after=4), Examiner(), Examiner()
    with pytest.raises(KeyboardInterrupt):
        run(parts, out, first)
    table = run(parts, out, second)
    assert first.seen + second.seen == Counter(part.name for part in parts)
    assert table["part"].tolist() == [part.name for part in parts]
    assert run(parts, out, third)["status"].eq("done").all()
    assert not third.seen
    for part in parts:
        assert (out / "parts" / part.name / "labels.npz").read_text() == part.name
    assert sorted(path.name for path in out.iterdir()) == [
        "parts", "record.jsonl", "summary.csv", "summary.parquet",
    ]  # fmt: skip


def test_changed_and_lost_parts_are_done_again(tmp_path: Path) -> None:
    root, out = make_blocks(tmp_path, 5), tmp_path / "out"
    run(find_parts(str(root), OFF), out, Examiner())
    changed, lost = find_parts(str(root), OFF)[1], find_parts(str(root), OFF)[3]
    os.utime(changed.url, (1, 1))
    (out / "parts" / lost.name / "result.json").unlink()
    again = Examiner()
    table = run(find_parts(str(root), OFF), out, again)
    assert set(again.seen) == {changed.name, lost.name}
    assert len(table) == 5


def test_failures_are_results_until_they_are_retried(tmp_path: Path) -> None:
    parts, out = find_parts(str(make_blocks(tmp_path, 5)), OFF), tmp_path / "out"
    table = run(parts, out, Examiner(bad="block02")).set_index("part")
    assert table.loc["0/block02.off", "status"] == "timeout"
    assert table.loc["0/block02.off", ["regions", "planar_area"]].isna().all()
    assert not (out / "parts" / "0" / "block02.off").exists()
    idle = Examiner()
    run(parts, out, idle)
    assert not idle.seen
    again = Examiner()
    table = run(parts, out, again, retry=True)
    assert list(again.seen) == ["0/block02.off"]
    assert table["status"].tolist() == ["done"] * 5


def test_shards_divide_the_parts_and_share_a_table(tmp_path: Path) -> None:
    parts, out = find_parts(str(make_blocks(tmp_path, 12)), OFF), tmp_path / "out"
    examiners = [Examiner() for _ in range(3)]
    for i, examiner in enumerate(examiners):
        table = run(parts, out, examiner, SETTINGS, Shard(i + 1, 3))
    assert sum((e.seen for e in examiners), Counter()) == Counter(part.name for part in parts)
    assert sum(bool(e.seen) for e in examiners) > 1
    assert len(table) == 12
    # A shard that another division had done already is left alone.
    whole = Examiner()
    run(parts, out, whole)
    assert not whole.seen


def test_other_settings_need_another_directory(tmp_path: Path) -> None:
    parts, out = find_parts(str(make_blocks(tmp_path, 2)), OFF), tmp_path / "out"
    run(parts, out, Examiner())
    other = Settings(Density("fine"), "robust", "curvature", "ocp")
    for shard in (Shard(), Shard(1, 2)):
        with pytest.raises(InputError, match="other settings"):
            run(parts, out, Examiner(), other, shard)


def test_no_part_leaves_no_type_behind(tmp_path: Path) -> None:
    table = run([], tmp_path / "out", Examiner())
    assert list(table.columns) == list(COLUMNS)
    assert len(table) == 0


def entries(path: Path) -> list[dict]:
    found = [decode(line) for line in path.read_bytes().splitlines(keepends=True)]
    assert None not in found
    return [entry for entry in found if "part" in entry]


def test_kill_9_loses_nothing_and_does_nothing_twice(tmp_path: Path) -> None:
    root, out = make_blocks(tmp_path, 8), tmp_path / "out"
    words = [sys.executable, "-m", "gpswb", "batch", str(root), "--out", str(out)]
    words += ["--method", "curvature", "--no-cache", "--jobs", "1"]
    record = out / "record.jsonl"
    with subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
        deadline = time.monotonic() + 120
        while process.poll() is None and time.monotonic() < deadline:
            if record.exists() and record.read_bytes().count(b"\n") >= 4:
                break
            time.sleep(0.005)
        process.send_signal(signal.SIGKILL)
    before = record.read_bytes()
    done = before[: before.rfind(b"\n") + 1]
    assert 3 <= len(entries(record)) < 8
    record.write_bytes(done + b'1234 {"part":"torn')
    finished = subprocess.run(words, capture_output=True, text=True, check=True)
    assert "8 of 8 parts: 8 done" in finished.stdout
    assert record.read_bytes().startswith(done)
    names = Counter(entry["part"] for entry in entries(record))
    assert names == Counter(part.name for part in find_parts(str(root), OFF))
    table = pd.read_parquet(out / "summary.parquet").set_index("part")
    # A block 1 x 1 x h has the area 2 + 4 h, all of it planar.
    heights = [1 + int(name[-6:-4]) for name in table.index]
    assert table["planar_area"].tolist() == pytest.approx([2 + 4 * h for h in heights])
