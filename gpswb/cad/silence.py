# SPDX-License-Identifier: LGPL-2.1-or-later
"""Keep what native code writes to standard output away from the user."""

from __future__ import annotations

import contextlib
import ctypes
import os
import sys
from collections.abc import Iterator


@contextlib.contextmanager
def quiet() -> Iterator[None]:
    """Send standard output, at the level of the operating system, nowhere for a while."""
    sys.stdout.flush()
    flush = ctypes.CDLL(None).fflush
    flush(None)
    kept, nowhere = os.dup(1), os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)
    try:
        yield
    finally:
        # C and C++ keep text back: it must go while there is still nowhere to go.
        flush(None)
        os.dup2(kept, 1)
        os.close(kept)
        os.close(nowhere)
