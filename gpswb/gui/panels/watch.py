# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work beside the window: poll a process, do long work on the document in slices, or both."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from typing import Any

from gpswb.errors import GpswbError
from gpswb.gui.compat import QtCore
from gpswb.gui.runs import Run

_POLL_MS = 100
_SLICE_S = 0.03
"""How long the document may be worked on before the window gets its turn."""


class Watch:
    """Waits for a run without holding up the window.

    Args:
        run: the process.
        done: called with its result.
        failed: called with the text of its error.
        progress: called with stage and share.
    """

    def __init__(
        self,
        run: Run,
        done: Callable[[Any], None],
        failed: Callable[[str], None],
        progress: Callable[[str, float], None] | None = None,
    ) -> None:
        self.run = run
        self._done, self._failed, self._progress = done, failed, progress
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._poll)
        self._timer.start(_POLL_MS)

    def _poll(self) -> None:
        told = self.run.progress
        if told is not None and self._progress is not None:
            self._progress(*told)
        if self.run.running:
            return
        self._timer.stop()
        try:
            result = self.run.result()
        except GpswbError as error:
            self.run.close()
            self._failed(str(error))
            return
        self._done(result)

    def stop(self) -> None:
        """End the process; nobody is called any more."""
        self._timer.stop()
        self.run.close()


class Slices:
    """Does work on the document in slices, between which the window lives.

    Args:
        work: iterated to its end.
        done: called then.
        failed: called with the text of its error.
    """

    def __init__(
        self, work: Iterator[None], done: Callable[[], None], failed: Callable[[str], None]
    ) -> None:
        self._work, self._done, self._failed = work, done, failed
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._slice)
        self._timer.start(0)

    def _slice(self) -> None:
        until = time.perf_counter() + _SLICE_S
        try:
            while time.perf_counter() < until:
                next(self._work)
        except StopIteration:
            self._timer.stop()
            self._done()
        except GpswbError as error:
            self._timer.stop()
            self._failed(str(error))

    def stop(self) -> None:
        """Leave the rest undone; nobody is called any more."""
        self._timer.stop()


class Change:
    """A run, and what it then changes in a document, in slices and as one step to undo.

    Args:
        run: the process; None where there is nothing to wait for.
        document: what is changed; ``title`` names the step.
        change: takes the run's result and is iterated to its end.
        done, failed: called then, or with the text of the error: the document is as it was.
        progress: called with stage and share of the run, and with ``CHANGING`` after it.
    """

    CHANGING = "change"

    def __init__(
        self,
        run: Run | None,
        document: Any,
        title: str,
        change: Callable[[Any], Iterator[None]],
        done: Callable[[], None],
        failed: Callable[[str], None],
        progress: Callable[[str, float], None],
    ) -> None:
        self.run = run
        self._document, self._title, self._change = document, title, change
        self._done, self._failed, self._progress = done, failed, progress
        self._work: Watch | Slices | None = None
        if run is None:
            self._ran(None)
        else:
            self._work = Watch(run, self._ran, self._fail, progress)

    def cancel(self) -> None:
        """End it; the document is as it was, and nobody is called any more."""
        changing = isinstance(self._work, Slices)
        self.stop()
        if changing:
            self._document.abortTransaction()

    def stop(self) -> None:
        """End it and leave the document alone, which may be gone; nobody is called any more."""
        if self._work is not None:
            self._work.stop()
        self._close()

    def _ran(self, result: Any) -> None:
        self._progress(self.CHANGING, 0.0)
        self._document.openTransaction(self._title)
        self._work = Slices(self._change(result), self._commit, self._abort)

    def _commit(self) -> None:
        self._document.commitTransaction()
        self._close()
        self._done()

    def _abort(self, why: str) -> None:
        self._document.abortTransaction()
        self._fail(why)

    def _fail(self, why: str) -> None:
        self._close()
        self._failed(why)

    def _close(self) -> None:
        self._work = None
        if self.run is not None:
            self.run.close()
