# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exit codes and messages: 2 wrong usage, 1 an input that can't be processed, one line each."""

import subprocess
import sys
from pathlib import Path

import pytest
from conftest import Command

import gpswb as package
from gpswb.batch.messages import one_line
from gpswb.cli.main import main


@pytest.mark.parametrize(
    "words",
    [
        [],
        ["dance"],
        ["partition"],
        ["partition", "a.step"],
        ["partition", "a.step", "--out", "x", "--density", "huge"],
        ["partition", "a.step", "--out", "x", "--noise", "-1"],
        ["partition", "a.step", "--out", "x", "--noise", "nan"],
        ["validate", "--out", "x"],
        ["validate", "a", "--out", "x", "--jobs", "0"],
        ["batch", "a"],
        ["batch", "a", "--out", "x", "--shard", "0/3"],
        ["batch", "a", "--out", "x", "--shard", "4/3"],
        ["sweep", "a.step"],
        ["sweep", "a.step", "--densities", "coarse,,fine"],
    ],
)
def test_wrong_usage_is_2(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(words) == 2
    assert "usage: gpswb" in capsys.readouterr().err


def test_help_and_version_are_0(capsys: pytest.CaptureFixture[str]) -> None:
    for verb in ("partition", "validate", "sweep", "batch"):
        assert main([verb, "--help"]) == 0
        assert verb in capsys.readouterr().out
    assert main(["--version"]) == 0
    assert capsys.readouterr().out == f"gpswb {package.__version__}\n"


def test_help_needs_nothing_heavy() -> None:
    script = (
        "import sys; from gpswb.cli.main import main; main(['--help']);"
        "print(sorted({'numpy', 'scipy', 'OCP', 'matplotlib', 'tqdm', 'dask', 'fsspec', 'pyarrow'}"
        "& set(sys.modules)))"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    assert done.stdout.splitlines()[-1] == "[]"


STEP = b"ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=CARTESIAN_POINT('',(0.,0.,0.));\n"


@pytest.mark.parametrize(
    ("name", "content", "says"),
    [
        ("text.step", b"hello\n", "not a STEP file"),
        ("truncated.step", STEP, "truncated"),
        ("empty.step", b"", "empty"),
        ("absent.step", None, "no such file"),
        ("part.dwg", b"0 0 0\n", "unknown format"),
        ("a\x1b[31mred\nname.step", b"hello\n", "not a STEP file"),
        ("empty.stl", b"", "empty.stl"),
        ("nan.off", b"OFF\n3 1 0\n0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n", "not finite"),
    ],
    ids=["text", "truncated", "empty", "absent", "unknown", "hostile name", "stl", "nan"],
)
def test_bad_input_is_1_with_one_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], name: str, content: bytes | None, says: str
) -> None:
    path = tmp_path / name
    if content is not None:
        path.write_bytes(content)
    before = sorted(tmp_path.iterdir())
    assert main(["partition", str(path), "--out", str(tmp_path / "new" / "out")]) == 1
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.startswith("gpswb: ")
    assert said.err.count("\n") == 1
    assert says in said.err
    assert "\x1b" not in said.err
    assert sorted(tmp_path.iterdir()) == before


def test_no_file_without_faces_is_partitioned(tmp_path: Path, gpswb: Command) -> None:
    path = tmp_path / "point.step"
    path.write_bytes(STEP + b"ENDSEC;\nEND-ISO-10303-21;\n")
    done = gpswb("partition", path, "--out", tmp_path / "out")
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.startswith("gpswb: ")
    assert done.stderr.count("\n") == 1
    assert list(tmp_path.iterdir()) == [path]


def test_nothing_to_validate(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["validate", str(tmp_path / "absent"), "--out", str(tmp_path / "out")]) == 1
    assert "no such file or directory" in capsys.readouterr().err
    (tmp_path / "corpus").mkdir()
    assert main(["validate", str(tmp_path / "corpus"), "--out", str(tmp_path / "out")]) == 1
    assert "no STEP, BREP or FCStd file" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_lines_from_files_are_tamed() -> None:
    assert one_line("a\nb\x1b[2J\u202e c\t d") == "a b [2J c d"
