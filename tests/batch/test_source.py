# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts are found and fetched from directories and from file systems of fsspec."""

import os
import zipfile
from collections.abc import Iterator
from pathlib import Path

import fsspec
import pytest

from gpswb.batch.source import CAD, find_parts, local_file
from gpswb.errors import InputError

FILES = {"a/x.step": b"one", "a/b/y.STP": b"three", "z.brep": b"", "a/readme.txt": b"no"}
NAMES = ["a/b/y.STP", "a/x.step", "z.brep"]


@pytest.fixture
def places(tmp_path: Path) -> Iterator[list[str]]:
    root = tmp_path / "parts"
    for name, content in FILES.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_bytes(content)
    with zipfile.ZipFile(tmp_path / "parts.zip", "w") as archive:
        for name, content in FILES.items():
            archive.writestr(name, content)
            archive.writestr(f"inner/{name}", content)
    memory = fsspec.filesystem("memory")
    for name, content in FILES.items():
        memory.pipe(f"/bucket/{name}", content)
    yield [
        str(root),
        root.as_uri(),
        "memory://bucket",
        f"zip://inner::{tmp_path}/parts.zip",
        f"zip://inner::{(tmp_path / 'parts.zip').as_uri()}",
    ]
    memory.rm("/bucket", recursive=True)


def test_every_file_system_gives_the_same_parts(places: list[str]) -> None:
    for where in places:
        parts = find_parts(where, CAD)
        assert [part.name for part in parts] == NAMES, where
        assert [part.size for part in parts] == [len(FILES[name]) for name in NAMES]
        for part in parts:
            with local_file(part.url, 100) as path:
                assert path.read_bytes() == FILES[part.name]
                assert path.suffix.lower() == Path(part.name).suffix.lower()


def test_the_stamp_changes_with_the_file(places: list[str], tmp_path: Path) -> None:
    for where in places[:2]:
        before = find_parts(where, CAD)[1].stamp
        os.utime(tmp_path / "parts" / NAMES[1], (1, 1))
        assert find_parts(where, CAD)[1].stamp != before
        os.utime(tmp_path / "parts" / NAMES[1])
    before = find_parts(places[3], CAD)[1].stamp
    with zipfile.ZipFile(tmp_path / "other.zip", "w") as archive:
        archive.writestr("inner/a/b/y.STP", b"three")
        archive.writestr("inner/a/x.step", b"two")
    assert find_parts(f"zip://inner::{tmp_path}/other.zip", CAD)[1].stamp != before


def test_what_is_too_large_is_not_fetched(places: list[str]) -> None:
    url = find_parts(places[2], CAD)[0].url
    with pytest.raises(InputError, match="larger"), local_file(url, 4):
        pass


def test_names_of_a_hostile_archive_stay_inside(tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "evil.zip", "w") as archive:
        for name in ("../../up.step", "a/../../b.step", "./c.step", "d//e.step"):
            archive.writestr(name, b"x")
    for part in find_parts(f"zip://::{tmp_path}/evil.zip", CAD):
        inside = (tmp_path / "out" / part.name).resolve()
        assert inside.is_relative_to(tmp_path / "out")


def test_names_that_are_not_utf8_can_be_written(tmp_path: Path) -> None:
    (tmp_path / os.fsdecode(b"a\xff.step")).write_bytes(b"x")
    (part,) = find_parts(str(tmp_path), CAD)
    assert part.name.encode() == rb"a\xff.step"
    with local_file(part.url, 10) as path:
        assert path.read_bytes() == b"x"


@pytest.mark.parametrize(
    ("where", "says"),
    [
        ("/no/such/place", "no such file"),
        ("nosuch://place", "nosuch"),
        ("zip://::/no/such.zip", "can't read zip"),
    ],
)
def test_a_place_that_is_not_there(where: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        find_parts(where, CAD)
