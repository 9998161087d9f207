# SPDX-License-Identifier: LGPL-2.1-or-later
"""An unchanged part is not examined again; a changed, damaged or forgotten one is."""

import json
import multiprocessing
import os
import random
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from made_blocks import make_blocks

import gpswb
from gpswb.batch.cache import Cache
from gpswb.batch.fingerprint import fingerprint
from gpswb.cli.main import main

FILES = {"result.json": b"{}" * 500, "labels.npz": bytes(range(256)) * 8}
KEY = "0" * 64


@pytest.fixture
def cache(tmp_path: Path) -> Cache:
    return Cache(tmp_path / "cache")


def noise(seed: int, count: int = 20_000) -> bytes:
    return random.Random(seed).randbytes(count)


def test_what_was_put_is_got(cache: Cache) -> None:
    assert cache.get(KEY) is None
    cache.put(KEY, FILES)
    assert cache.get(KEY) == FILES
    assert cache.usage()[0] == 1
    assert cache.clear()[0] == 1
    assert cache.get(KEY) is None
    assert cache.usage() == (0, 0)


def test_the_key_follows_content_ending_settings_and_kernel(tmp_path: Path) -> None:
    paths = [tmp_path / name for name in ("a.step", "b.step", "c.stp", "d.step")]
    for path, content in zip(paths, (b"one", b"one", b"one", b"two"), strict=True):
        path.write_bytes(content)
    a, same, ending, content = (Cache.key(path, "ocp", {"n": 1}) for path in paths)
    os.utime(paths[0], (1, 1))
    assert Cache.key(paths[0], "ocp", {"n": 1}) == a == same
    others = {ending, content, Cache.key(paths[0], "ocp", {"n": 2})}
    others.add(Cache.key(paths[0], "freecad", {"n": 1}))
    assert len(others | {a}) == 5


def test_the_fingerprint_follows_the_code(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "core").mkdir()
    monkeypatch.setattr(gpswb, "__file__", str(tmp_path / "__init__.py"))
    seen = set()
    for name, text in (("core/a.py", "x"), ("core/a.py", "y"), ("core/b.py", "y")):
        (tmp_path / name).write_text(text)
        seen.add(fingerprint.__wrapped__("ocp"))
    assert len(seen) == 3


