# SPDX-License-Identifier: LGPL-2.1-or-later
"""Progress bars on stderr, only on a terminal, only where tqdm is installed."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any


def _tqdm() -> Any:
    if not sys.stderr.isatty():
        return None
    try:
        from tqdm import tqdm
    except ImportError:
        return None
    return tqdm


@contextmanager
def stage_bar() -> Iterator[Callable[[str, float], None] | None]:
    """Yield a callback (stage, share of it done) that moves a bar, or None without a terminal."""
    tqdm = _tqdm()
    if tqdm is None:
        yield None
        return
    with tqdm(total=100, bar_format="{desc:<12} {bar} {percentage:3.0f}% {elapsed}", leave=False,
              file=sys.stderr) as bar:  # fmt: skip

        def move(stage: str, share: float) -> None:
            bar.set_description_str(stage, refresh=False)
            bar.n = round(100 * share)
            bar.refresh()

        yield move


@contextmanager
def count_bar(total: int, unit: str, done: int = 0) -> Iterator[Callable[[str], None]]:
    """Yield a callback that counts one more thing done, named by its argument.

    ``done`` of them are done already: they don't count in the rate.
    """
    tqdm = _tqdm()
    if tqdm is None:
        yield lambda _name: None
        return
    with tqdm(total=total, initial=done, unit=unit, leave=False, file=sys.stderr) as bar:

        def step(name: str) -> None:
            bar.set_postfix_str(name, refresh=False)
            bar.update()

        yield step
