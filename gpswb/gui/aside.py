# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work in a thread, for what must be done in slices between which the window lives."""

from __future__ import annotations

import gc
from collections.abc import Callable, Generator
from concurrent.futures import ThreadPoolExecutor, wait
from typing import TypeVar

_LOOK_S = 0.01
"""Between two looks whether it is done."""
T = TypeVar("T")


def aside(work: Callable[[], T]) -> Generator[None, None, T]:
    """What ``work`` returns or raises: ``found = yield from aside(work)``.

    It pays for numpy and zlib, which let other threads run. Python's collector rests meanwhile: it
    runs in whatever thread makes objects, and what it finds may be panels, which Qt lets go in the
    window's thread only.

    Args:
        work: must not touch a document, nor the window.
    """
    collecting = gc.isenabled()
    gc.disable()
    try:
        with ThreadPoolExecutor(1) as pool:
            future = pool.submit(work)
            while not wait([future], _LOOK_S).done:
                yield
            return future.result()
    finally:
        if collecting:
            gc.enable()