def test_every_damaged_entry_is_noticed(cache: Cache) -> None:
    cache.put(KEY, FILES)
    (path,) = cache.directory.glob("??/*")
    whole = path.read_bytes()
    for damaged in (
        *(whole[:cut] for cut in (0, 10, 32, len(whole) // 2, len(whole) - 1)),
        *(whole[:i] + bytes([whole[i] ^ 1]) + whole[i + 1 :] for i in range(0, len(whole), 7)),
    ):
        path.write_bytes(damaged)
        assert cache.get(KEY) is None
        assert not path.exists()


def test_the_size_is_bounded_and_the_used_stay(tmp_path: Path) -> None:
    most = 210_000
    keys = [f"{i:064x}" for i in range(10)]
    for i, key in enumerate(keys):
        Cache(tmp_path, most).put(key, {"x": noise(i)})
        os.utime(tmp_path / key[:2] / key[2:], (i, i))
    assert Cache(tmp_path, most).get(keys[0]) == {"x": noise(0)}  # used last, although made first
    Cache(tmp_path, most).put("f" * 64, {"x": noise(99)})
    kept = [key for key in keys if Cache(tmp_path, most).get(key)]
    assert Cache(tmp_path, most).usage()[1] <= most
    assert keys[0] in kept
    assert kept[1:] == keys[-len(kept) + 1 :]
    assert len(kept) > 5


def test_a_cache_that_cannot_be_written_is_no_failure(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("in the way")
    cache = Cache(tmp_path / "file")
    cache.put(KEY, FILES)
    assert cache.get(KEY) is None


def hammer(directory: Path, seed: int) -> None:
    draw = random.Random(seed)
    for _ in range(150):
        cache, i = Cache(directory, 120_000), draw.randrange(8)
        key, action = f"{i:064x}", draw.random()
        if action < 0.5:
            cache.put(key, {"x": noise(i)})
        elif action < 0.52:
            cache.clear()
        elif (found := cache.get(key)) is not None and found != {"x": noise(i)}:
            os._exit(1)


def test_several_runs_may_share_it(tmp_path: Path) -> None:
    context = multiprocessing.get_context("fork")
    runs = [context.Process(target=hammer, args=(tmp_path, seed)) for seed in range(4)]
    for run in runs:
        run.start()
    for run in runs:
        run.join()
    assert [run.exitcode for run in runs] == [0] * 4


@pytest.fixture
def user(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Cache:
    """The user's cache, empty."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "home"))
    return Cache.of_user()


def batch(root: Path, out: Path, *words: str) -> pd.DataFrame:
    command = ["batch", str(root), "--out", str(out), "--method", "curvature", *words]
    assert main(command) == 0
    return pd.read_parquet(out / "summary.parquet").set_index("part")


def test_batch_takes_unchanged_parts_from_the_cache(tmp_path: Path, user: Cache) -> None:
    root = make_blocks(tmp_path, 3)
    assert not batch(root, tmp_path / "zero", "--no-cache")["cached"].any()
    assert user.usage() == (0, 0)
    first = batch(root, tmp_path / "one")
    assert not first["cached"].any()
    assert user.usage()[0] == 3
    (root / "1" / "block01.off").rename(root / "moved.off")
    (root / "0" / "block02.off").write_text((root / "0" / "block00.off").read_text() + "\n")
    damaged = next(user.directory.glob("??/*"))
    second = batch(root, tmp_path / "two")
    assert second["cached"].to_dict() == {
        "0/block00.off": True,
        "0/block02.off": False,
        "moved.off": True,
    }
    assert second.loc["moved.off", "cpu_s"] == first.loc["1/block01.off", "cpu_s"]
    result = json.loads((tmp_path / "two/parts/moved.off/result.json").read_text())
    assert result["source"]["path"] == str(root / "moved.off")
    before = json.loads((tmp_path / "one/parts/1/block01.off/result.json").read_text())
    assert {**result, "source": 0} == {**before, "source": 0}
    for name in ("vertices", "class"):
        with (
            np.load(tmp_path / "one/parts/1/block01.off/labels.npz") as one,
            np.load(tmp_path / "two/parts/moved.off/labels.npz") as two,
        ):
            assert np.array_equal(one[name], two[name])
    for entry in user.directory.glob("??/*"):
        entry.write_bytes(entry.read_bytes()[:-1])
    assert damaged.exists()
    third = batch(root, tmp_path / "three")
    assert not third["cached"].any()


def test_partition_takes_an_unchanged_part_from_the_cache(
    tmp_path: Path,
    user: Cache,
    capsys: pytest.CaptureFixture[str],
) -> None:
    part = next(make_blocks(tmp_path, 1).rglob("*.off"))

    def partition(out: str, *words: str) -> str:
        command = ["partition", str(part), "--out", str(tmp_path / out), "--method", "curvature"]
        assert main([*command, *words]) == 0
        return capsys.readouterr().out

    first, second = partition("a"), partition("b")
    assert "taken from the cache" not in first
    assert "taken from the cache" in second
    assert first.splitlines()[:-1] == second.splitlines()[:-3]
    names = {path.name for path in (tmp_path / "a").iterdir()}
    assert names == {path.name for path in (tmp_path / "b").iterdir()}
    for name in names:
        assert (tmp_path / "a" / name).read_bytes() == (tmp_path / "b" / name).read_bytes()
    assert "taken from the cache" not in partition("c", "--noise", "0.01")
    assert "taken from the cache" not in partition("d", "--no-cache")
    assert main(["cache", "show"]) == 0
    assert "2 results" in capsys.readouterr().out
    assert main(["cache", "clear"]) == 0
    assert "removed 2 results" in capsys.readouterr().out
    assert "taken from the cache" not in partition("e")
