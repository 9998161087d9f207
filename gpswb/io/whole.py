# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results that appear whole or not at all (design, section 10)."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from gpswb.errors import OutputError
from gpswb.sentence import Sentence


@contextmanager
def whole_directory(out: Path, owned: tuple[str, ...]) -> Iterator[Path]:
    """Yield a new directory beside ``out``; move what it holds into ``out`` when the block ends.

    If the block raises, ``out`` stays as it was. Files of ours that an earlier run left in ``out``
    and this one did not write are removed; files of others stay.

    Args:
        out: the directory to fill; made, with its parents, if it is missing.
        owned: names that we write in ``out``.

    Raises:
        OutputError: ``out`` is a file, or can't be written.
    """
    if out.exists() and not out.is_dir():
        raise OutputError(Sentence("can't write {path}: it is a file, not a directory", path=out))
    out = out.absolute()
    made = _make_parents(out)
    try:
        draft = Path(tempfile.mkdtemp(prefix=f".{out.name}.", dir=out.parent))
    except OSError as error:
        _remove(made)
        raise _unwritable(out, error) from error
    try:
        yield draft
        _publish(draft, out, owned)
    except BaseException as error:
        shutil.rmtree(draft, ignore_errors=True)
        _remove(made)
        if isinstance(error, OSError):
            raise _unwritable(out, error) from error
        raise
    shutil.rmtree(draft, ignore_errors=True)


@contextmanager
def whole_file(path: Path) -> Iterator[Path]:
    """Yield a new file beside ``path`` that takes its place when the block ends well.

    Raises:
        OutputError: it can't be written.
    """
    draft = None
    try:
        handle, draft = tempfile.mkstemp(prefix=f".{path.name}.", dir=path.parent)
        os.close(handle)
        yield Path(draft)
        _open_up(Path(draft), 0o666)
        Path(draft).replace(path)
    except BaseException as error:
        if draft:
            Path(draft).unlink(missing_ok=True)
        if isinstance(error, OSError):
            raise _unwritable(path, error) from error
        raise


def write_whole(path: Path, text: str) -> None:
    """Write one text file, UTF-8, whole or not at all.

    Raises:
        OutputError: it can't be written.
    """
    with whole_file(path) as draft:
        draft.write_text(text, encoding="utf-8")


def _publish(draft: Path, out: Path, owned: tuple[str, ...]) -> None:
    _open_up(draft, 0o777)
    if not out.exists():
        draft.rename(out)
        return
    new = {entry.name for entry in draft.iterdir()}
    old = Path(tempfile.mkdtemp(prefix=f".{out.name}.old.", dir=out.parent))
    kept = [name for name in sorted(new.union(owned)) if (out / name).exists()]
    moved: list[str] = []
    try:
        for name in kept:
            (out / name).rename(old / name)
        for name in sorted(new):
            (draft / name).rename(out / name)
            moved.append(name)
    except OSError:
        for name in moved:
            (out / name).rename(draft / name)
        for entry in old.iterdir():
            entry.rename(out / entry.name)
        raise
    finally:
        shutil.rmtree(old, ignore_errors=True)


def _open_up(path: Path, mode: int) -> None:
    """Give what `tempfile` made for us alone the rights of an ordinary file."""
    mask = os.umask(0)
    os.umask(mask)
    path.chmod(mode & ~mask)


def _make_parents(out: Path) -> list[Path]:
    missing = [parent for parent in (out.parent, *out.parent.parents) if not parent.exists()]
    try:
        out.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        _remove(missing)
        raise _unwritable(out, error) from error
    return missing


def _remove(directories: list[Path]) -> None:
    for directory in directories:
        try:
            directory.rmdir()
        except OSError:
            return


def _unwritable(path: Path, error: OSError) -> OutputError:
    return OutputError(
        Sentence("can't write {path}: {why}", path=path, why=error.strerror or error)
    )
