# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results appear whole or not at all."""

import subprocess
import sys
from pathlib import Path

import pytest

from gpswb.errors import OutputError
from gpswb.io.whole import whole_directory, write_whole

OWNED = ("a.txt", "b.txt", "parts")


def fill(out: Path, **files: str) -> None:
    with whole_directory(out, OWNED) as draft:
        for name, text in files.items():
            (draft / f"{name}.txt").write_text(text)


def listing(directory: Path) -> dict[str, str]:
    return {
        str(p.relative_to(directory)): p.read_text() for p in directory.rglob("*") if p.is_file()
    }


def test_new_directory_with_parents(tmp_path: Path) -> None:
    fill(tmp_path / "x" / "y", a="1")
    assert listing(tmp_path) == {"x/y/a.txt": "1"}


def test_own_files_are_renewed_and_foreign_ones_stay(tmp_path: Path) -> None:
    out = tmp_path / "out"
    fill(out, a="old", b="old")
    (out / "notes.txt").write_text("mine")
    fill(out, a="new")
    assert listing(tmp_path) == {"out/a.txt": "new", "out/notes.txt": "mine"}


def test_directories_are_replaced_whole(tmp_path: Path) -> None:
    out = tmp_path / "out"
    for name in ("one", "two"):
        with whole_directory(out, OWNED) as draft:
            (draft / "parts").mkdir()
            (draft / "parts" / name).write_text(name)
    assert listing(tmp_path) == {"out/parts/two": "two"}


@pytest.mark.parametrize("error", [ValueError, KeyboardInterrupt, OSError])
def test_failure_leaves_what_was_there(tmp_path: Path, error: type[BaseException]) -> None:
    out = tmp_path / "out"
    fill(out, a="old")
    expected = OutputError if error is OSError else error

    def break_off() -> None:
        with whole_directory(out, OWNED) as draft:
            (draft / "a.txt").write_text("half")
            raise error

    with pytest.raises(expected):
        break_off()
    assert listing(tmp_path) == {"out/a.txt": "old"}


def test_failure_leaves_no_new_directory(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="broken"), whole_directory(tmp_path / "x/y/z", OWNED):
        raise ValueError("broken")
    assert list(tmp_path.iterdir()) == []


def test_file_in_the_way(tmp_path: Path) -> None:
    (tmp_path / "out").write_text("a file")
    with pytest.raises(OutputError, match="it is a file"):
        fill(tmp_path / "out", a="1")
    with pytest.raises(OutputError, match="can't write"):
        fill(tmp_path / "out" / "below", a="1")
    assert listing(tmp_path) == {"out": "a file"}


def test_no_space_left(tmp_path: Path) -> None:
    # A limit on the size of files is what a full disk looks like to a program.
    out = tmp_path / "out"
    fill(out, a="old")
    script = f"""
import resource
from pathlib import Path
from gpswb.errors import OutputError
from gpswb.io.whole import whole_directory
resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))
try:
    with whole_directory(Path({str(out)!r}), ("a.txt",)) as draft:
        (draft / "a.txt").write_text("x" * 5000)
except OutputError as error:
    print(error)
"""
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == f"can't write {out}: File too large"
    assert listing(tmp_path) == {"out/a.txt": "old"}


def test_one_file_whole_or_not_at_all(tmp_path: Path) -> None:
    write_whole(tmp_path / "a.md", "ä")
    assert (tmp_path / "a.md").read_text(encoding="utf-8") == "ä"
    with pytest.raises(OutputError, match="can't write"):
        write_whole(tmp_path / "missing" / "a.md", "x")
    (tmp_path / "d").mkdir()
    with pytest.raises(OutputError, match="can't write"):
        write_whole(tmp_path / "d", "x")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a.md", "d"]
