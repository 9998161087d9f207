# SPDX-License-Identifier: LGPL-2.1-or-later
"""The script ``gps`` and the pinned requirements."""

import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


def gps(*arguments, cwd=ROOT):
    return subprocess.run(
        [ROOT / "gps", *arguments], cwd=cwd, capture_output=True, text=True, check=False
    )


@pytest.mark.parametrize("arguments", [(), ("--help",)])
def test_usage_names_every_verb_and_suite(arguments):
    script = (ROOT / "gps").read_text()
    verbs = re.findall(r"^verb_(\w+)\(\)", script, re.MULTILINE)
    suites = re.findall(r"^suite_(\w+)\(\)", script, re.MULTILINE)
    shown = gps(*arguments)
    assert shown.returncode == 0
    assert verbs
    assert suites
    for word in (*verbs, *suites):
        assert re.search(rf"\b{word}\b", shown.stdout), word


@pytest.mark.parametrize(
    "arguments",
    [("no-such-verb",), ("run", "a.step", "b.step"), ("test", "no-such-suite"), ("bench", "x")],
)
def test_wrong_usage_ends_with_2_before_anything_is_done(arguments, tmp_path):
    ended = gps(*arguments, cwd=tmp_path)
    assert ended.returncode == 2
    assert ended.stdout == ""
    assert ended.stderr.startswith("gps: ")


def test_a_corpus_that_is_not_there_ends_with_1(tmp_path):
    ended = gps("corpus", "nowhere", cwd=tmp_path)
    assert ended.returncode == 1
    assert ended.stderr == f"gps: no directory {tmp_path}/nowhere/step\n"


def locked(file="requirements.txt"):
    """(name, version, hashes) of each package in a requirements file."""
    text = (ROOT / file).read_text()
    text = re.sub(r"^ *#.*\n", "", text, flags=re.MULTILINE).replace("\\\n", "")
    for line in text.splitlines():
        if line.strip():
            requirement, *options = line.split()
            name, _, version = requirement.partition("==")
            yield name, version, options


@pytest.mark.parametrize("file", ["requirements.txt", "requirements-bench.txt"])
def test_every_requirement_is_pinned_and_hashed_and_names_no_registry(file):
    packages = list(locked(file))
    assert len({name for name, _, _ in packages}) == len(packages) > 0
    for name, version, options in packages:
        assert re.fullmatch(r"[a-z0-9-]+", name), name
        assert re.fullmatch(r"[0-9.]+", version), name
        assert options, name
        assert all(re.fullmatch(r"--hash=sha256:[0-9a-f]{64}", o) for o in options), name


@pytest.mark.parametrize("name", ["requirements", "requirements-bench"])
def test_direct_requirements_are_locked_at_their_pins(name):
    pins = re.findall(r"^([\w-]+==\S+)", (ROOT / f"{name}.in").read_text(), re.MULTILINE)
    assert set(pins) <= {f"{package}=={version}" for package, version, _ in locked(f"{name}.txt")}


def test_what_is_compared_with_leaves_the_environment_as_it_is():
    pinned = {name: version for name, version, _ in locked()}
    for name, version, _ in locked("requirements-bench.txt"):
        assert pinned.get(name, version) == version


def test_one_package_owns_the_module_ocp():
    assert [
        n for n, _, _ in locked() if n.startswith("cadquery-ocp") and n != "cadquery-ocp-proxy"
    ] == ["cadquery-ocp"]
