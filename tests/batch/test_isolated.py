# SPDX-License-Identifier: LGPL-2.1-or-later
"""Crashes, hangs and hunger of one part are its end, not that of the others."""

import faulthandler
import json
import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest
from made_blocks import SETTINGS, make_blocks

from gpswb.batch.isolated import end_child, end_of
from gpswb.batch.job import End, Job, Limits
from gpswb.batch.local import run_local
from gpswb.batch.one_job import do_job

PLENTY = Limits(120, 6 * 10**9)


def crash(number: signal.Signals) -> None:
    faulthandler.disable()  # pytest's own would print a page
    os.kill(os.getpid(), number)


def hang(deaf: bool) -> None:
    if deaf:
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
    time.sleep(60)


def job(tmp_path: Path, name: str = "part.step") -> Job:
    path = tmp_path / name
    path.write_bytes(b"nothing")
    return Job(str(path), name, tmp_path / "out" / name)


def test_crashed_child_says_by_what(tmp_path: Path) -> None:
    child = multiprocessing.get_context("fork").Process(target=crash, args=(signal.SIGSEGV,))
    child.start()
    child.join()
    end = end_of(child, job(tmp_path), PLENTY, 1.0)
    assert (end.status, end.message) == ("crashed", "the process was ended by SIGSEGV")


@pytest.mark.parametrize("deaf", [False, True])
def test_child_out_of_time_is_ended(tmp_path: Path, deaf: bool) -> None:
    child = multiprocessing.get_context("fork").Process(target=hang, args=(deaf,))
    child.start()
    end = end_of(child, job(tmp_path), Limits(2, 10**9), 2.5)
    assert (end.status, end.message) == ("timeout", "not done after 2 s")
    end_child(child)
    assert not child.is_alive()


def test_each_file_gets_its_end(tmp_path: Path) -> None:
    jobs = [job(tmp_path, name) for name in ("a.step", "b.brep", "c.txt")]
    ends = {j.name: end for j, end in run_local(jobs, SETTINGS, PLENTY, None, 2)}
    assert set(ends) == {"a.step", "b.brep", "c.txt"}
    assert {end.status for end in ends.values()} == {"refused"}
    # The row names the file; its message doesn't again.
    assert not any(str(tmp_path) in end.message for end in ends.values())


def test_limits_hold_in_a_real_child(tmp_path: Path) -> None:
    path = next(make_blocks(tmp_path, 1).rglob("*.off"))

    def ends(name: str, limits: Limits) -> End:
        job = Job(str(path), name, tmp_path / name)
        return do_job(job, SETTINGS, limits, None, threading.Event())

    assert ends("a", Limits(1e-3, 10**9)).status == "timeout"
    # Less than Python and numpy take to start with.
    assert ends("b", Limits(60, 10**6)).status in ("memory", "crashed")
    end = ends("c", PLENTY)
    assert end.status == "done"
    assert 0 < (end.cpu_s or 0) < 60
    assert 10 < (end.memory_mb or 0) < 6000
    result = json.loads((tmp_path / "c" / "result.json").read_text("utf-8"))
    assert result["source"]["path"] == str(path)


ORPHAN = """
import os, sys, threading, time
from pathlib import Path
from gpswb.batch import child, isolated
from gpswb.batch.job import Job, Limits
from gpswb.batch.settings import Settings
from gpswb.cad.density import Density

def hang(*words):
    threading.Thread(target=child.follow_parent, daemon=True).start()
    print(os.getpid(), flush=True)
    time.sleep(60)

if __name__ == "__main__":
    isolated.examine_in_child = hang
    out = Path(sys.argv[1])
    out.mkdir()
    settings = Settings(Density("auto"), "robust", "curvature", "ocp")
    job, limits = Job(__file__, "x", out), Limits(60, 10**9)
    isolated.examine_isolated(Path(__file__), job, settings, limits, threading.Event())
"""


def test_a_killed_run_leaves_no_child(tmp_path: Path) -> None:
    script = tmp_path / "run.py"
    script.write_text(ORPHAN)
    words = [sys.executable, str(script), str(tmp_path / "out")]
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as run:
        assert run.stdout is not None
        child = int(run.stdout.readline())
        run.kill()
    deadline = time.monotonic() + 20
    while Path(f"/proc/{child}").exists() and time.monotonic() < deadline:
        time.sleep(0.05)
    assert not Path(f"/proc/{child}").exists()
