# SPDX-License-Identifier: LGPL-2.1-or-later
"""Times of the stages of a pipeline, and its reports of progress."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

Progress = Callable[[str, float], None]
"""Told the stage's name and the fraction of it that is done."""


class StageClock:
    """Seconds of each stage of one run."""

    def __init__(self, progress: Progress | None = None) -> None:
        self.timings: dict[str, float] = {}
        self._progress = progress

    def report(self, name: str, fraction: float) -> None:
        """Tell the listener, if there is one, how far a stage is."""
        if self._progress is not None:
            self._progress(name, fraction)

    @contextmanager
    def stage(self, name: str) -> Iterator[None]:
        """Time a stage and report its start and end; the same name adds up."""
        self.report(name, 0.0)
        start = time.perf_counter()
        yield
        self.timings[name] = self.timings.get(name, 0.0) + time.perf_counter() - start
        self.report(name, 1.0)
