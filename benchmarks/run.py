# SPDX-License-Identifier: LGPL-2.1-or-later
"""All of ``./gps bench``: measure, compare with the committed ratios, renew docs/performance.md.

``python benchmarks/run.py 100k likelihood ...`` measures these only and compares them; they take
the place of the last run's, and ``--report`` renews the page from what there is. Exit code 1 if a
stage has become slower against its peer.
"""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
import time
from pathlib import Path
from statistics import median
from typing import Any

import ratios
from meshes import BUILD, ROOT, mesh_file
from performance_page import renew_page, tables

ROUNDS = {"10k": 3, "100k": 2, "1M": 1, "stl": 3, "noise": 1}
"""The cases and how often each is run; a case of many minutes tells as much the first time."""

OTHER_MODES = ("10k", "100k")
"""Cases on which the modes of the paper are timed."""

LIKELIHOOD, START = "likelihood", "start"
"""Scikit-learn's density estimate against ours; how long the command takes to say anything."""

PATIENCE = 3600
"""Seconds of wall time for one case."""

FIGURES = BUILD / "figures.json"

FREECAD = {
    "PYTHONPATH": "/usr/lib/freecad-python3/lib",
    "PATH": "/usr/bin:/bin",
    "OMP_NUM_THREADS": "1",
}


def main(only: list[str]) -> int:
    """Measure everything, or some of it; the exit code."""
    figures: dict[str, Any] = {"cases": {}, "density": None, "help_s": None}
    if only and FIGURES.exists():
        figures = json.loads(FIGURES.read_text("utf-8"))
    figures |= {"date": time.strftime("%Y-%m-%d"), "cpu": cpu()}
    for what in only or (*ROUNDS, LIKELIHOOD, START):
        say(what)
        if what == LIKELIHOOD:
            figures["density"] = answer([sys.executable, "benchmarks/density_peer.py"])
        elif what == START:
            figures["help_s"] = start_of_command()
        elif found := one_case(what):
            figures["cases"][what] = found
        FIGURES.write_text(json.dumps(figures, indent=1), encoding="utf-8")
    if only:
        print("\n".join(tables(figures)))
        return compare(all_ratios(figures))
    return report(figures)


def one_case(case: str) -> dict[str, Any] | None:
    """What was measured of one mesh; None if it takes too long."""
    mesh, rounds = str(mesh_file(case)), ROUNDS[case]
    say(f"{case}: gpswb and libigl, {rounds} rounds")
    found = answer([sys.executable, "benchmarks/measure.py", mesh, str(rounds)])
    if found is None:
        say(f"{case}: not done in {PATIENCE} s")
        return None
    say(f"{case}: FreeCAD")
    peer = ["/usr/bin/python3", "benchmarks/freecad_peer.py", mesh, str(rounds)]
    found["freecad"] = answer(peer, FREECAD)
    if case in OTHER_MODES:
        say(f"{case}: modes of the paper")
        found["other"] = answer([sys.executable, "benchmarks/measure.py", mesh, "0"])
    return dict(found)


def start_of_command() -> float:
    """CPU seconds of ``gpswb --help``; on an idle machine it takes as long."""

    def cpu_seconds() -> float:
        use = resource.getrusage(resource.RUSAGE_CHILDREN)
        return use.ru_utime + use.ru_stime

    before, rounds = cpu_seconds(), 10
    for _ in range(rounds):
        words = [sys.executable, "-m", "gpswb", "--help"]
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
    return (cpu_seconds() - before) / rounds


def report(figures: dict[str, Any]) -> int:
    """Compare with the committed ratios and renew what is committed; the exit code."""
    new = all_ratios(figures)
    code = compare(new)
    ratios.write(ratios.renewed(ratios.known(), new))
    renew_page(figures)
    say("renewed docs/performance.md, docs/images/performance.svg and benchmarks/ratios.json")
    return code


def compare(new: dict[str, float]) -> int:
    """Say which ratios are worse than the committed ones; the exit code."""
    worse = ratios.slower(ratios.known(), new)
    for line in worse:
        say(f"SLOWER {line}")
    return 1 if worse else 0


def all_ratios(figures: dict[str, Any]) -> dict[str, float]:
    """Every stage against its peer on the same mesh, by name."""
    found: dict[str, float] = {}
    for case, said in figures["cases"].items():
        libigl = median([run["libigl"] for run in said["runs"]])
        rows = {"whole": median([run["whole"] for run in said["runs"]]), **said["stages"]}
        for stage, seconds in rows.items():
            if seconds >= ratios.LEAST:
                found[f"{case}: {stage} / libigl"] = seconds / libigl
        if said["freecad"]:
            own = median([run["curvature alone"] for run in said["runs"]])
            found[f"{case}: curvature / FreeCAD"] = own / median(said["freecad"]["seconds"])
        if said.get("other") and said["other"]["pairs"]:
            pair = said["other"]["seconds"] / said["other"]["pairs"]
            found[f"{case}: a pair merged / a vertex of libigl"] = pair * said["vertices"] / libigl
    for d, said in (figures["density"] or {}).items():
        found[f"likelihood in {d}-D / scikit-learn"] = said["own"] / said["sklearn"]
    return found


def answer(words: list[str], environment: dict[str, str] | None = None) -> Any:
    """What a process of its own prints as JSON; None if it takes too long."""
    try:
        done = subprocess.run(
            words,
            cwd=ROOT,
            env=environment or os.environ,
            stdout=subprocess.PIPE,
            check=True,
            timeout=PATIENCE,
        )
    except subprocess.TimeoutExpired:
        return None
    return json.loads(done.stdout.splitlines()[-1])


def cpu() -> str:
    """The processor's name."""
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.partition(":")[2].strip()
    return "unknown processor"


def say(line: str) -> None:
    print(f"bench: {line}", flush=True)


if __name__ == "__main__":
    if sys.argv[1:] == ["--report"]:  # from the figures of the last run
        raise SystemExit(report(json.loads(FIGURES.read_text("utf-8"))))
    raise SystemExit(main(sys.argv[1:]))
